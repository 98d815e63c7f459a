using System;
using System.Collections.Generic;
using Nowpose.Protocol.Cell;

namespace Nowpose.Protocol
{
    /// <summary>Reads the bodies of publications and service responses according to their topic or service. Not thread-safe.</summary>
    sealed class RosMessageReader
    {
        static readonly JsonNames StringFields = new JsonNames("data");
        static readonly JsonNames TimeFields = new JsonNames("time");
        static readonly JsonNames TopicsFields = new JsonNames("topics");
        static readonly JsonNames TrajectoryFields = new JsonNames("header", "joint_names", "points");
        static readonly JsonNames PointFields = new JsonNames("positions", "time_from_start", "velocities", "accelerations");

        readonly JointStateReader _states = new JointStateReader();
        // Each robot in a namespace has its own reader, so that the cached names of one robot do not replace those of another.
        readonly Dictionary<string, JointStateReader> _robots = new Dictionary<string, JointStateReader>(StringComparer.Ordinal);
        readonly TransformsReader _transforms = new TransformsReader();
        readonly SignalsReader _signals = new SignalsReader();
        readonly JointNamesReader _plannedNames = new JointNamesReader();

        public bool Read(ref JsonUtf8Reader json, RosbridgeMessage into)
        {
            if (into.Op == RosbridgeOp.ServiceResponse)
                return ReadResponse(ref json, into);
            switch (into.RobotTopic.Kind)
            {
                case RosTopics.JointStates:
                    into.JointState = StatesOf(into.RobotTopic.Robot).Read(ref json, isNamed: false);
                    return into.JointState != null;
                case RosTopics.Tf: into.Transforms = _transforms.Read(ref json, isStatic: false); return into.Transforms != null;
                case RosTopics.TfStatic: into.Transforms = _transforms.Read(ref json, isStatic: true); return into.Transforms != null;
                case RosTopics.Signals: into.Signals = _signals.Read(ref json); return into.Signals != null;
                case RosTopics.Displayed: into.Displayed = _states.Read(ref json, isNamed: true); return into.Displayed != null;
                case RosTopics.JointTrajectory: return ReadTrajectory(ref json, into);
                case RosTopics.Version:
                case RosTopics.RobotDescription: return ReadData(ref json, into);
                case RosTopics.Diagnostics: return DiagnosticsReader.Read(ref json, into);
                case RosTopics.JointStatus: into.JointStatus = JointStatusReader.Read(ref json); return into.JointStatus != null;
                case RosTopics.SignalStatus: into.SignalStatus = JointStatusReader.Read(ref json); return into.SignalStatus != null;
                default: return json.Skip();
            }
        }

        JointStateReader StatesOf(string robot)
        {
            if (robot.Length == 0 || _robots.TryGetValue(robot, out var reader) == false && _robots.Count == ProtocolLimits.Robots) return _states;
            return reader ?? (_robots[robot] = new JointStateReader());
        }

        static bool ReadResponse(ref JsonUtf8Reader json, RosbridgeMessage into)
        {
            if (!into.Result) return ReadFailure(ref json, into);
            if (into.Service == RosTopics.GetTime || into.Service == RosTopics.GetTimeOfNamespace) return ReadTime(ref json, into);
            if (into.Service == RosTopics.GetTopics) return ReadTopics(ref json, into);
            return into.Service.StartsWith(RosTopics.PlantTime, StringComparison.Ordinal) ? PlantTimeReader.Read(ref json, into) : json.Skip();
        }

        // Reads the reason if it is a string; skips values of other types, which a server may also send.
        static bool ReadFailure(ref JsonUtf8Reader json, RosbridgeMessage into)
        {
            if (!json.IsText) return json.Skip();
            var isRead = json.Text(out var text);
            into.Text = text;
            return isRead;
        }

        static bool ReadTime(ref JsonUtf8Reader json, RosbridgeMessage into)
        {
            var time = default(ControlTime);
            var seen = 0;
            if (!json.BeginObject()) return false;
            while (json.NextField(TimeFields, ref seen, out _)) RosTime.ReadStamp(ref json, out time);
            into.Time = time;
            return json.EndObject(seen, 1);
        }

        static bool ReadTopics(ref JsonUtf8Reader json, RosbridgeMessage into)
        {
            var robots = new List<string>();
            var seen = 0;
            if (!json.BeginObject()) return false;
            while (json.NextField(TopicsFields, ref seen, out _))
            {
                json.BeginArray();
                while (json.NextElement() && json.Text(out var name))
                    if (RobotTopic.Parse(name) is { Kind: RosTopics.JointStates, Robot: { Length: > 0 } robot }) robots.Add(robot);
            }

            robots.Sort(StringComparer.Ordinal);
            into.Namespaces = robots;
            return json.EndObject(seen, 1);
        }

        static bool ReadData(ref JsonUtf8Reader json, RosbridgeMessage into)
        {
            string data = null;
            var seen = 0;
            if (!json.BeginObject()) return false;
            while (json.NextField(StringFields, ref seen, out _)) json.Text(out data);
            into.Data = data;
            return json.EndObject(seen, 1);
        }

        bool ReadTrajectory(ref JsonUtf8Reader json, RosbridgeMessage into)
        {
            var stamp = default(ControlTime);
            var names = Array.Empty<string>();
            var points = new List<JointTrajectoryPoint>();
            var seen = 0;
            if (!json.BeginObject()) return false;
            while (json.NextField(TrajectoryFields, ref seen, out var field))
            {
                switch (field)
                {
                    case 0: RosTime.ReadHeader(ref json, out stamp); break;
                    case 1: _plannedNames.Read(ref json, out names); break;
                    default: ReadPoints(ref json, points); break;
                }
            }

            if (!json.EndObject(seen, 0b111)) return false;
            foreach (var point in points)
                if (point.Positions.Length != names.Length) return json.Fail(DropReason.LengthMismatch);
            into.JointTrajectory = new JointTrajectoryMessage(stamp, names, points);
            return true;
        }

        static bool ReadPoints(ref JsonUtf8Reader json, List<JointTrajectoryPoint> into)
        {
            if (!json.BeginArray()) return false;
            while (json.NextElement()) ReadPoint(ref json, into);
            return json.Fault == DropReason.None;
        }

        static bool ReadPoint(ref JsonUtf8Reader json, List<JointTrajectoryPoint> into)
        {
            var afterStart = default(TimeSpan);
            var (positions, velocities, accelerations) = (new List<double>(), new List<double>(), new List<double>());
            var seen = 0;
            if (!json.BeginObject()) return false;
            while (json.NextField(PointFields, ref seen, out var field))
            {
                switch (field)
                {
                    case 0: json.Numbers(positions, areOptional: false); break;
                    case 1: RosTime.ReadLength(ref json, out afterStart); break;
                    case 2: JointStateReader.ReadRates(ref json, velocities); break;
                    default: JointStateReader.ReadRates(ref json, accelerations); break;
                }
            }

            if (!json.EndObject(seen, 0b11)) return false;
            if (!JointStateReader.HaveLength(positions.Count, velocities, accelerations)) return json.Fail(DropReason.LengthMismatch);
            if (!JointTrajectoryPoint.CanFollow(into, afterStart)) return json.Fail(DropReason.OutOfRange);
            into.Add(new JointTrajectoryPoint(afterStart, positions.ToArray(), OrNull(velocities), OrNull(accelerations)));
            return true;
        }

        static double[] OrNull(List<double> values) => values.Count == 0 ? null : values.ToArray();
    }
}
