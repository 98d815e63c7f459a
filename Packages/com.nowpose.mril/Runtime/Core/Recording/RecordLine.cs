using System;
using Nowpose.Latency;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using Nowpose.Session;
using Nowpose.Sync;

namespace Nowpose.Recording
{
    /// <summary>Writes records as lines of a session file. Times are whole nanoseconds; session-file.md states the clock of each field.</summary>
    sealed class RecordLine
    {
        static readonly EnumNames<SyncVerdict> Verdicts = new EnumNames<SyncVerdict>(verdict => (int)verdict);
        static readonly EnumNames<PoseState> Poses = new EnumNames<PoseState>(pose => (int)pose);

        /// <summary>Number of coordinates in a position.</summary>
        const int PositionNumbers = 3;

        readonly JsonLine _line;
        readonly int _joints;
        readonly StatisticsLine _statistics;

        /// <param name="joints">Number of moving joints of the robot.</param>
        /// <param name="statistics">The object that fills the numbers of the statistics.</param>
        public RecordLine(JsonLine line, int joints, StatisticsLine statistics) => (_line, _joints, _statistics) = (line, joints, statistics);

        public void Write(SessionRecord record)
        {
            switch (record.Kind)
            {
                case RecordKind.Sync: WriteSync(record); break;
                case RecordKind.Robot: HeaderLine.WriteFields(_line.Begin("robot").Add("namespace", record.Namespace), record.Robot); break;
                case RecordKind.Sample: WriteSample(record); break;
                case RecordKind.Plan: WritePlan(record); break;
                case RecordKind.Pose: WritePose(record); break;
                case RecordKind.Signal: WriteSignal(record); break;
                case RecordKind.Frame: WriteFrame(record); break;
                case RecordKind.Object: WriteObject(record); break;
                case RecordKind.Clock: WriteClock(record); break;
                case RecordKind.Display: WriteDisplay(record); break;
                case RecordKind.Statistics: WriteStatistics(record); break;
                case RecordKind.Diagnostics: WriteDiagnostics(record); break;
                default: WriteDrops(record); break;
            }
            _line.End();
        }

        void WriteSync(SessionRecord record)
        {
            var exchange = record.Exchange;
            // Writes the received value, because the reader of the file adds half the resolution again.
            var half = new TimeSpan(exchange.Resolution.Ticks / 2);
            _line.Begin("sync").Add("t1_ns", exchange.T1.Nanoseconds).Add("t2_ns", (exchange.T2 - half).Nanoseconds)
                .Add("t3_ns", (exchange.T3 - half).Nanoseconds).Add("t4_ns", exchange.T4.Nanoseconds)
                .Add("resolution_ns", Nanoseconds(exchange.Resolution)).Add("server_bound_ns", Nanoseconds(exchange.ServerErrorBound));
            if (!exchange.ServerSynchronised) _line.Add("server_synchronised", false);
            _line.Add("verdict", Verdicts.NameOf(record.Verdict));
            if (record.Fault != SyncExchangeFault.None) _line.Add("fault", DropsLine.Faults.NameOf(record.Fault));
        }

        void WriteSample(SessionRecord record)
        {
            var message = record.Arrival.Message;
            _line.Begin("sample").Add("arrival_ns", record.Arrival.At.Nanoseconds).Add("stamp_ns", message.Stamp.Nanoseconds);
            AddControlArrival(record);
            _line.Add("names", record.NamePrefix, message.Names).Add("position", message.Positions);
            if (message.Velocities != null) _line.Add("velocity", message.Velocities);
            if (message.Accelerations != null) _line.Add("acceleration", message.Accelerations);
            AddReason(record);
        }

        void WritePlan(SessionRecord record)
        {
            var message = record.Plan.Message;
            _line.Begin("plan").Add("arrival_ns", record.Plan.At.Nanoseconds).Add("stamp_ns", message.Stamp.Nanoseconds)
                .Add("names", record.NamePrefix, message.Names).Open("points", '[');
            for (var i = 0; i < message.Points.Count; i++)
            {
                var point = message.Points[i];
                _line.OpenElement().Add("time_from_start_ns", Nanoseconds(point.TimeFromStart)).Add("position", point.Positions);
                if (point.Velocities != null) _line.Add("velocity", point.Velocities);
                if (point.Accelerations != null) _line.Add("acceleration", point.Accelerations);
                _line.Close('}');
            }
            _line.Close(']');
            AddReason(record);
        }

