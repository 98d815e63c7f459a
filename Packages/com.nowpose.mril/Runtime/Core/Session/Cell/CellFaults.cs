using System;
using System.Collections.Generic;

namespace Nowpose.Session.Cell
{
    /// <summary>
    /// The objects and signals that a session shows and that are not current, the most severe first. Reasons that affect all of them alike, such as an
    /// unsynchronised clock, are not included.
    /// </summary>
    sealed class CellFaults
    {
        public static readonly CellFaults None = new CellFaults(new List<PartStatus>(), new List<PartStatus>());

        public CellFaults(List<PartStatus> objects, List<PartStatus> signals)
        {
            objects.Sort(PartStatus.Compare);
            signals.Sort(PartStatus.Compare);
            Objects = objects;
            Signals = signals;
        }

        public IReadOnlyList<PartStatus> Objects { get; }

        public IReadOnlyList<PartStatus> Signals { get; }
    }
}
