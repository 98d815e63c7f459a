using System;
using System.Collections.Generic;

namespace Nowpose.Motion
{
    /// <summary>The true positions of a simulated robot as a function of time. Thread-safe.</summary>
    public interface IMotion
    {
        /// <summary>All moving joints, mimic joints included, in the order of <see cref="At"/>.</summary>
        IReadOnlyList<string> JointNames { get; }

        /// <summary>Period of the motion, in s.</summary>
        double CycleSeconds { get; }

        /// <summary>Computes the position of each joint, in rad or m. It is called often and should not allocate.</summary>
        /// <param name="seconds">Time since the cell's start, in s; before the start the robot is at its first position.</param>
        /// <param name="positions">Receives one position per element of <see cref="JointNames"/>.</param>
        void At(double seconds, Span<double> positions);
    }
}
