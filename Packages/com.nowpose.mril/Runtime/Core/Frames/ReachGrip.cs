using System.Collections.Generic;
using Nowpose.Kinematics;
using Nowpose.Messages;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;

namespace Nowpose.Frames
{
    /// <summary>
    /// A gripper that grips the object within its reach when its signal changes. It is used if no source reports what the gripper holds.
    /// </summary>
    /// <remarks>
    /// The poses at the time stamp of the change determine which object is gripped, not the poses at the arrival of the message. At first, these
    /// poses are predicted, because the display time is ahead of the samples. As soon as samples from after the time stamp have arrived, the poses
    /// are computed from them, so that all headsets with the same samples grip the same object in the same place. If the object's source changes its
    /// parent, the source has priority. A released object stays in the world at its pose at the time stamp of the release, until its source moves
    /// it. Use it only on the thread that computes the display frames.
    /// </remarks>
    sealed class ReachGrip
    {
        /// <summary>
        /// Maximum time to wait for samples from after a change of the signal, in s. After this time, the available data determine the effect of the
        /// change. It is longer than any latency that is worth compensating.
        /// </summary>
        const double Patience = 1;

        readonly FrameTree _tree;
        readonly IRobotLinks _robot;
        readonly string _linkName;
        readonly double _reach;
        readonly IReadOnlyList<string> _objects;
        readonly PosesAtChange _poses;
        // States of the gripper. If _missed has a reason, any object may be in the gripper, in each state.
        //   unknown: _isClosed is null. No value of the signal has arrived.
        //   closing: _isClosed, not _isFinal. Samples from the time of the closing are still missing, so _held may change.
        //   holding: _isClosed, _isFinal, IsMine.
        //   empty: _isClosed, _isFinal, not IsMine. It gripped no object (_held < 0), or the object's source or another gripper has taken it.
        //   opening: not _isClosed, not _isFinal. Samples from the time of the opening are missing, so the place of the release may change.
        //   open: not _isClosed, _isFinal.
        bool? _isClosed;
        bool _isFinal = true;
        // The object that the gripper gripped when it closed, its place at the closing, its place if the grip is withdrawn, and its pose in the hand.
        int _held = -1;
        ReachPlace _before, _withdrawn;
        KnownPose _inHand;
        // Reason why any object may be in the gripper: a change that was missed or cannot be evaluated.
        string _missed;

        /// <param name="link">Index of the link in the robot; its origin is the gripping point.</param>
        /// <param name="reach">Maximum distance of an object's origin from the gripping point, m.</param>
        /// <param name="objects">Names of the frames that the gripper can grip. The list may change.</param>
        public ReachGrip(FrameTree tree, IRobotLinks robot, int link, double reach, IReadOnlyList<string> objects)
        {
            _tree = tree;
            _robot = robot;
            _linkName = RobotTopic.Qualified(robot.Namespace, robot.Robot.Links[link].Name);
            _reach = reach;
            _objects = objects;
            _poses = new PosesAtChange(tree, robot, link);
        }

        /// <summary>Name of the held object; null if the gripper holds none.</summary>
        public string Held => _isClosed == true && IsMine ? _tree[_held].Name : null;

        /// <summary>Reason why the held object, or the place of an object that was held, is unknown, in one line; null if it is known.</summary>
        public string Fault { get; private set; }

        /// <summary>Control time since which the held object has been unknown; null while this time is unknown, and without a fault.</summary>
        public ControlTime? FaultSince { get; private set; }

        // False after the object's source or another gripper has taken the object over.
        bool IsMine => _held >= 0 && _tree[_held].Reach?.Gripper == this;

        /// <summary>Closes or opens the gripper. The next call of <see cref="Decide(ControlTime)"/> determines the effect.</summary>
        /// <param name="since">Stamp of the change; null if its time is no longer known.</param>
        public void Change(bool isClosed, ControlTime? since)
        {
            if (isClosed == _isClosed) return;
            Settle();
            if (isClosed) WatchObjects(since);
            if (isClosed) _missed = since == null ? FrameMessages.ClosedAtUnknownTime : null;
            else Open(since);
            _isClosed = isClosed;
            _isFinal = since == null;
            if (since is ControlTime at) _poses.Begin(at);
        }

        /// <summary>Handles the first value after an interruption, during which the gripper may have opened and closed unnoticed.</summary>
        public void Resume(bool isClosed)
        {
            Settle();
            WatchObjects(closing: null);
            _missed = FrameMessages.SignalInterrupted;
            if (!isClosed) Open(since: null);
            _isClosed = isClosed;
        }

