using System;
using System.Collections.Generic;
using System.Threading.Tasks;
using Nowpose.Frames;
using Nowpose.Latency;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using Nowpose.Session;
using Nowpose.Sync;

namespace Nowpose.Recording
{
    /// <summary>
    /// Records a running session to a file: sync exchanges, displayed frames and objects, statistics, and all received samples, set-points, signals and poses of
    /// the cell's frames.
    /// </summary>
    /// <remarks>
    /// Event handlers copy the data into a preallocated ring, allocate nothing and never block; a separate thread
    /// formats and writes. Records that do not fit into the ring are lost and counted. <c>Documentation~/session-file.md</c> describes
    /// the file. A disk failure ends the recording, never the session.
    /// </remarks>
    public sealed class SessionRecorder : IDisposable
    {
        /// <summary>Capacity in records, ten seconds of a usual session; a power of two.</summary>
        const int RingLength = 4096;

        static readonly TimeSpan StatisticsInterval = TimeSpan.FromSeconds(1);

        readonly CompensationSession _session;
        readonly RecordRing _ring;
        readonly RecordWriter _writer;
        readonly SessionStatistics _statistics = new SessionStatistics();
        readonly StatisticsLine _statisticsLine = new StatisticsLine();
        readonly List<RobotTraffic> _robots = new List<RobotTraffic>();
        HeadsetTime _nextStatistics;
        ClockState? _clockState;
        int _clockSteps;
        TimeSpan _visualisation;
        RangeState? _range;
        ReprojectionMode _reprojection;
        long _dropsWritten;

        /// <summary>
        /// Starts recording at once. Of the earlier events of the session, the file contains only the poses of stationary frames and the values of signals
        /// that still apply.
        /// </summary>
        /// <remarks>
        /// The session receives the cell's signals from now on, even if nothing shows them. Call this constructor on the thread of the frame loop.
        /// </remarks>
        public SessionRecorder(CompensationSession session, RecordingSettings settings)
        {
            _session = session ?? throw new ArgumentNullException(nameof(session));
            Path = settings.Path;
            var joints = session.Robot.MovingJoints.Count;
            _ring = new RecordRing(RingLength, Math.Max(2 * joints, Math.Max(StatisticsLine.CountFor(joints), DropsLine.Count)));
            var line = new JsonLine();
            HeaderLine.Write(line, session.Settings, session.Robot, session.Conditions, settings.StartedUtc);
            _writer = new RecordWriter(settings, _ring, line, new RecordLine(line, joints, _statisticsLine));
            _writer.Start();
            Listen();
        }

        public string Path { get; }

        /// <summary>State of the recording. Thread-safe.</summary>
        public RecordingState State => _writer.State;

        /// <summary>Reason why the recording ended before its disposal, in one line; null otherwise. Thread-safe.</summary>
        public string Problem => _writer.Problem;

        /// <summary>Number of bytes written. Thread-safe.</summary>
        public long Bytes => _writer.Written;

        /// <summary>Number of lines lost because the ring was full; the file marks the positions. Thread-safe.</summary>
        public long LostLines => _ring.Lost;

        /// <summary>Completes when the file is closed; waiting for it is optional.</summary>
        public Task Ended => _writer.Ended;

        /// <summary>Completes when everything recorded so far is in the file, or the recording has ended. Frames must not wait for it.</summary>
        public Task FlushAsync() => _writer.FlushAsync();

        /// <summary>Ends the recording. Returns at once, while the remaining records are still being written.</summary>
        public void Dispose()
        {
            _session.Clock.Judged -= OnExchange;
            _session.Robots.Added -= ListenTo;
            foreach (var robot in _robots) robot.Dispose();
            _session.Frames.Judged -= OnPose;
            _session.Signals.Judged -= OnSignal;
            _session.Restarted -= OnRestarted;
            _session.Ticked -= OnFrame;
            _writer.Stop();
        }

        void Listen()
        {
            _session.Clock.Judged += OnExchange;
            foreach (var robot in _session.Robots) ListenTo(robot);
            _session.Robots.Added += ListenTo;
            _session.Frames.Judged += OnPose;
            _session.Signals.Judged += OnSignal;
            _session.Signals.Need();
            _session.Restarted += OnRestarted;
            _session.Ticked += OnFrame;
            _session.Frames.ReportStationary(OnPose);
            _session.Signals.ReportKept(OnSignal);
        }

        void OnExchange(in SyncExchange exchange, SyncVerdict verdict, SyncExchangeFault fault)
        {
            if (!TryClaim(RecordKind.Sync, out var record)) return;
            record.SetExchange(exchange, verdict, fault);
            _ring.Publish(record);
        }

        void ListenTo(SessionRobot robot) => _robots.Add(new RobotTraffic(this, robot, isMain: _robots.Count == 0));

        void OnPose(in FrameTransform pose, bool isStationary, HeadsetTime arrival, DropReason reason)
        {
            if (!TryClaim(RecordKind.Pose, out var record)) return;
            record.SetPose(pose, isStationary, arrival, null, reason);
            _ring.Publish(record);
        }

        void OnSignal(in SignalValue value, ControlTime stamp, HeadsetTime arrival, DropReason reason)
        {
            if (!TryClaim(RecordKind.Signal, out var record)) return;
            record.SetSignal(value, stamp, arrival, null, reason);
            _ring.Publish(record);
        }

        void OnRestarted(HeadsetTime at, ClockModel clock) => WriteClock(at, clock, isNewStart: true);

