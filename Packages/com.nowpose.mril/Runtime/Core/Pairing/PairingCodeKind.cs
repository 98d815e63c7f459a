namespace Nowpose.Pairing
{
    /// <summary>The kind that a code in view declares.</summary>
    enum PairingCodeKind
    {
        /// <summary>A code of another application; ignored.</summary>
        Foreign,

        /// <summary>The robot's marker, see <see cref="CellCode"/>.</summary>
        Cell,

        /// <summary>The gateway's code that is valid once, see <see cref="TokenCode"/>.</summary>
        Token,

        /// <summary>A pairing code of another kind.</summary>
        Unknown,
    }
}