        /// <summary>Handles a restart of the gripper's signal, during which the gripper may have opened and closed unnoticed.</summary>
        /// <param name="isOfSource">
        /// Whether the source of the signal has restarted. In this case, the objects' own sources determine the places of all objects that the
        /// gripper held or released. Otherwise, only the times of the control system have become invalid, and the objects keep their places until
        /// the next change.
        /// </param>
        public void Restart(bool isOfSource)
        {
            Settle();
            if (isOfSource)
            {
                _tree.TakeFrom(this);
                _held = -1;
            }
            if (_isClosed == true) _missed = FrameMessages.SignalRestarted;
        }

        /// <summary>
        /// Lets a held object's own source determine its place again. The place of this object, and of those that may be in the gripper, is unknown
        /// until their sources report other poses, because the gripper still holds them.
        /// </summary>
        public void Leave()
        {
            Settle();
            Open(since: null);
            for (var i = 0; i < _tree.Count; i++) _tree[i].SetUnknownGrip(this, isUnknown: false);
            _isFinal = true;
            Fault = null;
        }

        /// <summary>Determines the effect of a change from the data that have arrived. Call it before the tree is evaluated.</summary>
        /// <param name="light">Display time.</param>
        public void Decide(ControlTime light) => Decide(isLast: ClockTicks.Seconds(light - _poses.At) > Patience);

        /// <summary>Determines the effect of a change without waiting for more data. Call it before samples are discarded.</summary>
        public void Settle() => Decide(isLast: true);

        void Decide(bool isLast)
        {
            if (_isClosed == true && _missed == null && HasNewEarlierRelease()) _isFinal = false;
            if (_isFinal) return;
            var isHandCorrected = _poses.UpdateHand();
            if (_isClosed == true) Grip(isLast, isHandCorrected);
            else Release(isLast);
        }

        void Grip(bool isLast, bool isHandCorrected)
        {
            _missed = _poses.Hand.IsKnown ? null : FrameMessages.ArmWithoutData;
            _isFinal = isLast;
            if (!_poses.Hand.IsKnown) return;
            var hasMoved = _held >= 0 && !_poses.IsOf(_held, _before);
            var nearest = new NearestObject(_poses.Hand, _reach);
            var areAllMeasured = _poses.Hand.IsMeasured;
            // The component of the held object may be disabled meanwhile.
            if (IsMine) areAllMeasured &= IsCompared(_held, ref nearest);
            for (var i = 0; i < _objects.Count; i++)
                if (_tree.IndexOf(_objects[i]) is var index && index >= 0) areAllMeasured &= IsCompared(index, ref nearest);
            _isFinal |= areAllMeasured;
            if (nearest.Index != _held) Take(nearest);
            else if (IsMine && (!_inHand.IsMeasured || hasMoved) && (_isFinal || isHandCorrected || nearest.InHand.IsMeasured)) PutInHand(nearest.InHand);
            if (_isFinal && _held < 0) _poses.AddOutOfReach(_reach);
        }

        ReachPlace PlaceBefore(int index) => index == _held ? _before : _tree[index].Reach;

        // The signal of another gripper, which released an object before this one closed, may arrive after the decision.
        bool HasNewEarlierRelease()
        {
            if (IsMine && IsNewEarlierRelease(_held)) return true;
            for (var i = 0; i < _objects.Count; i++)
                if (_tree.IndexOf(_objects[i]) is var index && index >= 0 && IsNewEarlierRelease(index)) return true;
            return false;
        }

        bool IsNewEarlierRelease(int index) => PlaceBefore(index) is { IsReleased: true } place && place.Gripper != this
            && place.Since > default(ControlTime) && place.Since <= _poses.At && !_poses.IsOf(index, place);

        // Compares an object with the nearest one so far. Returns false if its pose may still change.
        bool IsCompared(int index, ref NearestObject nearest)
        {
            var pose = _poses.Of(index, PlaceBefore(index));
            if (!CanGrip(index) || IsTakenLater(_tree[index].Reach)) return true;
            nearest.Add(index, _tree[index].Name, pose);
            return pose.IsMeasured;
        }

        // The gripper that closed or opened last determines the place, in whichever order the messages arrive. At equal times, the name decides.
        bool IsTakenLater(ReachPlace place) => place != null && place.Gripper != this
            && (place.Since > _poses.At || place.Since == _poses.At && string.CompareOrdinal(place.Gripper._linkName, _linkName) < 0);

        void Take(in NearestObject nearest)
        {
            if (IsMine) Withdraw();
            _held = nearest.Index;
            if (_held < 0) return;
            _before = _withdrawn = _tree[_held].Reach;
            PutInHand(nearest.InHand);
        }

