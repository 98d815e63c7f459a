using System;

namespace Nowpose.Pairing
{
    /// <summary>What has happened since it was asked last.</summary>
    [Flags]
    enum PairingChange
    {
        None = 0,

        /// <summary>There is a question that was not there.</summary>
        Asked = 1,

        /// <summary>The cell in use is another one, or has another marker or token.</summary>
        Applied = 2,

        /// <summary>The gateway gave this headset a token.</summary>
        Paired = 4,

        /// <summary>There is a problem that was not there.</summary>
        Problem = 8,

        /// <summary>The cells are others than those that were loaded or saved.</summary>
        Kept = 16,

        /// <summary>The words are others.</summary>
        Words = 32,
    }
}
