using System;
using System.Collections.Generic;
using Nowpose.Kinematics;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;

namespace Nowpose.Frames
{
    /// <summary>The order in which frames are evaluated, parents first, and where each one finds its parent's pose.</summary>
    sealed class FrameOrder
    {
        readonly List<CellFrame> _frames;
        readonly Dictionary<string, int> _indices;
        readonly List<IRobotLinks> _robots;
        readonly List<int> _roots = new List<int>();
        Place[] _places = Array.Empty<Place>();
        bool[] _isPlaced = Array.Empty<bool>();
        int _count;

        public FrameOrder(List<CellFrame> frames, Dictionary<string, int> indices, List<IRobotLinks> robots)
        {
            _frames = frames;
            _indices = indices;
            _robots = robots;
        }

        /// <summary>All frames, a parent before its children.</summary>
        public ReadOnlySpan<Place> Places => new ReadOnlySpan<Place>(_places, 0, _count);

        /// <summary>Finds all parents again, after a change of the structure.</summary>
        public void Arrange()
        {
            _roots.Clear();
            foreach (var robot in _robots) _roots.Add(IndexOf(RootNameOf(robot)));
            if (_places.Length < _frames.Count) (_places, _isPlaced) = (new Place[2 * _frames.Count], new bool[2 * _frames.Count]);
            Array.Clear(_isPlaced, 0, _isPlaced.Length);
            _count = 0;
            for (var i = 0; i < _frames.Count; i++) Put(i);
        }

        /// <returns>False if the parent is unknown.</returns>
        public bool TryFindParent(in Place place, out RigidTransform pose, out bool isCurrent)
        {
            (pose, isCurrent) = (RigidTransform.Identity, true);
            if (place.Robot >= 0)
            {
                var robot = _robots[place.Robot];
                pose = RootOf(place.Robot, out isCurrent) * robot.Poses[place.Parent];
                isCurrent &= robot.IsCurrent;
                return true;
            }
            if (place.Parent < 0) return place.IsInWorld;
            pose = _frames[place.Parent].World;
            isCurrent = _frames[place.Parent].State == FrameState.Current;
            return true;
        }

        /// <summary>Returns the pose of a robot's root link in the world, and whether it is current.</summary>
        /// <param name="robot">Index of the robot; one that was added after the last arrangement is in the world's origin.</param>
        public RigidTransform RootOf(int robot, out bool isCurrent)
        {
            var root = robot < _roots.Count ? _roots[robot] : -1;
            isCurrent = root < 0 || _frames[root].State == FrameState.Current;
            return root < 0 ? RigidTransform.Identity : _frames[root].World;
        }

        /// <summary>Returns the root link of the robot to which a link belongs; null for a frame that is not a link.</summary>
        public string RootOfLink(string frame) => TryFindLink(frame, out var robot, out _) ? RootNameOf(_robots[robot]) : null;

        void Put(int index)
        {
            if (_isPlaced[index]) return;
            _isPlaced[index] = true;
            var parent = _frames[index].Parent;
            Place place;
            // A frame with the name of a link, such as a robot's root, has a pose of its own.
            if (parent == FrameParents.World) place = new Place(index, -1, -1, isInWorld: true);
            else if (IndexOf(parent) is int known && known >= 0)
            {
                Put(known);
                place = new Place(index, known, -1, isInWorld: false);
            }
            else if (TryFindLink(parent, out var robot, out var link))
            {
                if (_roots[robot] >= 0) Put(_roots[robot]);
                place = new Place(index, link, robot, isInWorld: false);
            }
            else place = new Place(index, -1, -1, isInWorld: false);
            _places[_count++] = place;
        }

        bool TryFindLink(string frame, out int robot, out int link)
        {
            link = -1;
            for (robot = 0; robot < _robots.Count; robot++)
            {
                var prefix = RobotTopic.Qualified(_robots[robot].Namespace, "");
                if (!frame.StartsWith(prefix, StringComparison.Ordinal)) continue;
                link = _robots[robot].Robot.IndexOfLink(frame.Substring(prefix.Length));
                if (link >= 0) return true;
            }
            return false;
        }

        /// <summary>Returns the index of a frame; −1 if it is unknown.</summary>
        public int IndexOf(string name) => _indices.TryGetValue(name, out var index) ? index : -1;

        static string RootNameOf(IRobotLinks robot) => RobotTopic.Qualified(robot.Namespace, robot.Robot.Root.Name);

        /// <summary>A frame and its parent.</summary>
        public readonly struct Place
        {
            public Place(int frame, int parent, int robot, bool isInWorld)
            {
                Frame = frame;
                Parent = parent;
                Robot = robot;
                IsInWorld = isInWorld;
            }

            public int Frame { get; }

            /// <summary>Index of the parent frame, or of the link if <see cref="Robot"/> is set; −1 for the world and for an unknown parent.</summary>
            public int Parent { get; }

            /// <summary>Index of the robot whose link is the parent; −1 for none.</summary>
            public int Robot { get; }

            public bool IsInWorld { get; }
        }
    }
}
