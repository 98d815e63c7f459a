namespace Nowpose.Pairing
{
    /// <summary>What a code in view says it is.</summary>
    enum PairingCodeKind
    {
        /// <summary>Somebody else's: none of our business.</summary>
        Foreign,

        /// <summary>The robot's marker, see <see cref="CellCode"/>.</summary>
        Cell,

        /// <summary>The gateway's code that is valid once, see <see cref="TokenCode"/>.</summary>
        Token,

        /// <summary>Ours by its beginning, and neither.</summary>
        Unknown,
    }
}
