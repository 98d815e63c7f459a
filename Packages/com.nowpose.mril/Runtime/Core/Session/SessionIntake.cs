using System;
using System.Collections.Concurrent;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Session.Cell;
using Nowpose.Session.Hindcast;

namespace Nowpose.Session
{
    /// <summary>Queues a robot's messages from network threads for the next frame, validates them, and passes them to the joints.</summary>
    sealed class SessionIntake
    {
        /// <summary>
        /// Queue capacity in messages: ten seconds at 100 Hz. <see cref="SampleBacklog"/> limits the number of messages that a frame processes.
        /// </summary>
        const int QueueLength = 1000;

        /// <summary>Queue capacity in plans. Drops the oldest when full, because newer plans replace older plans.</summary>
        const int PlanQueueLength = 16;

        /// <summary>
        /// Time for which stamps are ahead before this is reported. It is longer than the time in which a step of the control clock is detected.
        /// </summary>
        static readonly TimeSpan TimeUntilAhead = TimeSpan.FromSeconds(2);

        /// <summary>
        /// Minimum age of a sample that was taken before this session subscribed. The gateway sends the newest sample of each joint at rest to a new
        /// subscriber; its age is not a latency.
        /// </summary>
        static readonly TimeSpan MinAgeBeforeSubscription = TimeSpan.FromSeconds(1);

        readonly Arrivals<JointStateMessage> _arrivals = new Arrivals<JointStateMessage>(QueueLength, JointStateMessage.HaveSameNames);
        readonly ConcurrentQueue<PlannedMotion> _plans = new ConcurrentQueue<PlannedMotion>();
        readonly RobotModel _robot;
        readonly MessageJoints _messageJoints;
        readonly SampleBacklog _backlog;
        readonly JointTracks _tracks;
        readonly HindcastMonitor _hindcast;
        readonly ApplicationLatency _latency;
        readonly DropCounters _drops;
        readonly ConnectionStart _connection;
        readonly bool _followsPlans;
        readonly HeadsetTime[] _newestOfJoints;
        HeadsetTime? _aheadSince, _newestAhead;

        /// <param name="tracks">Predictors that receive the samples.</param>
        /// <param name="hindcast">Compares the samples with displayed frames.</param>
        /// <param name="latency">Statistics of L_app, updated with each sample.</param>
        /// <param name="drops">Counts of dropped messages by reason.</param>
        public SessionIntake(
            RobotModel robot, JointTracks tracks, HindcastMonitor hindcast, ApplicationLatency latency, DropCounters drops, ConnectionStart connection,
            bool followsPlans)
        {
            _drops = drops;
            _connection = connection;
            _robot = robot;
            _tracks = tracks;
            _hindcast = hindcast;
            _latency = latency;
            _followsPlans = followsPlans;
            _messageJoints = new MessageJoints(robot);
            _newestOfJoints = new HeadsetTime[robot.MovingJoints.Count];
            _backlog = new SampleBacklog(_messageJoints, QueueLength + Arrivals<JointStateMessage>.MaxKept);
        }

        /// <summary>
        /// Raised within <see cref="CompensationSession.Tick"/> for each message that is used, with its L_app; null while the clock offset is
        /// unknown, and for a sample that was taken before this session subscribed.
        /// </summary>
        /// <remarks>A handler must be fast, must not throw, and must not call the session. It may keep the message.</remarks>
        public event Action<Arrival<JointStateMessage>, TimeSpan?> SampleTaken;

        /// <summary>
        /// Raised for each message, with its drop reason; the reason is <see cref="DropReason.None"/> if the message was used. Raised within
        /// <see cref="CompensationSession.Tick"/>, or on the receiving thread if the queue is full.
        /// </summary>
        /// <remarks>The rules for handlers of <see cref="SampleTaken"/> apply.</remarks>
        public event Action<Arrival<JointStateMessage>, DropReason> SampleJudged;

        /// <summary>
        /// Raised for each message of set-points, with its drop reason. The reason is <see cref="DropReason.None"/> if the message is valid, even if
        /// the session does not use it because Follow Plan is off or the predictor is hold. Raised within <see cref="CompensationSession.Tick"/> once
        /// the clock is known, or on the receiving thread if the message contains no joint of the robot or the queue is full.
        /// </summary>
        /// <remarks>The rules for handlers of <see cref="SampleTaken"/> apply.</remarks>
        public event Action<Arrival<JointTrajectoryMessage>, DropReason> PlanJudged;

        /// <summary>Number of used messages.</summary>
        public long Samples { get; private set; }

        /// <inheritdoc cref="RobotStatistics.AreStampsAhead"/>
        public bool AreStampsAhead(HeadsetTime now) => now - _newestAhead <= TimeUntilAhead && _newestAhead - _aheadSince >= TimeUntilAhead;

        /// <summary>Queues a message for the next frame. Thread-safe.</summary>
        /// <param name="message">A validated message.</param>
        /// <param name="arrival">Headset time of its arrival.</param>
        public void Add(JointStateMessage message, HeadsetTime arrival)
        {
            if (_arrivals.Add(message, arrival, out var dropped)) CountDrop(dropped, DropReason.SlowReader);
        }

