using System.Collections.Generic;
using System.Linq;
using Nowpose.Messages;

namespace Nowpose.Pairing
{
    /// <summary>All cells that the wearer has accepted, by name, and the cell in use. Immutable.</summary>
    sealed class PairedCells
    {
        public const int MaxCount = 64;

        public static readonly PairedCells None = new PairedCells(System.Array.Empty<PairedCell>(), null);

        readonly PairedCell[] _cells;

        /// <param name="used">Name of the cell in use; null if there is none.</param>
        /// <exception cref="InputException">There are too many cells, two have the same name, or the cell in use is not among them.</exception>
        public PairedCells(IEnumerable<PairedCell> cells, string used)
        {
            _cells = cells.ToArray();
            if (_cells.Length > MaxCount)
                throw new InputException(PairedCellMessages.CellCount(_cells.Length, MaxCount));
            if (_cells.Select(cell => cell.Cell).Distinct().Count() != _cells.Length) throw new InputException(PairedCellMessages.SameName);
            Used = used == null ? null : Find(used) ?? throw new InputException(PairedCellMessages.UsedNotInList);
        }

        public IReadOnlyList<PairedCell> All => _cells;

        /// <summary>The cell in use; null if there is none.</summary>
        public PairedCell Used { get; }

        /// <summary>Finds a paired cell by its name. Allocates nothing.</summary>
        /// <returns>Null if no paired cell has this name.</returns>
        public PairedCell Find(string cell)
        {
            foreach (var known in _cells)
                if (known.Cell == cell) return known;
            return null;
        }

        /// <summary>
        /// Finds the cell that needs a gateway's code. The cell in use takes precedence, because several cells may share a gateway.
        /// </summary>
        /// <param name="isUsedRefused">Whether the gateway rejects the token of the cell in use.</param>
        /// <returns>Null if no cell needs the code. Allocates nothing.</returns>
        internal PairedCell TakerOf(TokenCode code, bool isUsedRefused)
        {
            if (UsedNeeds(code, isUsedRefused)) return Used;
            foreach (var cell in _cells)
                if (cell.Token == null && code.IsFor(cell.Newest)) return cell;
            return null;
        }

        /// <summary>Returns whether the cell in use needs a gateway's code. Allocates nothing.</summary>
        internal bool UsedNeeds(TokenCode code, bool isUsedRefused) =>
            Used != null && code.IsFor(Used.Newest) && (Used.Token == null || isUsedRefused);

        internal bool HasGatewayOf(TokenCode code)
        {
            foreach (var cell in _cells)
                if (code.IsFor(cell.Newest)) return true;
            return false;
        }

        /// <summary>
        /// Adds a cell, or replaces the cell of the same name, and makes the given cell the cell in use. Removes the least recently used cell if
        /// there are too many.
        /// </summary>
        public PairedCells Use(PairedCell cell) => new PairedCells(
            Without(cell.Cell)._cells.Reverse().Take(MaxCount - 1).Reverse().Append(cell), cell.Cell);

        public PairedCells Without(string cell) => new PairedCells(
            _cells.Where(known => known.Cell != cell), Used?.Cell == cell ? null : Used?.Cell);
    }
}
