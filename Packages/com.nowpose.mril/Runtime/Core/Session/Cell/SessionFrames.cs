using System;
using System.Collections.Generic;
using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;

namespace Nowpose.Session.Cell
{
    /// <summary>Receives a pose of a frame and the reason why it was dropped; <see cref="DropReason.None"/> if it was used.</summary>
    delegate void PoseJudged(in FrameTransform pose, bool isStationary, HeadsetTime arrival, DropReason reason);

    /// <summary>Receives the frames of a session's cell, predicts them to the display time, and determines their states.</summary>
    sealed class SessionFrames
    {
        /// <summary>Queue capacity for tracked frames, in messages. Messages wait for a display frame with a known control time.</summary>
        const int QueueLength = 1000;

        /// <summary>Queue capacity for stationary frames, in messages: one per frame, because each pose is usually sent only once.</summary>
        const int StationaryQueueLength = ProtocolLimits.Frames;

        readonly Arrivals<TransformsMessage> _tracked = new Arrivals<TransformsMessage>(QueueLength, TransformsMessage.HaveSameFrames);
        readonly Arrivals<TransformsMessage> _stationary = new Arrivals<TransformsMessage>(StationaryQueueLength, TransformsMessage.HaveSameFrames);
        // Have their full capacity from the start, because a frame must not allocate.
        readonly List<Arrival<TransformsMessage>> _takenTracked = new List<Arrival<TransformsMessage>>(QueueLength + Arrivals<TransformsMessage>.MaxKept);
        readonly List<Arrival<TransformsMessage>> _takenStationary =
            new List<Arrival<TransformsMessage>>(StationaryQueueLength + Arrivals<TransformsMessage>.MaxKept);
        readonly StationaryArrivals _stationaryArrivals;
        readonly StateTimes _states = new StateTimes();
        readonly NeededFrames _needed;
        // Stationary poses of the message that is processed.
        readonly Queue<(int Index, DropReason Reason)> _refused = new Queue<(int, DropReason)>();
        readonly List<SessionRobot> _robots = new List<SessionRobot>();
        readonly DropCounters _drops;
        readonly object _gate;
        readonly SettledPose _settledTime = new SettledPose();
        DisplayMoment _moment;

        /// <param name="gate">Lock of the session.</param>
        public SessionFrames(PredictionSettings prediction, Subscriptions subscriptions, DropCounters drops, ConnectionStart connection, object gate)
        {
            _drops = drops;
            _gate = gate;
            _stationaryArrivals = new StationaryArrivals(connection);
            Tree = new FrameTree(prediction.BodiesOfACell());
            _needed = new NeededFrames(Tree, drops, _stationaryArrivals.IsBeforeConnection);
            _needed.Replaced += _stationaryArrivals.Remove;
            subscriptions.Add(RosTopics.Tf, RosTopics.TransformsType);
            subscriptions.Add(RosTopics.TfStatic, RosTopics.TransformsType);
        }

        public FrameTree Tree { get; }

        /// <summary>
        /// Reports each processed pose, used or dropped, but no pose that a full queue has dropped; raised within
        /// <see cref="CompensationSession.Tick"/>. Also reports each pose from <see cref="Place"/>, with the start of the newest frame as its arrival.
        /// </summary>
        /// <remarks>A handler must be fast, must not throw, and must not call the session.</remarks>
        public event PoseJudged Judged;

        /// <summary>Reports the poses of the stationary frames, which arrived or were placed earlier and are not sent again.</summary>
        public void ReportStationary(PoseJudged report) => _stationaryArrivals.Report(report);

        /// <summary>Adds a robot. Its links can be parents of frames, and its root link may be a frame of the cell.</summary>
        public void Add(SessionRobot robot)
        {
            Tree.Add(robot);
            _robots.Add(robot);
            _needed.ShowRoot(robot.Root);
        }

        /// <summary>Places a robot's base at the frame of the cell that has the name of the robot's root link, if there is one.</summary>
        public void PlaceRoot(SessionRobot robot)
        {
            if (Tree.RootOf(robot) is CellFrame root) robot.PlaceRoot(root.World, StateOf(root), root.IsFixed);
        }

        /// <summary>Predicts a frame from now on, even if no pose of the frame has been received yet. <see cref="Leave"/> reverses it.</summary>
        public void Need(string name)
        {
            lock (_gate) _needed.Show(name);
        }

