using System;
using System.Collections.Generic;
using Nowpose.Kinematics;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;

namespace Nowpose.Frames
{
    /// <summary>Determines the order in which frames are evaluated, parents first, and the source of each parent's pose.</summary>
    sealed class FrameOrder
    {
        readonly List<CellFrame> _frames;
        readonly Dictionary<string, int> _indices;
        readonly List<IRobotLinks> _robots = new List<IRobotLinks>();
        readonly List<string> _rootNames = new List<string>();
        // The links by their qualified names. The names are stored, because composing a name allocates memory.
        readonly Dictionary<string, (int Robot, int Link)> _links = new Dictionary<string, (int, int)>(StringComparer.Ordinal);
        readonly List<int> _roots = new List<int>();
        Place[] _places = Array.Empty<Place>();
        int[] _placeOf = Array.Empty<int>();
        bool[] _isPlaced = Array.Empty<bool>();
        int _count;

        public FrameOrder(List<CellFrame> frames, Dictionary<string, int> indices) => (_frames, _indices) = (frames, indices);

        /// <summary>Adds a robot, whose links become parents.</summary>
        public void Add(IRobotLinks robot)
        {
            for (var link = 0; link < robot.Robot.Links.Count; link++)
                _links.TryAdd(RobotTopic.Qualified(robot.Namespace, robot.Robot.Links[link].Name), (_robots.Count, link));
            _robots.Add(robot);
            _rootNames.Add(RobotTopic.Qualified(robot.Namespace, robot.Robot.Root.Name));
        }

        /// <summary>Returns the index of a robot; −1 if the cell does not contain it.</summary>
        public int IndexOf(IRobotLinks robot) => _robots.IndexOf(robot);

        /// <summary>All frames, a parent before its children.</summary>
        public ReadOnlySpan<Place> Places => new ReadOnlySpan<Place>(_places, 0, _count);

        /// <summary>Determines all parents and the order again after a change of the structure.</summary>
        public void Arrange()
        {
            _roots.Clear();
            foreach (var root in _rootNames) _roots.Add(IndexOf(root));
            if (_places.Length < _frames.Count)
                (_places, _placeOf, _isPlaced) = (new Place[2 * _frames.Count], new int[2 * _frames.Count], new bool[2 * _frames.Count]);
            Array.Clear(_isPlaced, 0, _isPlaced.Length);
            Array.Fill(_placeOf, -1);
            _count = 0;
            for (var i = 0; i < _frames.Count; i++) Put(i);
        }

        /// <param name="isFixed">Whether the parent has the same pose at any display time.</param>
        /// <returns>False if the parent, or a frame above it, is unknown or has never had a pose.</returns>
        public bool TryFindParent(in Place place, out RigidTransform pose, out bool isCurrent, out bool isFixed)
        {
            (pose, isCurrent, isFixed) = (RigidTransform.Identity, true, place.Robot < 0 || !IsMovedByJoints(place.Robot, place.Parent));
            // Without a frame of its root link, a robot is at the world's origin.
            var above = place.Robot < 0 ? place.Parent : RootIndexOf(place.Robot);
            if (above >= 0)
            {
                var frame = _frames[above];
                if (!frame.IsPlaced) return false;
                (pose, isCurrent) = (frame.World, frame.State == FrameState.Current);
                isFixed &= frame.IsFixed;
            }
            if (place.Robot < 0) return above >= 0 || place.IsInWorld;
            pose *= _robots[place.Robot].Poses[place.Parent];
            isCurrent &= _robots[place.Robot].IsCurrentAt(place.Parent);
            return true;
        }

        /// <summary>Returns the frame that places a robot; null if there is none.</summary>
        /// <param name="robot">Index of the robot. A robot that was added after the last arrangement has no such frame.</param>
        public CellFrame RootOf(int robot)
        {
            var root = RootIndexOf(robot);
            return root < 0 ? null : _frames[root];
        }

