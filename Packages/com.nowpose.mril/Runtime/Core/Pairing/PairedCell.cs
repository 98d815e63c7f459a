using System.Collections.Generic;
using System.Linq;

namespace Nowpose.Pairing
{
    /// <summary>A cell that the wearer has agreed to: its markers' codes, and the token that its gateway gave this headset. Immutable.</summary>
    sealed class PairedCell
    {
        /// <summary>More markers than this no robot has; more are not taken, for forged ones would drop the true.</summary>
        public const int GreatestCodes = 16;

        readonly CellCode[] _codes;

        /// <param name="codes">Of one cell and one gateway, oldest first.</param>
        /// <param name="token">Null before the exchange, and for a gateway that asks for none.</param>
        /// <exception cref="InputException">None, too many, or of several cells or gateways; or no token that can be sent.</exception>
        public PairedCell(IEnumerable<CellCode> codes, string token)
        {
            _codes = codes.ToArray();
            if (_codes.Length == 0 || _codes.Length > GreatestCodes)
                throw new InputException("paired cell: " + _codes.Length + " codes; allowed are 1 to " + GreatestCodes);
            if (_codes.Select(code => code.Text).Distinct().Count() != _codes.Length) throw new InputException("paired cell: two codes are the same");
            if (_codes.Any(code => code.Cell != Newest.Cell || !code.HasSameGateway(Newest)))
                throw new InputException("paired cell: the codes are of several cells or gateways");
            Token = Newest.ToConnection(token, "headset").Token;
        }

        public string Cell => Newest.Cell;

        /// <summary>Of each of its markers that was seen so far, oldest first.</summary>
        public IReadOnlyList<CellCode> Codes => _codes;

        public CellCode Newest => _codes[_codes.Length - 1];

        /// <summary>Null for none. Secret.</summary>
        public string Token { get; }

        /// <summary>Whether a connection makes sense: a gateway on the headset's own machine may ask for no token.</summary>
        public bool IsReady => Token != null || Newest.Pin == null;

        public bool IsFull => _codes.Length == GreatestCodes;

        public bool Holds(CellCode code)
        {
            foreach (var known in _codes)
                if (known.Text == code.Text) return true;
            return false;
        }

        /// <exception cref="InputException">It is full, holds the code already, or is another cell or gateway than the code's.</exception>
        public PairedCell With(CellCode code) => new PairedCell(_codes.Append(code), Token);

        public PairedCell WithToken(string token) => new PairedCell(_codes, token);
    }
}
