using System.Collections.Generic;
using Nowpose.Motion;

namespace Nowpose.Simulation.Work
{
    /// <summary>The motions of all robots of a simulated cell, and the work from which they result.</summary>
    sealed class CellMotion
    {
        /// <summary>Creates the motion of a cell with one robot and without workpieces.</summary>
        public CellMotion(IMotion motion) => Motions = new[] { ("", motion) };

        /// <summary>Creates the motion of a cell whose robots move workpieces.</summary>
        public CellMotion(CellWork work)
        {
            Motions = work.Motions;
            Work = work;
        }

        /// <summary>The true motion of each robot, with the robot's namespace. The cell has at least one robot.</summary>
        public IReadOnlyList<(string Namespace, IMotion Motion)> Motions { get; }

        /// <summary>The work of the robots; null if they move no workpieces.</summary>
        public CellWork Work { get; }
    }
}
