using System;
using System.Collections.Generic;
using Nowpose.Kinematics;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;

namespace Nowpose.Frames
{
    /// <summary>All frames of the cell: stationary and tracked ones, attached to the world, to each other, or to the links of robots.</summary>
    /// <remarks>
    /// The pose of a frame in the world is T_world = T_parent · T, with the parent's pose at the same display time, so that an object whose
    /// parent is a link moves exactly with the displayed robot. Use it on the frame's thread. A display frame allocates nothing, except after
    /// a change of the structure.
    /// </remarks>
    sealed class FrameTree
    {
        readonly Func<BodyPredictor> _newPredictor;
        readonly List<CellFrame> _frames = new List<CellFrame>();
        readonly Dictionary<string, int> _indices = new Dictionary<string, int>(StringComparer.Ordinal);
        readonly List<IRobotLinks> _robots = new List<IRobotLinks>();
        readonly FrameParents _parents;
        readonly FrameOrder _order;
        ControlTime? _epoch;
        bool _isChanged, _isHandedOver;

        /// <param name="newPredictor">Creates the predictor of a tracked frame.</param>
        public FrameTree(Func<BodyPredictor> newPredictor)
        {
            _newPredictor = newPredictor;
            _order = new FrameOrder(_frames, _indices, _robots);
            _parents = new FrameParents(_order.RootOfLink);
        }

        /// <summary>Number of known frames; an index is valid for as long as the tree exists.</summary>
        public int Count => _frames.Count;

        public CellFrame this[int index] => _frames[index];

        /// <summary>Returns the index of a frame; −1 if no pose of it has been received.</summary>
        public int IndexOf(string name) => _order.IndexOf(name);

        /// <summary>Adds a robot, whose links become parents. A frame with the name of its root link moves the robot.</summary>
        public void Add(IRobotLinks robot)
        {
            _robots.Add(robot);
            _isChanged = true;
        }

        /// <summary>Adds a received pose.</summary>
        /// <param name="pose">Validated, apart from the limits of the tree.</param>
        /// <param name="isStationary">Whether it comes from /tf_static. The newest message decides.</param>
        /// <returns>Why it was dropped; <see cref="DropReason.None"/> if it was used.</returns>
        public DropReason Add(in FrameTransform pose, bool isStationary)
        {
            var index = IndexOf(pose.Child);
            if (index >= 0 && !isStationary && _frames[index].Parent != pose.Parent && pose.Stamp <= _frames[index].Newest)
                return DropReason.LateSample;
            var reason = _parents.TrySet(pose.Child, pose.Parent);
            if (reason != DropReason.None) return reason;
            if (!isStationary) _epoch ??= pose.Stamp;
            if (index < 0)
            {
                index = _frames.Count;
                _indices.Add(pose.Child, index);
                _frames.Add(new CellFrame(pose.Child, _newPredictor));
                _isChanged = true;
            }
            reason = _frames[index].Add(pose, isStationary, _epoch ?? default);
            _isHandedOver |= _frames[index].IsBeingHandedOver;
            return reason;
        }

        /// <summary>Computes the poses of all frames; call it after the robots have computed theirs.</summary>
        /// <param name="at">Display time; null while it is unknown: then tracked frames have their newest poses, as the robots do.</param>
        public void Evaluate(ControlTime? at)
        {
            var time = at.HasValue ? ClockTicks.Seconds(at.Value - (_epoch ?? at.Value)) : double.NaN;
            if (_isHandedOver) HandOver(time);
            if (_isChanged) _order.Arrange();
            _isChanged = false;
            EvaluateAll(time);
        }

        /// <summary>Discards all poses of tracked frames, because their times are not valid any more. The displayed poses are kept.</summary>
        public void Reset()
        {
            foreach (var frame in _frames) frame.Reset();
            _epoch = null;
            _isHandedOver = false;
        }

        /// <summary>Returns the displayed pose of a robot's root link in the world; the identity unless a frame has its name.</summary>
        public RigidTransform RootOf(IRobotLinks robot) => _order.RootOf(_robots.IndexOf(robot), out _);

        // The former structure gives the poses from which the frames go on.
        void HandOver(double time)
        {
            EvaluateAll(time);
            foreach (var frame in _frames)
                if (frame.IsBeingHandedOver) frame.ChangeParent(_epoch ?? default);
            _isHandedOver = false;
            _isChanged = true;
        }

        void EvaluateAll(double time)
        {
            foreach (var place in _order.Places)
            {
                var frame = _frames[place.Frame];
                if (_order.TryFindParent(place, out var parent, out var isCurrent)) frame.Evaluate(time, parent, isCurrent);
                else frame.Orphan();
            }
        }
    }
}
