using System;
using System.Collections.Generic;

namespace Nowpose.Motion
{
    /// <summary>The true positions of a simulated robot as a function of time. Immutable, so any thread may use it.</summary>
    public interface IMotion
    {
        /// <summary>All moving joints, mimic joints included, in the order of <see cref="At"/>.</summary>
        IReadOnlyList<string> JointNames { get; }

        /// <summary>Period of the motion, in s.</summary>
        double CycleSeconds { get; }

        /// <summary>Computes the position of each joint, in rad or m; allocates nothing.</summary>
        /// <param name="seconds">Time since the cell's start, in s; before the start the robot is at its first position.</param>
        /// <param name="positions">Receives one position per element of <see cref="JointNames"/>.</param>
        void At(double seconds, Span<double> positions);
    }

    /// <summary>A motion that takes an object in each cycle and puts it down.</summary>
    interface IGrippingMotion : IMotion
    {
        /// <summary>Time in the cycle at which the gripper takes the object, s. The arm is at rest then.</summary>
        double GripSeconds { get; }

        /// <summary>
        /// Time in the cycle at which the gripper puts the object down, s; after <see cref="GripSeconds"/>. The arm is at rest then.
        /// </summary>
        double ReleaseSeconds { get; }
    }
}
