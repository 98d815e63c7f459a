using System.Collections.Generic;
using System.Linq;
using Nowpose.Messages;

namespace Nowpose.Pairing
{
    /// <summary>A cell that the wearer has accepted: the codes of its markers, and the headset's token for its gateway. Immutable.</summary>
    sealed class PairedCell
    {
        /// <summary>Maximum number of markers. Further markers are rejected, so that forged codes cannot displace valid ones.</summary>
        public const int MaxCodes = 16;

        readonly CellCode[] _codes;

        /// <param name="codes">Codes of one cell and one gateway, oldest first.</param>
        /// <param name="token">Null before the exchange, and for a gateway that requires none.</param>
        /// <exception cref="InputException">
        /// The list of codes is empty or too long, the codes belong to several cells or gateways, or the token is invalid.
        /// </exception>
        public PairedCell(IEnumerable<CellCode> codes, string token)
        {
            _codes = codes.ToArray();
            if (_codes.Length == 0 || _codes.Length > MaxCodes)
                throw new InputException(PairedCellMessages.CodeCount(_codes.Length, MaxCodes));
            if (_codes.Select(code => code.Text).Distinct().Count() != _codes.Length) throw new InputException(PairedCellMessages.SameCode);
            if (_codes.Any(code => code.Cell != Newest.Cell || !code.HasSameGateway(Newest)))
                throw new InputException(PairedCellMessages.SeveralCells);
            Token = Newest.ToConnection(token, "headset").Token;
        }

        public string Cell => Newest.Cell;

        /// <summary>Codes of the markers seen so far, oldest first.</summary>
        public IReadOnlyList<CellCode> Codes => _codes;

        public CellCode Newest => _codes[_codes.Length - 1];

        /// <summary>The headset's token for the gateway; null if it has none. Secret.</summary>
        public string Token { get; }

        /// <summary>Whether a connection can succeed: a gateway on the headset's own machine may require no token.</summary>
        public bool IsReady => Token != null || Newest.Pin == null;

        public bool IsFull => _codes.Length == MaxCodes;

        public bool Holds(CellCode code)
        {
            foreach (var known in _codes)
                if (known.Text == code.Text) return true;
            return false;
        }

        /// <exception cref="InputException">
        /// The cell already has this code or the maximum number of codes, or the code belongs to another cell or gateway.
        /// </exception>
        public PairedCell With(CellCode code) => new PairedCell(_codes.Append(code), Token);

        public PairedCell WithToken(string token) => new PairedCell(_codes, token);
    }
}
