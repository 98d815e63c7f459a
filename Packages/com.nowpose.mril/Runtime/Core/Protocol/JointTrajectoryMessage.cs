using System.Collections.Generic;

namespace Nowpose.Protocol
{
    /// <summary>trajectory_msgs/JointTrajectory: planned set-points. Efforts are not read.</summary>
    sealed class JointTrajectoryMessage
    {
        internal JointTrajectoryMessage(ControlTime stamp, string[] names, IReadOnlyList<JointTrajectoryPoint> points)
        {
            Stamp = stamp;
            Names = names;
            Points = points;
        }

        /// <summary>The control time to which <see cref="JointTrajectoryPoint.TimeFromStart"/> of the points is relative.</summary>
        public ControlTime Stamp { get; }

        public string[] Names { get; }

        /// <summary>The set-points, each later than the one before. Empty: the plan of these joints is cancelled.</summary>
        internal IReadOnlyList<JointTrajectoryPoint> Points { get; }

        /// <summary>Returns the same set-points relative to another time; shares them.</summary>
        public JointTrajectoryMessage At(ControlTime stamp) => new JointTrajectoryMessage(stamp, Names, Points);
    }
}