        void OnFrame(DisplayFrame frame)
        {
            var clock = _session.Clock.ModelAt(frame.Start);
            if (clock.State != _clockState || clock.Steps != _clockSteps) WriteClock(frame.Start, clock, isNewStart: false);
            WriteDisplay(frame);
            if (frame.IsLast)
            {
                WriteFrame(frame);
                WriteObjects(frame);
            }
            WriteStatistics(frame.Start, clock);
        }

        void WriteClock(HeadsetTime at, in ClockModel clock, bool isNewStart)
        {
            if (!TryClaim(RecordKind.Clock, out var record)) return;
            _clockState = clock.State;
            _clockSteps = clock.Steps;
            record.SetClock(at, clock, isNewStart);
            _ring.Publish(record);
        }

        void WriteDisplay(DisplayFrame frame)
        {
            var visualisation = _session.Visualisation.Length;
            var reprojection = _session.Reprojection;
            if (visualisation == _visualisation && frame.Range == _range && reprojection == _reprojection) return;
            if (!TryClaim(RecordKind.Display, out var record)) return;
            _visualisation = visualisation;
            _range = frame.Range;
            _reprojection = reprojection;
            record.At = frame.Start;
            record.Length = visualisation;
            record.Range = frame.Range;
            record.Reprojection = reprojection;
            _ring.Publish(record);
        }

        void WriteFrame(DisplayFrame frame)
        {
            if (!TryClaim(RecordKind.Frame, out var record)) return;
            record.At = frame.Start;
            record.Light = frame.DisplayTime;
            record.Pose = frame.State;
            record.Length = _session.NewestRenderTime;
            record.EstimatedError = frame.DisplayTime.HasValue ? frame.ClockError : (TimeSpan?)null;
            frame.Joints.CopyTo(record.Numbers);
            frame.HeldJoints.CopyTo(record.Numbers.AsSpan(frame.Joints.Length));
            _ring.Publish(record);
        }

        // A stationary object that is current has the same pose in all frames, which is in its pose line.
        void WriteObjects(DisplayFrame frame)
        {
            var tree = _session.Frames.Tree;
            for (var i = 0; i < tree.Count; i++)
            {
                var hasPoseLine = tree[i].IsFixed && tree[i].State == FrameState.Current;
                if (!hasPoseLine && tree[i].IsPlaced && _session.Frames.IsShown(tree[i])) WriteObject(tree[i], frame);
            }
        }

        void WriteObject(CellFrame shown, DisplayFrame frame)
        {
            if (!TryClaim(RecordKind.Object, out var record)) return;
            record.At = frame.Start;
            record.Light = frame.DisplayTime;
            record.Transform = shown.World.ToTransform(default, FrameParents.World, shown.Name);
            record.Pose = _session.Frames.StateOf(shown);
            _ring.Publish(record);
        }

        void WriteStatistics(HeadsetTime at, in ClockModel clock)
        {
            if (at < _nextStatistics || !TryClaim(RecordKind.Statistics, out var record)) return;
            _nextStatistics = at + StatisticsInterval;
            _session.Fill(_statistics, at);
            record.At = at;
            record.Clock = clock;
            _statisticsLine.Fill(_statistics, record.Numbers);
            _ring.Publish(record);
            WriteDrops(at);
        }

        void WriteDrops(HeadsetTime at)
        {
            if (_statistics.Dropped == _dropsWritten || !TryClaim(RecordKind.Drops, out var record)) return;
            _dropsWritten = _statistics.Dropped;
            record.At = at;
            DropsLine.Fill(_session, record.Numbers);
            _ring.Publish(record);
        }

        bool TryClaim(RecordKind kind, out SessionRecord record)
        {
            // After the end of the recording, the ring is no longer emptied, and records do not count as lost.
            record = _writer.State == RecordingState.Recording ? _ring.TryClaim(kind) : null;
            return record != null;
        }

        /// <summary>Records the samples and set-points of one robot.</summary>
        sealed class RobotTraffic : IDisposable
        {
            readonly SessionRecorder _recorder;
            readonly SessionIntake _intake;
            readonly string _prefix;

            /// <param name="isMain">Whether this is the robot in the header. The joints of this robot have no prefix.</param>
            public RobotTraffic(SessionRecorder recorder, SessionRobot robot, bool isMain)
            {
                _recorder = recorder;
                _intake = robot.Intake;
                if (!isMain) Describe(robot);
                _prefix = isMain ? null : robot.Namespace + "/";
                _intake.SampleJudged += OnSample;
                _intake.PlanJudged += OnPlan;
            }

            public void Dispose()
            {
                _intake.SampleJudged -= OnSample;
                _intake.PlanJudged -= OnPlan;
            }

            void Describe(SessionRobot robot)
            {
                if (!_recorder.TryClaim(RecordKind.Robot, out var record)) return;
                (record.Namespace, record.Robot) = (robot.Namespace, robot.Robot);
                _recorder._ring.Publish(record);
            }

            void OnSample(Arrival<JointStateMessage> arrival, DropReason reason)
            {
                if (!_recorder.TryClaim(RecordKind.Sample, out var record)) return;
                record.SetSample(arrival, null, _prefix, reason);
                _recorder._ring.Publish(record);
            }

            void OnPlan(Arrival<JointTrajectoryMessage> arrival, DropReason reason)
            {
                if (!_recorder.TryClaim(RecordKind.Plan, out var record)) return;
                record.SetPlan(arrival, _prefix, reason);
                _recorder._ring.Publish(record);
            }
        }
    }
}