        void WritePose(SessionRecord record)
        {
            var pose = record.Transform;
            _line.Begin("pose").Add("arrival_ns", record.At.Nanoseconds).Add("stamp_ns", pose.Stamp.Nanoseconds);
            AddControlArrival(record);
            _line.Add("frame", pose.Child).Add("parent", pose.Parent);
            AddPlace(pose);
            if (record.IsStationary) _line.Add("stationary", true);
            AddReason(record);
        }

        void WriteSignal(SessionRecord record)
        {
            _line.Begin("signal").Add("arrival_ns", record.At.Nanoseconds).Add("stamp_ns", record.Stamp.Nanoseconds);
            AddControlArrival(record);
            _line.Add("name", record.Signal.Name).Add("value", record.Signal.Value);
            AddReason(record);
        }

        void WriteFrame(SessionRecord record)
        {
            BeginDisplayed("frame", record).Add("state", Poses.NameOf(record.Pose)).Add("joints", record.Numbers.AsSpan(0, _joints))
                .Add("held", record.Numbers.AsSpan(_joints, _joints));
            if (record.Length.HasValue) _line.Add("render_ns", Nanoseconds(record.Length.Value));
            if (record.EstimatedError.HasValue) _line.Add("estimated_error_ns", Nanoseconds(record.EstimatedError.Value));
        }

        void WriteObject(SessionRecord record)
        {
            BeginDisplayed("object", record).Add("frame", record.Transform.Child).Add("state", Poses.NameOf(record.Pose));
            AddPlace(record.Transform);
        }

        void WriteClock(SessionRecord record)
        {
            _line.Begin("clock").Add("at_ns", record.At.Nanoseconds);
            AddClock(record);
            if (record.IsNewStart) _line.Add("new_start", true);
        }

        void WriteDisplay(SessionRecord record)
        {
            _line.Begin("display").Add("at_ns", record.At.Nanoseconds)
                .Add("l_visu_ns", Nanoseconds(record.Length.GetValueOrDefault())).Add("range", LatencyNames.Range.NameOf(record.Range));
            if (record.Reprojection != ReprojectionMode.Unknown) _line.Add("reprojection", LatencyNames.Reprojection.NameOf(record.Reprojection));
        }

        void WriteStatistics(SessionRecord record)
        {
            _line.Begin("statistics").Add("at_ns", record.At.Nanoseconds);
            AddClock(record);
            _statistics.Write(_line, record.Numbers);
        }

        void WriteDiagnostics(SessionRecord record)
        {
            var message = record.Diagnostics;
            _line.Begin("diagnostics").Add("at_ns", record.At.Nanoseconds).Add("name", message.HardwareId).Open("values", '{');
            for (var i = 0; i < message.Values.Count; i++) _line.Add(message.Values[i].Key, message.Values[i].Value);
            _line.Close('}');
        }

        void WriteDrops(SessionRecord record)
        {
            _line.Begin("drops").Add("at_ns", record.At.Nanoseconds);
            DropsLine.Write(_line, record.Numbers);
        }

        JsonLine BeginDisplayed(string kind, SessionRecord record)
        {
            _line.Begin(kind).Add("start_ns", record.At.Nanoseconds);
            return record.Light.HasValue ? _line.Add("light_ns", record.Light.Value.Nanoseconds) : _line;
        }

        void AddPlace(in FrameTransform pose)
        {
            Span<double> numbers = stackalloc double[] { pose.X, pose.Y, pose.Z, pose.Qx, pose.Qy, pose.Qz, pose.Qw };
            _line.Add("position", numbers.Slice(0, PositionNumbers)).Add("rotation", numbers.Slice(PositionNumbers));
        }

        void AddControlArrival(SessionRecord record)
        {
            if (record.ControlArrival.HasValue) _line.Add("control_arrival_ns", record.ControlArrival.Value.Nanoseconds);
        }

        void AddReason(SessionRecord record)
        {
            if (record.Reason != DropReason.None) _line.Add("dropped", DropsLine.Reasons.NameOf(record.Reason));
        }

        void AddClock(SessionRecord record)
        {
            var clock = record.Clock;
            _line.Add("state", clock.State.Word()).Add("steps", clock.Steps);
            if (!clock.IsKnown) return;
            _line.Add("offset_ns", Nanoseconds(clock.OffsetAt(record.At).HeadsetMinusControl)).Add("skew_ppm", clock.Skew * 1e6)
                .Add("error_bound_ns", Nanoseconds(clock.ErrorBound)).Add("estimated_error_ns", Nanoseconds(clock.EstimatedError));
        }

        static long Nanoseconds(TimeSpan length) => length.Ticks * ClockTicks.NanosecondsPerTick;
    }
}
