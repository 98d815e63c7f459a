using System.Collections.Generic;
using System.Linq;

namespace Nowpose.Pairing
{
    /// <summary>All cells that the wearer has agreed to, by name, and the one in use. Immutable.</summary>
    sealed class PairedCells
    {
        public const int GreatestCount = 64;

        public static readonly PairedCells None = new PairedCells(System.Array.Empty<PairedCell>(), null);

        readonly PairedCell[] _cells;

        /// <param name="used">Name of the cell in use; null for none.</param>
        /// <exception cref="InputException">Too many, two of one name, or none of the name in use.</exception>
        public PairedCells(IEnumerable<PairedCell> cells, string used)
        {
            _cells = cells.ToArray();
            if (_cells.Length > GreatestCount)
                throw new InputException("paired cells: " + _cells.Length + " cells; allowed are up to " + GreatestCount);
            if (_cells.Select(cell => cell.Cell).Distinct().Count() != _cells.Length) throw new InputException("paired cells: two are of one name");
            Used = used == null ? null : Find(used) ?? throw new InputException("paired cells: the cell in use is none of them");
        }

        public IReadOnlyList<PairedCell> All => _cells;

        /// <summary>Null for none.</summary>
        public PairedCell Used { get; }

        /// <returns>Null where there is none. Allocates nothing.</returns>
        public PairedCell Find(string cell)
        {
            foreach (var known in _cells)
                if (known.Cell == cell) return known;
            return null;
        }

        /// <summary>The cell that a gateway's code is of use for: the one in use before others, for several may share a gateway.</summary>
        /// <param name="isUsedRefused">Whether the gateway does not accept the token of the cell in use.</param>
        /// <returns>Null for none. Allocates nothing.</returns>
        internal PairedCell TakerOf(TokenCode code, bool isUsedRefused)
        {
            if (UsedNeeds(code, isUsedRefused)) return Used;
            foreach (var cell in _cells)
                if (cell.Token == null && code.IsFor(cell.Newest)) return cell;
            return null;
        }

        /// <inheritdoc cref="TakerOf"/>
        internal bool UsedNeeds(TokenCode code, bool isUsedRefused) =>
            Used != null && code.IsFor(Used.Newest) && (Used.Token == null || isUsedRefused);

        internal bool HasGatewayOf(TokenCode code)
        {
            foreach (var cell in _cells)
                if (code.IsFor(cell.Newest)) return true;
            return false;
        }

        /// <summary>With a cell in place of the one of its name, and in use. Of too many the one that was put longest ago is dropped.</summary>
        public PairedCells Use(PairedCell cell) => new PairedCells(
            Without(cell.Cell)._cells.Reverse().Take(GreatestCount - 1).Reverse().Append(cell), cell.Cell);

        public PairedCells Without(string cell) => new PairedCells(
            _cells.Where(known => known.Cell != cell), Used?.Cell == cell ? null : Used?.Cell);
    }
}
