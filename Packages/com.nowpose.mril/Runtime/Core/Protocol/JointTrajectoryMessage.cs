using System.Collections.Generic;
using Newtonsoft.Json;

namespace Nowpose.Protocol
{
    /// <summary>trajectory_msgs/JointTrajectory: planned set-points. Efforts are not read.</summary>
    sealed class JointTrajectoryMessage : IRosMessage
    {
        internal JointTrajectoryMessage(ControlTime stamp, string[] names, IReadOnlyList<JointTrajectoryPoint> points) =>
            (Stamp, Names, Points) = (stamp, names, points);

        /// <summary>Control time to which <see cref="JointTrajectoryPoint.TimeFromStart"/> of each point is relative.</summary>
        public ControlTime Stamp { get; }

        public string[] Names { get; }

        /// <summary>Set-points in the order of increasing time. An empty list cancels the plan for these joints.</summary>
        internal IReadOnlyList<JointTrajectoryPoint> Points { get; }

        /// <summary>Returns the same set-points relative to another time; shares them.</summary>
        public JointTrajectoryMessage At(ControlTime stamp) => new JointTrajectoryMessage(stamp, Names, Points);

        public void Write(JsonWriter json, RosTimeForm form)
        {
            json.WriteStartObject();
            json.Header(Stamp, form);
            json.Texts("joint_names", Names);
            json.StartArray("points");
            foreach (var point in Points) point.Write(json, form);
            json.WriteEndArray();
            json.WriteEndObject();
        }
    }
}