        /// <summary>Returns the pose of a frame in the world, computed from the newest poses and joint positions of its ancestors.</summary>
        /// <param name="frame">Index of the frame, known at the last arrangement.</param>
        /// <returns>The displayed pose if the parent is unknown.</returns>
        public RigidTransform HeldOf(int frame) =>
            HeldParentOf(_places[_placeOf[frame]]) is RigidTransform parent ? parent * _frames[frame].Held : _frames[frame].World;

        /// <summary>Returns the same for the parent that a frame's source names; null if it is unknown.</summary>
        public RigidTransform? HeldSourceParentOf(int frame) => HeldParentOf(PlaceIn(frame, _frames[frame].SourceParent));

        RigidTransform? HeldParentOf(in Place place)
        {
            if (place.IsInWorld) return RigidTransform.Identity;
            if (place.Robot < 0) return place.Parent < 0 ? (RigidTransform?)null : HeldOf(place.Parent);
            var root = _roots[place.Robot];
            var link = _robots[place.Robot].HeldPoses[place.Parent];
            return root < 0 ? link : HeldOf(root) * link;
        }

        /// <summary>Returns the pose of a frame in the world at a time other than the displayed one.</summary>
        /// <param name="frame">Index of the frame, known at the last arrangement.</param>
        /// <param name="at">The time on the control clock, and in seconds since the epoch of the predictors.</param>
        /// <param name="reach">Place that a gripper assigns to the frame; null if the frame's own source determines its place.</param>
        public RigidTransform PoseAt(int frame, ReachPlace reach, (ControlTime Time, double Seconds) at, out PoseOrigin origin) =>
            PoseAt(frame, reach, at, out origin, 0);

        // Ends after as many steps as there are frames, because the steps through a cycle would never end. A frame in a cycle has no pose.
        RigidTransform PoseAt(int frame, ReachPlace reach, (ControlTime Time, double Seconds) at, out PoseOrigin origin, int steps)
        {
            origin = PoseOrigin.None;
            if (steps > _frames.Count) return _frames[frame].World;
            origin = PoseOrigin.Measured;
            var pose = reach != null ? reach.Pose : _frames[frame].PoseAt(at.Seconds, out origin);
            var place = PlaceIn(frame, reach?.Parent ?? _frames[frame].SourceParent);
            if (place.IsInWorld) return pose;
            var above = PoseOrigin.None;
            if (place.Robot >= 0) pose = LinkAt(place.Robot, place.Parent, at, out above, steps + 1) * pose;
            else if (place.Parent >= 0) pose = PoseAt(place.Parent, _frames[place.Parent].Reach, at, out above, steps + 1) * pose;
            origin = OriginOn(above, origin);
            return pose;
        }

        // A frame whose source has stopped may have moved on with all that is on it.
        static PoseOrigin OriginOn(PoseOrigin parent, PoseOrigin origin) =>
            parent == PoseOrigin.Held ? PoseOrigin.None : parent < origin ? parent : origin;

        /// <summary>Returns the pose of a robot's link in the world at a time other than the displayed one.</summary>
        public RigidTransform LinkAt(int robot, int link, (ControlTime Time, double Seconds) at, out PoseOrigin origin) =>
            LinkAt(robot, link, at, out origin, 0);

        RigidTransform LinkAt(int robot, int link, (ControlTime Time, double Seconds) at, out PoseOrigin origin, int steps)
        {
            var pose = _robots[robot].PoseAt(link, at.Time, out origin);
            var root = RootIndexOf(robot);
            if (root < 0) return pose;
            pose = PoseAt(root, _frames[root].Reach, at, out var below, steps) * pose;
            origin = OriginOn(below, origin);
            return pose;
        }

        /// <summary>Returns whether a robot stands on a frame, so that its links move with it.</summary>
        public bool IsBelow(int robot, int frame)
        {
            for (var at = RootIndexOf(robot); at >= 0;)
            {
                if (at == frame) return true;
                var place = _places[_placeOf[at]];
                at = place.Robot >= 0 ? RootIndexOf(place.Robot) : place.Parent;
            }
            return false;
        }

