using System;
using System.Collections.Generic;

namespace Nowpose.Motion
{
    /// <summary>Where a simulated robot truly is at any time. Immutable, any thread.</summary>
    public interface IMotion
    {
        /// <summary>All moving joints, mimic joints included, in the order of <see cref="At"/>.</summary>
        IReadOnlyList<string> JointNames { get; }

        /// <summary>After this long, s, the motion repeats.</summary>
        double CycleSeconds { get; }

        /// <summary>Fills one position, rad or m, for each joint; allocates nothing.</summary>
        /// <param name="seconds">Since the cell's start; before it the robot stands where it begins.</param>
        /// <param name="positions">As long as <see cref="JointNames"/>.</param>
        void At(double seconds, Span<double> positions);
    }
}
