using System.Collections.Generic;

namespace Nowpose.Protocol
{
    /// <summary>trajectory_msgs/JointTrajectory: set-points ahead of time. Efforts are not read.</summary>
    sealed class JointTrajectoryMessage
    {
        internal JointTrajectoryMessage(ControlTime stamp, string[] names, IReadOnlyList<JointTrajectoryPoint> points)
        {
            Stamp = stamp;
            Names = names;
            Points = points;
        }

        /// <summary>The control time the points' <see cref="JointTrajectoryPoint.TimeFromStart"/> counts from.</summary>
        public ControlTime Stamp { get; }

        public string[] Names { get; }

        /// <summary>Each later than the one before. None: what was planned for these joints is off.</summary>
        internal IReadOnlyList<JointTrajectoryPoint> Points { get; }

        /// <summary>The same set-points counted from another time; shares them.</summary>
        public JointTrajectoryMessage At(ControlTime stamp) => new JointTrajectoryMessage(stamp, Names, Points);
    }
}
