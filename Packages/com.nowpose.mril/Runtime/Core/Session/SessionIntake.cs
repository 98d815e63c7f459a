using System;
using System.Collections.Concurrent;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Session.Hindcast;

namespace Nowpose.Session
{
    /// <summary>The messages on their way from the network's threads into a frame: queued, judged, and handed to the joints.</summary>
    sealed class SessionIntake
    {
        /// <summary>
        /// So many messages may wait for the next frame; beyond, the oldest go. Ten seconds at 100 Hz: enough for the newest of a
        /// joint that speaks seldom. How many of them a frame solves is for <see cref="SampleBacklog"/> to say.
        /// </summary>
        const int QueueLength = 1000;

        /// <summary>So many plans may wait: newer ones replace the older.</summary>
        const int PlanQueueLength = 16;

        readonly ConcurrentQueue<SampleArrival> _arrivals = new ConcurrentQueue<SampleArrival>();
        readonly ConcurrentQueue<PlannedMotion> _plans = new ConcurrentQueue<PlannedMotion>();
        readonly RobotModel _robot;
        readonly MessageJoints _messageJoints;
        readonly SampleBacklog _backlog;
        readonly JointTracks _tracks;
        readonly HindcastMonitor _hindcast;
        readonly ApplicationLatency _latency;
        readonly bool _followsPlans;

        /// <param name="tracks">Take the samples.</param>
        /// <param name="hindcast">Compares them with what was shown.</param>
        /// <param name="latency">L_app, measured with each of them.</param>
        public SessionIntake(RobotModel robot, JointTracks tracks, HindcastMonitor hindcast, ApplicationLatency latency, bool followsPlans)
        {
            _robot = robot;
            _tracks = tracks;
            _hindcast = hindcast;
            _latency = latency;
            _followsPlans = followsPlans;
            _messageJoints = new MessageJoints(robot);
            _backlog = new SampleBacklog(_messageJoints, QueueLength);
        }

        /// <summary>Each message whose samples were used, with its L_app where the clock is known; raised within <see cref="CompensationSession.Tick"/>.</summary>
        /// <remarks>A handler must be quick, must not throw, and must not call back into the session. It may keep the message.</remarks>
        public event Action<SampleArrival, TimeSpan?> SampleTaken;

        /// <summary>
        /// Each message with why it was of no use, <see cref="DropReason.None"/> when it was. Raised within <see cref="CompensationSession.Tick"/>,
        /// but where the queue was full already on the thread that received.
        /// </summary>
        /// <remarks>As of <see cref="SampleTaken"/>.</remarks>
        public event Action<SampleArrival, DropReason> SampleJudged;

        /// <summary>
        /// Each message of set-points with why it was of no use, <see cref="DropReason.None"/> when it could be, even if the settings
        /// follow none. Raised within <see cref="CompensationSession.Tick"/> once the clock is known, but where none of its joints is the robot's, or the
        /// queue was full, already on the thread that received.
        /// </summary>
        /// <remarks>As of <see cref="SampleJudged"/>.</remarks>
        public event Action<PlanArrival, DropReason> PlanJudged;

        /// <summary>What was dropped, by reason.</summary>
        public DropCounters Drops { get; } = new DropCounters();

        /// <summary>Messages whose samples were used.</summary>
        public long Samples { get; private set; }

        /// <summary>A message, queued for the next frame. Any thread.</summary>
        /// <param name="message">Checked already.</param>
        /// <param name="arrival">When it arrived on the headset clock.</param>
        public void Add(JointStateMessage message, HeadsetTime arrival)
        {
            _arrivals.Enqueue(new SampleArrival(message, arrival));
            if (_arrivals.Count > QueueLength && _arrivals.TryDequeue(out var oldest)) Judged(oldest, DropReason.SlowReader);
        }

        /// <summary>Set-points ahead of time, queued for the next frame that knows the control time. Any thread.</summary>
        /// <param name="message">Checked already.</param>
        /// <param name="arrival">When it arrived on the headset clock.</param>
        public void Add(JointTrajectoryMessage message, HeadsetTime arrival)
        {
            var plan = PlannedMotion.Of(new PlanArrival(message, arrival), _robot.IndexOfMovingJoint);
            if (plan.Count == 0)
            {
                Judged(plan.Arrival, DropReason.UnknownJoint);
                return;
            }
            _plans.Enqueue(plan);
            if (_plans.Count > PlanQueueLength && _plans.TryDequeue(out var oldest)) Judged(oldest.Arrival, DropReason.SlowReader);
        }

        /// <summary>Takes what has been queued, within a frame.</summary>
        public void TakeAll(in ClockModel clock)
        {
            _backlog.TakeFrom(_arrivals);
            for (var i = 0; i < _backlog.Count; i++)
            {
                var mayBeKept = HasSampleHandler;
                if (_backlog.IsWorthwhile(i)) Take(_backlog[i], clock);
                else Judged(_backlog[i], DropReason.SlowReader);
                // Before and after, for handlers come and go on other threads.
                if (!mayBeKept && !HasSampleHandler) _backlog[i].Message.Release();
            }
            _backlog.Clear();
            // Their stamps can be judged, and mean anything, only with the clock; a source may not send them again for long.
            while (clock.IsKnown && _plans.TryDequeue(out var plan)) Take(plan, clock);
        }

        // A handler may keep the message that it gets: such a message is not reused.
        bool HasSampleHandler => SampleTaken != null || SampleJudged != null;

        void Take(in SampleArrival arrival, in ClockModel clock)
        {
            var stamp = arrival.Message.Stamp;
            if (clock.IsKnown && StampRule.IsInFuture(stamp, clock.ToControl(arrival.At), clock.ErrorBound))
            {
                Judged(arrival, DropReason.StampInFuture);
                return;
            }
            var joints = _messageJoints.Of(arrival.Message);
            var reason = _tracks.Add(arrival.Message, joints);
            Judged(arrival, reason);
            if (reason != DropReason.None) return;
            Samples++;
            _hindcast.Add(arrival.Message, joints);
            if (clock.IsKnown) _latency.Add(clock.ToControl(arrival.At), stamp);
            SampleTaken?.Invoke(arrival, clock.IsKnown ? _latency.Newest : (TimeSpan?)null);
        }

        void Take(PlannedMotion plan, in ClockModel clock)
        {
            var isInFuture = StampRule.IsInFuture(plan.Stamp, clock.ToControl(plan.Arrival.At), clock.ErrorBound);
            Judged(plan.Arrival, isInFuture ? DropReason.StampInFuture : DropReason.None);
            if (!isInFuture && _followsPlans) _tracks.Follow(plan);
        }

        void Judged(in SampleArrival arrival, DropReason reason)
        {
            Drops.Count(reason);
            SampleJudged?.Invoke(arrival, reason);
        }

        void Judged(in PlanArrival arrival, DropReason reason)
        {
            Drops.Count(reason);
            PlanJudged?.Invoke(arrival, reason);
        }
    }
}
