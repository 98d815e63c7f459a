using System;
using System.Collections.Generic;

namespace Nowpose.Protocol
{
    /// <summary>Reads the bodies of publications and service responses, each by its topic or service.</summary>
    static class RosMessages
    {
        static readonly string[] StringFields = { "data" };
        static readonly string[] TimeFields = { "time" };
        static readonly string[] StateFields = { "header", "name", "position", "velocity", "acceleration" };
        static readonly string[] TrajectoryFields = { "header", "joint_names", "points" };
        static readonly string[] PointFields = { "positions", "time_from_start", "velocities", "accelerations" };

        public static bool Read(JsonCursor cursor, RosbridgeMessage into)
        {
            if (into.Op == RosbridgeOp.ServiceResponse)
                return ReadResponse(cursor, into);
            switch (into.Topic)
            {
                case RosTopics.JointStates: into.JointState = ReadState(cursor, isNamed: false); return into.JointState != null;
                case RosTopics.Displayed: into.Displayed = ReadState(cursor, isNamed: true); return into.Displayed != null;
                case RosTopics.JointTrajectory: return ReadTrajectory(cursor, into);
                case RosTopics.RobotDescription: return ReadData(cursor, into);
                case RosTopics.Diagnostics: return DiagnosticsReader.Read(cursor, into);
                case RosTopics.JointStatus: return JointStatusReader.Read(cursor, into);
                default: return cursor.Skip();
            }
        }

        static bool ReadResponse(JsonCursor cursor, RosbridgeMessage into)
        {
            if (!into.Result) return ReadFailure(cursor, into);
            if (into.Service == RosTopics.GetTime) return ReadTime(cursor, into);
            return into.Service.StartsWith(RosTopics.PlantTime, StringComparison.Ordinal) ? PlantTimeReader.Read(cursor, into) : cursor.Skip();
        }

        // Why, in words; or whatever a server likes to put there.
        static bool ReadFailure(JsonCursor cursor, RosbridgeMessage into)
        {
            if (!cursor.IsText) return cursor.Skip();
            var isRead = cursor.Text(out var text);
            into.Text = text;
            return isRead;
        }

        static bool ReadTime(JsonCursor cursor, RosbridgeMessage into)
        {
            var time = default(ControlTime);
            var isRead = cursor.Object(TimeFields, 1, _ => RosTime.ReadStamp(cursor, out time));
            into.Time = time;
            return isRead;
        }

        static bool ReadData(JsonCursor cursor, RosbridgeMessage into)
        {
            var data = default(string);
            var isRead = cursor.Object(StringFields, 1, _ => cursor.Text(out data));
            into.Data = data;
            return isRead;
        }

        // Null when it is refused.
        static JointStateMessage ReadState(JsonCursor cursor, bool isNamed)
        {
            var stamp = default(ControlTime);
            var frame = "";
            var names = new List<string>();
            var positions = new List<double>();
            var velocities = new List<double>();
            var accelerations = new List<double>();
            var isRead = cursor.Object(StateFields, 0b111, field => field switch
            {
                0 => isNamed ? RosTime.ReadNamedHeader(cursor, out stamp, out frame) : RosTime.ReadHeader(cursor, out stamp),
                1 => ReadNames(cursor, names),
                2 => cursor.FiniteNumbers(positions),
                3 => cursor.IsNull || cursor.OptionalNumbers(velocities),
                _ => cursor.IsNull || cursor.OptionalNumbers(accelerations),
            });
            if (!isRead || !HaveLength(cursor, names.Count, positions, velocities) || !HaveLength(cursor, names.Count, positions, accelerations))
                return null;
            if (names.Count == 0)
            {
                cursor.Fail(DropReason.MissingField);
                return null;
            }

            return new JointStateMessage(
                stamp, names.ToArray(), positions.ToArray(), OrNull(velocities), OrNull(accelerations), frame);
        }

        static bool ReadTrajectory(JsonCursor cursor, RosbridgeMessage into)
        {
            var stamp = default(ControlTime);
            var names = new List<string>();
            var points = new List<JointTrajectoryPoint>();
            var isRead = cursor.Object(TrajectoryFields, 0b111, field => field switch
            {
                0 => RosTime.ReadHeader(cursor, out stamp),
                1 => ReadNames(cursor, names),
                _ => cursor.Elements(() => ReadPoint(cursor, points)),
            });
            if (!isRead || !points.TrueForAll(point => point.Positions.Length == names.Count))
                return isRead && cursor.Fail(DropReason.LengthMismatch);
            into.JointTrajectory = new JointTrajectoryMessage(stamp, names.ToArray(), points);
            return true;
        }

        static bool ReadPoint(JsonCursor cursor, List<JointTrajectoryPoint> into)
        {
            var afterStart = default(TimeSpan);
            var positions = new List<double>();
            var velocities = new List<double>();
            var accelerations = new List<double>();
            var isRead = cursor.Object(PointFields, 0b11, field => field switch
            {
                0 => cursor.FiniteNumbers(positions),
                1 => RosTime.ReadLength(cursor, out afterStart),
                2 => cursor.IsNull || cursor.OptionalNumbers(velocities),
                _ => cursor.IsNull || cursor.OptionalNumbers(accelerations),
            });
            if (!isRead || !HaveLength(cursor, positions.Count, positions, velocities)
                || !HaveLength(cursor, positions.Count, positions, accelerations))
                return false;
            // As ROS refuses it: a path that stands still in time or goes back has no position to follow.
            if (afterStart < TimeSpan.Zero || (into.Count > 0 && afterStart <= into[into.Count - 1].TimeFromStart))
                return cursor.Fail(DropReason.OutOfRange);
            into.Add(new JointTrajectoryPoint(afterStart, positions.ToArray(), OrNull(velocities), OrNull(accelerations)));
            return true;
        }

        static bool HaveLength(JsonCursor cursor, int count, List<double> positions, List<double> velocities) =>
            (positions.Count == count && (velocities.Count == 0 || velocities.Count == count)) || cursor.Fail(DropReason.LengthMismatch);

        static double[] OrNull(List<double> values) => values.Count == 0 ? null : values.ToArray();

        static bool ReadNames(JsonCursor cursor, List<string> into)
        {
            var known = new HashSet<string>(StringComparer.Ordinal);
            return cursor.Elements(() =>
            {
                if (!cursor.Name(out var name))
                    return false;
                into.Add(name);
                if (into.Count > ProtocolLimits.Joints)
                    return cursor.Fail(DropReason.TooManyJoints);
                return known.Add(name) || cursor.Fail(DropReason.DuplicateName);
            });
        }
    }
}
