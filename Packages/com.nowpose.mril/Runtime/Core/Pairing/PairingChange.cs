using System;

namespace Nowpose.Pairing
{
    /// <summary>Changes since the last tick.</summary>
    [Flags]
    enum PairingChange
    {
        None = 0,

        /// <summary>There is a new question to the wearer.</summary>
        Asked = 1,

        /// <summary>The cell in use has changed, or has another marker or token.</summary>
        Applied = 2,

        /// <summary>The gateway gave this headset a token.</summary>
        Paired = 4,

        /// <summary>There is a new problem.</summary>
        Problem = 8,

        /// <summary>The cells differ from those that were loaded or saved last.</summary>
        Kept = 16,

        /// <summary>The status text has changed.</summary>
        Words = 32,
    }
}
