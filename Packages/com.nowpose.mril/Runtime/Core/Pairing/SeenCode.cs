namespace Nowpose.Pairing
{
    /// <summary>What one text in view turned out to be: looked at once, however often it is seen.</summary>
    sealed class SeenCode
    {
        SeenCode(CellCode cell, TokenCode token, string fault)
        {
            Cell = cell;
            Token = token;
            Fault = fault;
            Gateway = cell == null ? null : cell.Cell + "\n" + cell.Host + "\n" + cell.Pin + "\n" + cell.SyncPort + "\n" + cell.WebSocketPort;
        }

        /// <summary>Null where it is none.</summary>
        public CellCode Cell { get; }

        /// <inheritdoc cref="Cell"/>
        public TokenCode Token { get; }

        /// <summary>Why it is neither, in one line.</summary>
        public string Fault { get; }

        /// <summary>The same for all markers of a cell that lead to one gateway.</summary>
        public string Gateway { get; }

        public HeadsetTime LastSeen { get; set; }

        /// <summary>Whether it was said that it is one marker too many.</summary>
        public bool IsTooManyTold { get; set; }

        public static SeenCode Read(string text, PairingCodeKind kind)
        {
            try
            {
                switch (kind)
                {
                    case PairingCodeKind.Cell: return new SeenCode(CellCode.Parse(text), null, null);
                    case PairingCodeKind.Token: return new SeenCode(null, TokenCode.Parse(text), null);
                    default: return new SeenCode(null, null, "pairing code: is neither a cell's nor a gateway's; is this Nowpose too old?");
                }
            }
            catch (InputException fault)
            {
                return new SeenCode(null, null, fault.Message);
            }
        }
    }
}