        // The gripper from which the object was taken may no longer hold it: its component was removed, or it opened at an unknown place.
        void Withdraw()
        {
            if (_withdrawn?.IsReleased == false && _withdrawn.Gripper._held != _held) _tree.Lose(_held, _withdrawn.Gripper, since: null);
            else _tree.Put(_held, _withdrawn);
        }

        void PutInHand(in KnownPose inHand)
        {
            _inHand = inHand;
            Put(new ReachPlace(this, _linkName, inHand.Pose, _poses.At, isReleased: false));
        }

        // What an object's source did before the closing says nothing about what it does while the object may be in the gripper.
        void WatchObjects(ControlTime? closing)
        {
            // A foreach loop over an IReadOnlyList allocates its enumerator.
            for (var i = 0; i < _objects.Count; i++)
                if (_tree.IndexOf(_objects[i]) is var index && index >= 0) _tree[index].WatchFrom(closing);
        }

        // Marks the objects that may have been in the gripper unnoticed. Their own sources may still report the places from before the grip.
        void Open(ControlTime? since)
        {
            for (var i = 0; i < _objects.Count; i++)
            {
                var index = _tree.IndexOf(_objects[i]);
                if (index >= 0 && (_missed != null || MayHoldUnseen(index)) && CanMove(index)) _tree[index].SetUnknownMover(this, since);
            }
            _missed = null;
            if (since == null) Lose(since);
        }

        void Release(bool isLast)
        {
            var hand = _poses.Hand;
            var taker = Taker;
            _isFinal = isLast || hand.IsMeasured || (!IsMine && taker == null);
            if (IsMine && hand.IsKnown) Put(ReleasedAt(hand));
            else if (taker != null && hand.IsKnown) taker.SetFormer(ReleasedAt(hand));
            else if (_isFinal) Lose(_poses.At);
            if (_isFinal) _held = -1;
        }

        // Sets the place at which the gripper that held the object before has released it.
        void SetFormer(ReachPlace released)
        {
            _withdrawn = released;
            if (released.Since <= _poses.At) _before = released;
        }

        // The gripper that has taken the object from this one while it was closed; null if there is none.
        ReachGrip Taker => _held >= 0 && _tree[_held].Reach is { IsReleased: false } place && place.Gripper != this
            && place.Gripper._withdrawn?.Gripper == this ? place.Gripper : null;

        ReachPlace ReleasedAt(in KnownPose hand) => new ReachPlace(this, FrameParents.World, hand.Pose * _inHand.Pose, _poses.At, isReleased: true);

        // The held object was released at an unknown place.
        void Lose(ControlTime? since)
        {
            if (IsMine) _tree.Lose(_held, this, since);
            _held = -1;
        }

        void Put(ReachPlace place) => _tree.Put(_held, place);

        /// <summary>
        /// Marks the objects that the gripper may hold, or may have released at an unknown place. Call it after each
        /// <see cref="Decide(ControlTime)"/>.
        /// </summary>
        /// <param name="signalFault">Reason why the value of the gripper's signal is not current; null if it is current.</param>
        /// <param name="since">Control time at which the value stopped being current; null if unknown.</param>
        public void Judge(string signalFault, ControlTime? since)
        {
            var common = _missed ?? signalFault;
            Fault = common;
            for (var i = 0; i < _objects.Count; i++)
            {
                var index = _tree.IndexOf(_objects[i]);
                if (index < 0) continue;
                var reason = common ?? ReasonFor(index);
                if (reason != null && !CanMove(index)) reason = null;
                // The object measures the noise of its source from the first fault on, so it needs the fault before the mark.
                Fault ??= reason;
                _tree[index].SetUnknownGrip(this, reason != null);
            }
            FaultSince = _missed == null ? since : null;
        }

        // Returns the reason of this object alone why it is unknown whether the gripper holds it; null if it is known.
        string ReasonFor(int index) => MayHoldUnseen(index) ? FrameMessages.ObjectWithoutPose
            : index == _held && _isClosed == false && !_isFinal && !_poses.Hand.IsKnown ? FrameMessages.OpenedWithoutData : null;

        // The gripper may have gripped an object whose pose at that time is unknown, because it gripped none of the others.
        bool MayHoldUnseen(int index) => _isClosed == true && _held < 0 && !_poses.Includes(_tree[index]);

        bool CanGrip(int index) => !_tree.IsCarried(index) && !_tree.IsBelow(_tree.IndexOf(_robot), index);

        // Another gripper would have to release its object first.
        bool CanMove(int index) => CanGrip(index) && !(_tree[index].Reach is { IsReleased: false } place && place.Gripper != this);
    }
}