        /// <summary>
        /// Reverses one <see cref="Need"/>. Another frame may replace the frame when it is no longer needed and its poses have stopped, so do not use its
        /// <see cref="CellFrame"/> afterwards.
        /// </summary>
        public void Leave(string name)
        {
            lock (_gate) _needed.Hide(name);
        }

        /// <summary>Places a stationary frame manually until a source publishes it, and shows it from now on.</summary>
        /// <param name="pose">Pose in the world frame.</param>
        /// <returns>Reason why the frame cannot be placed; <see cref="DropReason.None"/> if it is placed.</returns>
        public DropReason Place(string name, in RigidTransform pose)
        {
            lock (_gate)
            {
                _needed.Need(name);
                _stationaryArrivals.Remove(name);
                var placed = pose.ToTransform(default, FrameParents.World, name);
                var reason = _needed.Add(placed, isStationary: true);
                if (reason != DropReason.None) return reason;
                Find(name).IsPlacedByHand = true;
                _stationaryArrivals.Add(placed, _moment.Start, isByHand: true);
                Judged?.Invoke(placed, isStationary: true, _moment.Start, reason);
                return reason;
            }
        }

        /// <summary>Returns a frame that was requested with <see cref="Need"/>; null if no pose of the frame has been received.</summary>
        public CellFrame Find(string name)
        {
            var index = Tree.IndexOf(name);
            return index < 0 ? null : Tree[index];
        }

        /// <summary>Returns the state of a frame's displayed pose. The states have the same meaning as for a robot's pose.</summary>
        /// <param name="frame">A frame of <see cref="Tree"/>; null for an unknown frame.</param>
        public PoseState StateOf(CellFrame frame) => PoseStateRule.Of(_moment, frame);

        /// <summary>State of a part of the scene that has no pose of its own, such as one that a signal switches: only the display time limits it.</summary>
        public PoseState StateOfTime => PoseStateRule.Of(_moment, isIncomplete: false, isHeld: false);

        /// <summary>The state that the look of such a part shows, see <see cref="SettledPose"/>.</summary>
        public PoseState SettledStateOfTime => _settledTime.Over(StateOfTime);

        /// <summary>Whether poses of tracked frames wait until the control time is known.</summary>
        public bool IsWaitingForClock => !_moment.Clock.IsKnown;

        /// <summary>
        /// Returns the time since which a held frame has had no newer pose: the stamp of its newest pose, or that of the frame above it whose poses
        /// have stopped, or that of a joint of the robot on which it is. If it is unknown what a gripper holds, returns the time since which this is
        /// unknown. If there is no such time, returns the display time at which this state began. Returns null if the frame is current or unknown.
        /// </summary>
        public ControlTime? HeldSince(CellFrame frame)
        {
            if (frame?.State == FrameState.ParentNotCurrent)
            {
                Tree.ReasonAbove(frame, out frame, out var robot);
                if (robot != null) return (robot as SessionRobot)?.MissingSince(_moment);
            }
            switch (frame?.State)
            {
                case FrameState.GripUnknown: return frame.GripFaultSince ?? BeginningOf(frame);
                case FrameState.Held: return frame.Newest ?? BeginningOf(frame);
                case FrameState.Orphan: return BeginningOf(frame);
                default: return null;
            }
        }

        /// <summary>
        /// Returns the shown frames that are not current for a reason of their own, including tracked bases of shown robots. Call it under the lock of
        /// the session.
        /// </summary>
        /// <param name="now">Control time for the ages; null while unknown.</param>
        public List<PartStatus> Faults(ControlTime? now)
        {
            var faults = new List<PartStatus>();
            foreach (var name in _needed.Shown) AddFault(name, Find(name), now, faults);
            foreach (var robot in _robots)
                if (robot.IsShown && !_needed.IsShown(robot.Root) && Find(robot.Root) is CellFrame moved) AddFault(robot.Root, moved, now, faults);
            return faults;
        }

        /// <summary>Returns whether a component shows a frame, or a shown robot stands on it. Call it under the lock of the session.</summary>
        public bool IsShown(CellFrame frame)
        {
            if (_needed.IsShown(frame.Name)) return true;
            foreach (var robot in _robots)
                if (robot.IsShown && robot.Root == frame.Name) return true;
            return false;
        }

        void AddFault(string name, CellFrame frame, ControlTime? now, List<PartStatus> to)
        {
            var state = StateOf(frame);
            // Poses of moving frames wait for the clock.
            if ((state != PoseState.Incomplete && state != PoseState.Held) || (frame == null && IsWaitingForClock)) return;
            var since = HeldSince(frame);
            to.Add(new PartStatus(name, state, since, StateTimes.Age(since, now), new FrameFault().Of(frame, Tree)));
        }