        // Also returns −1 for a robot that was added after the last arrangement.
        int RootIndexOf(int robot) => robot >= 0 && robot < _roots.Count ? _roots[robot] : -1;

        /// <summary>Returns whether a frame moves with the displayed robot, because it is one of the robot's links.</summary>
        /// <remarks>
        /// This is also true if a source publishes the frame, as ROS publishes all links on /tf. Only a published root link has its own pose, which places
        /// the robot.
        /// </remarks>
        public bool IsLink(string name) => _links.TryGetValue(name, out var link) && (IndexOf(name) < 0 || name != _rootNames[link.Robot]);

        /// <summary>Returns whether a frame is a link that a joint of its robot can move relative to the robot's root link.</summary>
        bool IsMovedByJoints(string name)
        {
            if (name == FrameParents.World || !IsLink(name)) return false;
            var (robot, link) = _links[name];
            return IsMovedByJoints(robot, link);
        }

        /// <summary>Returns whether the joints of a robot move a frame, or a frame above it, according to the sources of these frames.</summary>
        public bool IsCarried(int frame)
        {
            // The steps are limited, because a robot whose description arrives after the frames can close a cycle.
            for (var steps = 0; frame >= 0 && steps <= _frames.Count; steps++)
            {
                var parent = _frames[frame].SourceParent;
                if (IsMovedByJoints(parent)) return true;
                frame = IndexOf(RootOfLink(parent) ?? parent);
            }
            return false;
        }

        bool IsMovedByJoints(int robot, int index)
        {
            var links = _robots[robot].Robot.Links;
            for (var link = links[index]; link.ParentIndex >= 0; link = links[link.ParentIndex])
                if (link.ParentJoint.MovingIndex >= 0) return true;
            return false;
        }

        /// <summary>Returns the robot to which a link belongs; null for a frame that is not a link.</summary>
        public IRobotLinks RobotOfLink(string frame) => _links.TryGetValue(frame, out var link) ? _robots[link.Robot] : null;

        /// <summary>Returns the root link of the robot to which a link belongs; null for a frame that is not a link.</summary>
        public string RootOfLink(string frame) => _links.TryGetValue(frame, out var link) ? _rootNames[link.Robot] : null;

        void Put(int index)
        {
            if (_isPlaced[index]) return;
            _isPlaced[index] = true;
            var place = PlaceIn(index, _frames[index].Parent);
            var above = place.Robot < 0 ? place.Parent : _roots[place.Robot];
            if (above >= 0) Put(above);
            // A ReachGrip can close a cycle, and so can a robot whose description arrives after the frames. One frame of the cycle then has no
            // parent.
            if (above >= 0 && _placeOf[above] < 0) place = new Place(index, -1, -1, isInWorld: false);
            _placeOf[index] = _count;
            _places[_count++] = place;
        }

        Place PlaceIn(int index, string parent)
        {
            if (parent == FrameParents.World) return new Place(index, -1, -1, isInWorld: true);
            if (!IsLink(parent)) return new Place(index, IndexOf(parent), -1, isInWorld: false);
            var link = _links[parent];
            return new Place(index, link.Link, link.Robot, isInWorld: false);
        }

        /// <summary>Returns the index of a frame; −1 if it is unknown.</summary>
        public int IndexOf(string name) => _indices.TryGetValue(name, out var index) ? index : -1;

        /// <summary>A frame and its parent.</summary>
        public readonly struct Place
        {
            public Place(int frame, int parent, int robot, bool isInWorld) => (Frame, Parent, Robot, IsInWorld) = (frame, parent, robot, isInWorld);

            public int Frame { get; }

            /// <summary>
            /// Index of the parent frame, or of the link if <see cref="Robot"/> is set; −1 for the world and for an unknown parent.
            /// </summary>
            public int Parent { get; }

            /// <summary>Index of the robot whose link is the parent; −1 if the parent is not a link.</summary>
            public int Robot { get; }

            public bool IsInWorld { get; }
        }
    }
}
