using System;
using System.Collections.Generic;
using Nowpose.Prediction.Planning;
using Nowpose.Protocol;

namespace Nowpose.Session
{
    /// <summary>
    /// Set-points of a message, grouped by the robot's joints. Created on the receiving thread to save time on the frame loop's thread.
    /// </summary>
    sealed class PlannedMotion
    {
        readonly int[] _joints;
        readonly JointPath[] _paths;

        PlannedMotion(in Arrival<JointTrajectoryMessage> arrival, int[] joints, JointPath[] paths) =>
            (Arrival, _joints, _paths) = (arrival, joints, paths);

        /// <summary>The message that contains the set-points.</summary>
        public Arrival<JointTrajectoryMessage> Arrival { get; }

        public ControlTime Stamp => Arrival.Message.Stamp;

        /// <summary>Number of the robot's joints in the plan; 0 for a plan of another robot.</summary>
        public int Count => _joints.Length;

        /// <summary>Returns the index of a planned joint among the robot's moving joints.</summary>
        public int JointAt(int i) => _joints[i];

        /// <summary>Returns the path of a planned joint; null if the message ends the plan.</summary>
        public JointPath PathAt(int i) => _paths[i];

        /// <param name="jointOf">Returns the index of the moving joint with the given name; negative if the robot has none.</param>
        public static PlannedMotion Of(in Arrival<JointTrajectoryMessage> arrival, Func<string, int> jointOf)
        {
            var message = arrival.Message;
            var joints = new List<int>();
            var paths = new List<JointPath>();
            var times = TimesOf(message.Points);
            for (var place = 0; place < message.Names.Length; place++)
            {
                var joint = jointOf(message.Names[place]);
                if (joint < 0) continue;
                joints.Add(joint);
                paths.Add(times.Length == 0 ? null : PathOf(message.Points, times, place));
            }
            return new PlannedMotion(arrival, joints.ToArray(), paths.ToArray());
        }

        static double[] TimesOf(IReadOnlyList<JointTrajectoryPoint> points)
        {
            var times = new double[points.Count];
            for (var i = 0; i < times.Length; i++) times[i] = ClockTicks.Seconds(points[i].TimeFromStart);
            return times;
        }

        static JointPath PathOf(IReadOnlyList<JointTrajectoryPoint> points, double[] times, int place)
        {
            var (positions, velocities, accelerations) = (new double[times.Length], new double[times.Length], new double[times.Length]);
            for (var i = 0; i < times.Length; i++)
            {
                positions[i] = points[i].Positions[place];
                velocities[i] = points[i].Velocities == null ? double.NaN : points[i].Velocities[place];
                accelerations[i] = points[i].Accelerations == null ? double.NaN : points[i].Accelerations[place];
            }
            return new JointPath(times, positions, velocities, accelerations);
        }
    }
}
