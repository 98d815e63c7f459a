using System;
using System.Collections.Generic;
using Newtonsoft.Json;

namespace Nowpose.Protocol
{
    /// <summary>One set-point of a trajectory.</summary>
    sealed class JointTrajectoryPoint
    {
        public JointTrajectoryPoint(TimeSpan timeFromStart, double[] positions, double[] velocities = null, double[] accelerations = null) =>
            (TimeFromStart, Positions, Velocities, Accelerations) = (timeFromStart, positions, velocities, accelerations);

        /// <summary>Time after the trajectory's stamp.</summary>
        public TimeSpan TimeFromStart { get; }

        /// <summary>Positions in rad or m, one for each joint of the trajectory.</summary>
        public double[] Positions { get; }

        /// <summary>Velocities in rad/s or m/s, NaN if unknown; null if all are unknown.</summary>
        public double[] Velocities { get; }

        /// <summary>Accelerations in rad/s² or m/s², NaN if unknown; null if all are unknown.</summary>
        public double[] Accelerations { get; }

        /// <summary>
        /// Whether a point can be at a given time after these points. Times must increase, because the positions of the path would be ambiguous
        /// otherwise; ROS rejects such a path, too. Compares seconds, with which the path computes: two times after many years can be the same
        /// number of seconds.
        /// </summary>
        public static bool CanFollow(IReadOnlyList<JointTrajectoryPoint> points, TimeSpan time) => points.Count == 0
            ? time >= TimeSpan.Zero
            : ClockTicks.Seconds(time) > ClockTicks.Seconds(points[points.Count - 1].TimeFromStart);

        public void Write(JsonWriter json, RosTimeForm form)
        {
            json.WriteStartObject();
            json.Numbers("positions", Positions);
            // Omits empty arrays: a long path with them could exceed the maximum length, although the received message did not.
            if (Velocities != null) json.OptionalNumbers("velocities", Velocities);
            if (Accelerations != null) json.OptionalNumbers("accelerations", Accelerations);
            json.Time("time_from_start", new ControlTime(TimeFromStart).Nanoseconds, form);
            json.WriteEndObject();
        }
    }
}