        ControlTime? BeginningOf(CellFrame frame) => _states.SinceOf(Tree.IndexOf(frame.Name));

        /// <inheritdoc cref="JointWatch.MissingSince"/>
        public ControlTime? MissingSince(SessionRobot robot) => robot.MissingSince(_moment);

        /// <summary>
        /// Queues a message for the next display frame. Messages of tracked frames wait for a display frame with a known control time. Thread-safe.
        /// </summary>
        public void Add(TransformsMessage message, bool isStationary, HeadsetTime arrival)
        {
            if (!(isStationary ? _stationary : _tracked).Add(message, arrival, out var dropped)) return;
            _drops.Count(DropReason.SlowReader);
            dropped.Message.Release();
        }

        /// <summary>Processes the queued messages.</summary>
        public void Take(in DisplayMoment moment)
        {
            _moment = moment;
            _settledTime.Add(moment.Start, StateOfTime);
            TakeQueued(moment.Clock);
            _stationaryArrivals.Mark(Tree, moment.Start);
        }

        // Takes the messages in the order of their arrival, because a frame can be put on another one only after this one has left it.
        void TakeQueued(in ClockModel clock)
        {
            // Takes the tracked ones first: the stationary ones that arrived before them are then in their queue.
            _takenTracked.Clear();
            if (clock.IsKnown) _tracked.TakeAll(_takenTracked);
            _stationary.TakeAll(_takenStationary);
            for (int t = 0, s = 0; t < _takenTracked.Count || s < _takenStationary.Count;)
            {
                var isTracked = s == _takenStationary.Count || (t < _takenTracked.Count && _takenTracked[t].At < _takenStationary[s].At);
                var arrival = isTracked ? _takenTracked[t++] : _takenStationary[s++];
                if (isTracked) Take(arrival.Message, arrival.At, clock);
                else Take(arrival.Message, arrival.At);
            }
        }

        /// <summary>Computes the poses of all frames. Call it after the robots have computed their poses.</summary>
        public void Show(in DisplayMoment moment)
        {
            Tree.Evaluate(moment.DisplayTime);
            _states.Update(Tree, moment.DisplayTime);
        }

        /// <summary>Discards the poses of tracked frames, because their times are no longer valid.</summary>
        public void Restart()
        {
            Tree.Reset();
            _needed.Restart();
            _states.Restart();
        }

        void Take(TransformsMessage message, HeadsetTime arrival)
        {
            var now = _moment.Clock.IsKnown ? _moment.Clock.ToControl(arrival) : (ControlTime?)null;
            for (var i = 0; i < message.Count; i++) TryAdd(message, i, arrival, now);
            // A frame may have been refused because of the former parent of a frame after it.
            for (var before = int.MaxValue; _refused.Count < before;)
            {
                before = _refused.Count;
                for (var i = 0; i < before; i++) TryAdd(message, _refused.Dequeue().Index, arrival, now);
            }
            while (_refused.Count > 0)
            {
                var (index, reason) = _refused.Dequeue();
                Judge(message[index], true, arrival, reason);
            }
            message.Release();
        }

        void TryAdd(TransformsMessage message, int index, HeadsetTime arrival, ControlTime? now)
        {
            var reason = _needed.Add(message[index], isStationary: true, now);
            if (reason == DropReason.None)
            {
                _stationaryArrivals.Add(message[index], arrival);
                Judge(message[index], true, arrival, reason);
            }
            else _refused.Enqueue((index, reason));
        }

        void Take(TransformsMessage message, HeadsetTime arrival, in ClockModel clock)
        {
            var now = clock.ToControl(arrival);
            for (var i = 0; i < message.Count; i++)
            {
                var reason = StampRule.IsInFuture(message[i].Stamp, now, clock.ErrorBound) ? DropReason.StampInFuture
                    : _stationaryArrivals.IsLater(message[i].Child, arrival) ? DropReason.LateSample
                    : _needed.Add(message[i], isStationary: false, now);
                if (reason == DropReason.None) _stationaryArrivals.Remove(message[i].Child);
                Judge(message[i], false, arrival, reason);
            }
            message.Release();
        }

        void Judge(in FrameTransform pose, bool isStationary, HeadsetTime arrival, DropReason reason)
        {
            _drops.Count(reason);
            Judged?.Invoke(pose, isStationary, arrival, reason);
        }
    }
}