        /// <summary>Queues future set-points for the next frame with a known control time. Thread-safe.</summary>
        /// <param name="message">A validated message.</param>
        /// <param name="arrival">Headset time of its arrival.</param>
        public void Add(JointTrajectoryMessage message, HeadsetTime arrival)
        {
            var plan = PlannedMotion.Of(new Arrival<JointTrajectoryMessage>(message, arrival), _robot.IndexOfMovingJoint);
            if (plan.Count == 0)
            {
                CountDrop(plan.Arrival, DropReason.UnknownJoint);
                return;
            }
            _plans.Enqueue(plan);
            if (_plans.Count > PlanQueueLength && _plans.TryDequeue(out var oldest)) CountDrop(oldest.Arrival, DropReason.SlowReader);
        }

        /// <summary>Processes the queued messages within a frame.</summary>
        public void TakeAll(in ClockModel clock)
        {
            _backlog.TakeFrom(_arrivals);
            for (var i = 0; i < _backlog.Count; i++)
            {
                var mayBeKept = HasSampleHandler;
                if (_backlog.IsSelected(i)) Take(_backlog[i], clock);
                else CountDrop(_backlog[i], DropReason.SlowReader);
                // Checks for handlers before and after the call, because other threads may add and remove them.
                if (!mayBeKept && !HasSampleHandler) _backlog[i].Message.Release();
            }
            // Plans stay queued until the clock offset is known. Their stamps cannot be validated before that, and a source may take a long time to
            // repeat a dropped plan.
            while (clock.IsKnown && _plans.TryDequeue(out var plan)) Take(plan, clock);
        }

        /// <summary>Whether messages are passed to a handler. A handler may keep a message, so such a message is not reused.</summary>
        public bool HasSampleHandler => SampleTaken != null || SampleJudged != null;

        void Take(in Arrival<JointStateMessage> arrival, in ClockModel clock)
        {
            var (stamp, now) = (arrival.Message.Stamp, clock.IsKnown ? clock.ToControl(arrival.At) : default);
            if (clock.IsKnown && stamp - now > clock.ErrorBound + StampRule.PlausibleAhead) CountAhead(arrival.At);
            if (clock.IsKnown && StampRule.IsInFuture(stamp, now, clock.ErrorBound))
            {
                CountDrop(arrival, DropReason.StampInFuture);
                return;
            }
            var joints = _messageJoints.Of(arrival.Message);
            var isEarlier = clock.IsKnown && IsBeforeSubscription(arrival, joints, clock);
            var reason = _tracks.Add(arrival.Message, joints);
            // After a reconnection, the gateway sends the newest sample of a joint at rest again.
            CountDrop(arrival, isEarlier && reason == DropReason.DuplicateSample ? DropReason.None : reason);
            if (reason != DropReason.None) return;
            Samples++;
            foreach (var joint in joints)
                if (joint >= 0) _newestOfJoints[joint] = arrival.At;
            _hindcast.Add(arrival.Message, joints);
            var isMeasured = clock.IsKnown && !isEarlier;
            if (isMeasured) _latency.Add(now, stamp);
            SampleTaken?.Invoke(arrival, isMeasured ? _latency.Newest : (TimeSpan?)null);
        }

        // Samples with right stamps do not end the series, because a robot may have several sources with different clocks. A single source with a wrong
        // stamp every 2 s therefore counts as ahead too.
        void CountAhead(HeadsetTime arrival)
        {
            if (!(arrival - _newestAhead <= TimeUntilAhead)) _aheadSince = arrival;
            _newestAhead = arrival;
        }

        // Only the first sample of a joint over a connection can be from before the subscription; later samples are old because of the clock of their
        // source. A program that supplies the session has no connection: it subscribes with the first sample of a joint.
        bool IsBeforeSubscription(in Arrival<JointStateMessage> arrival, ReadOnlySpan<int> joints, in ClockModel clock)
        {
            var subscribed = _connection.Newest;
            foreach (var joint in joints)
                if (joint >= 0 && _tracks.HasSample(joint) && !(_newestOfJoints[joint] < subscribed)) return false;
            return clock.ToControl(subscribed ?? arrival.At) - arrival.Message.Stamp > MinAgeBeforeSubscription;
        }

        void Take(PlannedMotion plan, in ClockModel clock)
        {
            var isInFuture = StampRule.IsInFuture(plan.Stamp, clock.ToControl(plan.Arrival.At), clock.ErrorBound);
            CountDrop(plan.Arrival, isInFuture ? DropReason.StampInFuture : DropReason.None);
            if (!isInFuture && _followsPlans) _tracks.Follow(plan);
        }

        void CountDrop(in Arrival<JointStateMessage> arrival, DropReason reason)
        {
            _drops.Count(reason);
            SampleJudged?.Invoke(arrival, reason);
        }

        void CountDrop(in Arrival<JointTrajectoryMessage> arrival, DropReason reason)
        {
            _drops.Count(reason);
            PlanJudged?.Invoke(arrival, reason);
        }
    }
}
