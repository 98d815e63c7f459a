using System;
using System.Collections.Generic;
using Nowpose.Kinematics;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;

namespace Nowpose.Frames
{
    /// <summary>All stationary and tracked frames of the cell, attached to the world, to each other, or to the links of robots.</summary>
    /// <remarks>
    /// The pose of a frame in the world is T_world = T_parent · T, with the parent's pose at the same display time, so that an object whose
    /// parent is a link moves exactly with the displayed robot. Use it only on the thread that computes the display frames. A display frame allocates
    /// nothing, except after a change of the structure.
    /// </remarks>
    sealed class FrameTree
    {
        readonly Func<BodyPredictor> _newPredictor;
        readonly List<CellFrame> _frames = new List<CellFrame>();
        readonly Dictionary<string, int> _indices = new Dictionary<string, int>(StringComparer.Ordinal);
        readonly FrameParents _parents;
        readonly FrameOrder _order;
        ControlTime? _epoch;
        bool _isChanged, _isHandedOver;

        /// <param name="newPredictor">Creates the predictor of a tracked frame.</param>
        public FrameTree(Func<BodyPredictor> newPredictor)
        {
            _newPredictor = newPredictor;
            _order = new FrameOrder(_frames, _indices);
            _parents = new FrameParents(_order.RootOfLink);
        }

        /// <summary>Number of known frames; an index is valid until another frame replaces the frame.</summary>
        public int Count => _frames.Count;

        public CellFrame this[int index] => _frames[index];

        /// <summary>Whether the next evaluation needs the former places of the frames, because an object has got another parent.</summary>
        public bool IsHandingOver => _isHandedOver;

        /// <summary>Returns the index of a frame; −1 if no pose of it has been received.</summary>
        public int IndexOf(string name) => _order.IndexOf(name);

        /// <summary>Adds a robot, whose links become parents. A frame with the name of its root link moves the robot.</summary>
        public void Add(IRobotLinks robot)
        {
            _order.Add(robot);
            _isChanged = true;
        }

        /// <summary>Adds a received pose.</summary>
        /// <param name="pose">A pose that has been validated, except against the limits of the tree.</param>
        /// <param name="isStationary">Whether the pose comes from /tf_static. The newest message determines whether the frame is stationary.</param>
        /// <param name="replaced">Index of a frame without children that a new frame replaces; −1 if a new frame is added.</param>
        /// <returns>Drop reason; <see cref="DropReason.None"/> if the pose was used.</returns>
        public DropReason Add(in FrameTransform pose, bool isStationary, int replaced = -1)
        {
            var index = IndexOf(pose.Child);
            if (index >= 0 && !isStationary && _frames[index].IsOvertaken(pose))
            {
                _frames[index].Refuse(pose);
                return DropReason.LateSample;
            }
            var reason = TrySetParent(pose, replaced);
            if (reason != DropReason.None)
            {
                if (index >= 0) _frames[index].RefusedParent = pose.Parent;
                return reason;
            }
            if (!isStationary) _epoch ??= pose.Stamp;
            if (index < 0) index = AddFrame(pose.Child, replaced);
            reason = _frames[index].Add(pose, isStationary, _epoch ?? default);
            _isHandedOver |= _frames[index].IsBeingHandedOver;
            return reason;
        }

        DropReason TrySetParent(in FrameTransform pose, int replaced)
        {
            if (replaced < 0) return _parents.TrySet(pose.Child, pose.Parent);
            var former = _frames[replaced].Name;
            var parent = _parents[former];
            _parents.Remove(former);
            var reason = _parents.TrySet(pose.Child, pose.Parent);
            if (reason != DropReason.None) _parents.TrySet(former, parent);
            return reason;
        }

        int AddFrame(string name, int replaced)
        {
            var index = replaced < 0 ? _frames.Count : replaced;
            if (replaced < 0) _frames.Add(null);
            else _indices.Remove(_frames[replaced].Name);
            _indices.Add(name, index);
            _frames[index] = new CellFrame(name, _newPredictor);
            _isChanged = true;
            return index;
        }

        /// <summary>Returns the parent of a frame according to the newest poses; null if none is known.</summary>
        public string ParentOf(string name) => _parents[name];

        /// <summary>Returns whether a frame is the parent of another one, according to the newest poses.</summary>
        public bool HasChildren(string name) => _parents.HasChildren(name);

        /// <summary>Returns the index of a robot; −1 if the cell does not contain it.</summary>
        public int IndexOf(IRobotLinks robot) => _order.IndexOf(robot);

        /// <summary>
        /// Sets the place of an object that a gripper holds or has released, from the next display frame on. The displayed pose changes
        /// smoothly, as after a change of the object's parent.
        /// </summary>
        /// <param name="place">The place; null if the object's own source determines the place again.</param>
        public void Put(int index, ReachPlace place)
        {
            _frames[index].Put(place);
            _isHandedOver = true;
        }

        /// <summary>
        /// Cancels all placements by a gripper: the sources of the objects that it holds or has released determine their places again. Their places are
        /// unknown until these sources report other poses, because the sources may still report the places from before the grip.
        /// </summary>
        public void TakeFrom(ReachGrip gripper)
        {
            for (var i = 0; i < _frames.Count; i++)
                if (_frames[i].Reach?.Gripper == gripper) Lose(i, gripper, since: null);
        }

