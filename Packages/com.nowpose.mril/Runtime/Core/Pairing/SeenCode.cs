using Nowpose.Messages;

namespace Nowpose.Pairing
{
    /// <summary>The parsed content of one code in view; each code is parsed once.</summary>
    sealed class SeenCode
    {
        SeenCode(CellCode cell, TokenCode token, string fault)
        {
            Cell = cell;
            Token = token;
            Fault = fault;
            Gateway = cell == null ? null : cell.Cell + "\n" + cell.Host + "\n" + cell.Pin + "\n" + cell.SyncPort + "\n" + cell.WebSocketPort;
        }

        /// <summary>The parsed code; null if the content is a code of another kind.</summary>
        public CellCode Cell { get; }

        /// <inheritdoc cref="Cell"/>
        public TokenCode Token { get; }

        /// <summary>Reason in one line why the content is neither a cell code nor a token code; null if it is one of them.</summary>
        public string Fault { get; }

        /// <summary>
        /// String that identifies the gateway: the same for all markers of a cell that have the same gateway; null without a cell code.
        /// </summary>
        public string Gateway { get; }

        public HeadsetTime LastSeen { get; set; }

        /// <summary>Whether it was reported that this marker exceeds the maximum number.</summary>
        public bool IsTooManyReported { get; set; }

        public static SeenCode Read(string text, PairingCodeKind kind)
        {
            try
            {
                switch (kind)
                {
                    case PairingCodeKind.Cell: return new SeenCode(CellCode.Parse(text), null, null);
                    case PairingCodeKind.Token: return new SeenCode(null, TokenCode.Parse(text), null);
                    default: return new SeenCode(null, null, PairingCodeMessages.UnknownKind);
                }
            }
            catch (InputException fault)
            {
                return new SeenCode(null, null, fault.Message);
            }
        }
    }
}
