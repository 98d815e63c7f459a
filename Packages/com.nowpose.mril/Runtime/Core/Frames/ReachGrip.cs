using System;
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
        readonly int _link;
        readonly string _linkName;
        readonly double _reach;
        readonly IReadOnlyList<string> _objects;
        bool? _isClosed;
        bool _isFinal = true;
        ControlTime _since;
        int _held = -1;
        RigidTransform _inHand;
        ReachPlace _before;
        string _unknown, _signalFault;

        /// <param name="link">Index of the link in the robot; its origin is the gripping point.</param>
        /// <param name="reach">Maximum distance of an object's origin from the gripping point, m.</param>
        /// <param name="objects">Names of the frames that the gripper can grip. They are read at each change.</param>
        public ReachGrip(FrameTree tree, IRobotLinks robot, int link, double reach, IReadOnlyList<string> objects)
        {
            _tree = tree;
            _robot = robot;
            _link = link;
            _linkName = RobotTopic.Qualified(robot.Namespace, robot.Robot.Links[link].Name);
            _reach = reach;
            _objects = objects;
        }

        /// <summary>Name of the held object; null if the gripper holds none.</summary>
        public string Held => _isClosed == true && IsMine ? _tree[_held].Name : null;

        /// <summary>Reason why the held object is unknown, in one line; null if it is known.</summary>
        public string Fault => _unknown ?? _signalFault;

        /// <summary>Control time since which the held object has been unknown; null while this time is unknown, and without a fault.</summary>
        public ControlTime? FaultSince { get; private set; }

        // False after the object's source or another gripper has taken the object over.
        bool IsMine => _held >= 0 && _tree[_held].Reach?.Gripper == this;

        /// <summary>Closes or opens the gripper. The next call of <see cref="Decide(ControlTime)"/> determines the effect.</summary>
        /// <param name="since">Stamp of the change; null if its time is no longer known.</param>
        public void Change(bool isClosed, ControlTime? since)
        {
            if (isClosed == _isClosed) return;
            Decide(isLast: true);
            var mayHaveMoved = !isClosed && _unknown != null;
            (_isClosed, _since, _isFinal) = (isClosed, since ?? default, since == null);
            _unknown = isClosed && since == null ? FrameMessages.ClosedAtUnknownTime : null;
            if (!isClosed && since == null) Leave();
            if (mayHaveMoved) MarkAsMoved(since);
        }

        // The object was released at an unknown place, and its own source may still report the place from before the grip.
        void MarkAsMoved(ControlTime? since)
        {
            for (var i = 0; i < _objects.Count; i++)
            {
                var index = _tree.IndexOf(_objects[i]);
                if (index >= 0 && CanMove(index)) _tree[index].SetUnknownMover(this, since);
            }
        }

        /// <summary>Determines the effect of a change from the data that have arrived. Call it before the tree is evaluated.</summary>
        /// <param name="light">Display time.</param>
        public void Decide(ControlTime light) => Decide(isLast: ClockTicks.Seconds(light - _since) > Patience);

        /// <summary>Determines the effect of a change without waiting for more data. Call it before samples are discarded.</summary>
        public void Settle() => Decide(isLast: true);

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
            if (_isClosed == true) _unknown = FrameMessages.SignalRestarted;
        }

        /// <summary>
        /// Marks the objects that the gripper may hold or may have moved if its held object is unknown. Call it after each <see cref="Decide(ControlTime)"/>.
        /// </summary>
        /// <param name="signalFault">Reason why the value of the gripper's signal is not current; null if it is current.</param>
        /// <param name="since">Control time at which the value stopped being current; null if unknown.</param>
        public void Judge(string signalFault, ControlTime? since)
        {
            _signalFault = signalFault;
            FaultSince = _unknown == null ? since : null;
            if (Fault == null) return;
            // A foreach loop over an IReadOnlyList allocates its enumerator.
            for (var i = 0; i < _objects.Count; i++)
            {
                var index = _tree.IndexOf(_objects[i]);
                if (index < 0) continue;
                _tree[index].SetUnknownGrip(this, CanMove(index));
            }
        }

        /// <summary>Lets a held object's own source determine its place again.</summary>
        public void Leave()
        {
            if (IsMine) _tree.Put(_held, null);
            _held = -1;
            _isFinal = true;
            _unknown = _signalFault = null;
            for (var i = 0; i < _tree.Count; i++) _tree[i].Forget(this);
        }

        void Decide(bool isLast)
        {
            if (_isFinal) return;
            var hand = _tree.LinkAt(_tree.IndexOf(_robot), _link, _since, out var origin);
            if (_isClosed == true) Grip(hand, origin, isLast);
            else Release(hand, origin, isLast);
        }

        void Grip(in RigidTransform hand, PoseOrigin handOrigin, bool isLast)
        {
            var nearest = -1;
            var inHand = RigidTransform.Identity;
            var isMeasured = handOrigin == PoseOrigin.Measured;
            for (var i = 0; i < _objects.Count; i++)
            {
                var name = _objects[i];
                var index = _tree.IndexOf(name);
                if (handOrigin == PoseOrigin.None || index < 0 || !CanGrip(index)) continue;
                if (IsTakenLater(_tree[index].Reach)) continue;
                var pose = hand.Inverse * _tree.PoseAt(index, index == _held ? _before : _tree[index].Reach, _since, out var origin);
                isMeasured &= origin == PoseOrigin.Measured;
                if (origin == PoseOrigin.None || DistanceOf(pose) > _reach) continue;
                if (nearest >= 0 && !IsBefore(DistanceOf(pose), name, DistanceOf(inHand), _tree[nearest].Name)) continue;
                (nearest, inHand) = (index, pose);
            }
            _isFinal = isMeasured || isLast;
            if (_isFinal && handOrigin == PoseOrigin.None) _unknown = FrameMessages.ArmWithoutData;
            if (nearest != _held) Take(nearest, inHand);
            else if (_isFinal && IsMine) Put(new ReachPlace(this, _linkName, inHand, _since, isReleased: false));
            _inHand = inHand;
        }

        bool CanGrip(int index) => !_tree.IsCarried(index) && !_tree.IsBelow(_tree.IndexOf(_robot), index);

        // Another gripper would have to release its object first.
        bool CanMove(int index) => CanGrip(index) && !(_tree[index].Reach is { IsReleased: false } place && place.Gripper != this);

        // The gripper that closed or opened last determines the place, in whichever order the messages arrive. At equal times, the name decides.
        bool IsTakenLater(ReachPlace place) => place != null && place.Gripper != this
            && (place.Since > _since || place.Since == _since && string.CompareOrdinal(place.Gripper._linkName, _linkName) < 0);

        void Take(int index, in RigidTransform inHand)
        {
            if (IsMine) _tree.Put(_held, _before);
            _held = index;
            if (index < 0) return;
            _before = _tree[index].Reach;
            Put(new ReachPlace(this, _linkName, inHand, _since, isReleased: false));
        }

        void Release(in RigidTransform hand, PoseOrigin origin, bool isLast)
        {
            _isFinal = !IsMine || origin == PoseOrigin.Measured || isLast;
            if (IsMine)
            {
                var pose = origin == PoseOrigin.None ? _tree[_held].World : hand * _inHand;
                Put(new ReachPlace(this, FrameParents.World, pose, _since, isReleased: true));
            }
            if (_isFinal) _held = -1;
        }

        void Put(ReachPlace place) => _tree.Put(_held, place);

        static bool IsBefore(double distance, string name, double otherDistance, string otherName) =>
            distance < otherDistance || (distance == otherDistance && string.CompareOrdinal(name, otherName) < 0);

        static double DistanceOf(in RigidTransform pose) => Math.Sqrt(pose.X * pose.X + pose.Y * pose.Y + pose.Z * pose.Z);
    }
}