        /// <inheritdoc cref="CellFrame.Lose"/>
        public void Lose(int index, ReachGrip gripper, ControlTime? since)
        {
            _frames[index].Lose(gripper, since);
            _isHandedOver = true;
        }

        /// <summary>Returns the pose of a frame in the world at a time other than the displayed one.</summary>
        /// <param name="reach">Place that a gripper assigns to the frame; null if the frame's own source determines its place.</param>
        public RigidTransform PoseAt(int index, ReachPlace reach, ControlTime at, out PoseOrigin origin)
        {
            Arrange();
            return _order.PoseAt(index, reach, MomentOf(at), out origin);
        }

        /// <summary>Determines why a frame is an orphan or its parent is not current, and returns the name of the frame above it that is the reason.</summary>
        /// <param name="frame">A frame in one of these two states.</param>
        /// <param name="above">The frame with this name; null if it is unknown or a link.</param>
        /// <param name="robot">The robot whose joints are not current, if the reason is one of its links; otherwise null.</param>
        public string ReasonAbove(CellFrame frame, out CellFrame above, out IRobotLinks robot)
        {
            var state = frame.State;
            var name = frame.Parent;
            above = null;
            robot = null;
            // The steps are limited, because a grip by reach can close a cycle.
            for (var steps = 0; steps < _frames.Count; steps++)
            {
                var isLink = IsLink(name);
                var index = IndexOf(isLink ? _order.RootOfLink(name) : name);
                above = index < 0 ? null : _frames[index];
                if (isLink && (above == null || above.State == FrameState.Current))
                {
                    robot = _order.RobotOfLink(name);
                    above = null;
                    return name;
                }
                if (above == null || above.State != state) return above?.Name ?? name;
                name = above.Parent;
            }
            return name;
        }

        /// <inheritdoc cref="FrameOrder.IsLink"/>
        public bool IsLink(string name) => _order.IsLink(name);

        /// <summary>
        /// Returns whether a robot carries a frame, also on other frames, according to the sources of the frames. An object on a link that does not move,
        /// such as a table in the robot's description, is not carried.
        /// </summary>
        public bool IsCarried(int index) => _order.IsCarried(index);

        /// <summary>Returns the pose of a robot's link in the world at a time other than the displayed one.</summary>
        public RigidTransform LinkAt(int robot, int link, ControlTime at, out PoseOrigin origin)
        {
            Arrange();
            return _order.LinkAt(robot, link, MomentOf(at), out origin);
        }

        /// <summary>Returns whether a robot stands on a frame, which therefore cannot be in its gripper.</summary>
        public bool IsBelow(int robot, int index)
        {
            Arrange();
            return _order.IsBelow(robot, index);
        }

        /// <summary>Computes the poses of all frames; call it after the robots have computed theirs.</summary>
        /// <param name="at">Display time; null while it is unknown. Tracked frames and robots then have their newest poses.</param>
        public void Evaluate(ControlTime? at)
        {
            if (at.HasValue) _epoch ??= at;
            var time = at.HasValue ? MomentOf(at.Value).Seconds : double.NaN;
            if (_isHandedOver) HandOver(time);
            Arrange();
            EvaluateAll(time);
            WatchCarriers(at);
        }

        /// <summary>
        /// Returns the pose of a frame in the world that a display without compensation shows. It is computed from the newest poses and samples.
        /// </summary>
        /// <param name="index">Index of the frame, known before the last <see cref="Evaluate"/>.</param>
        public RigidTransform HeldOf(int index) => _order.HeldOf(index);

        /// <summary>Discards all poses of tracked frames, because their times are no longer valid. The displayed poses are kept.</summary>
        public void Reset()
        {
            _isHandedOver = false;
            foreach (var frame in _frames)
            {
                frame.Reset();
                _isHandedOver |= frame.IsBeingHandedOver;
            }
            _epoch = null;
            _isChanged = true;
        }

        /// <summary>Returns the frame that has the name of a robot's root link, and therefore places the robot; null if there is none.</summary>
        public CellFrame RootOf(IRobotLinks robot) => _order.RootOf(_order.IndexOf(robot));

        (ControlTime Time, double Seconds) MomentOf(ControlTime at) => (at, ClockTicks.Seconds(at - (_epoch ?? at)));

        void Arrange()
        {
            if (_isChanged) _order.Arrange();
            _isChanged = false;
        }

        // Evaluates the frames in the former structure first, because each frame continues from its pose there.
        void HandOver(double time)
        {
            EvaluateAll(time);
            foreach (var frame in _frames)
                if (frame.IsBeingHandedOver) frame.ChangeParent(_epoch ?? default);
            _isHandedOver = false;
            _isChanged = true;
        }

        void WatchCarriers(ControlTime? at)
        {
            for (var i = 0; i < _frames.Count; i++)
                if (_frames[i].IsAwayFromCarrier && _order.HeldSourceParentOf(i) is RigidTransform carrier) _frames[i].WatchCarrier(carrier, at);
        }

        void EvaluateAll(double time)
        {
            foreach (var place in _order.Places)
            {
                var frame = _frames[place.Frame];
                if (_order.TryFindParent(place, out var parent, out var isCurrent, out var isFixed)) frame.Evaluate(time, parent, isCurrent, isFixed);
                else frame.Orphan();
            }
        }
    }
}
