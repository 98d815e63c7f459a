using System;
using System.Collections.Generic;
using Nowpose.Messages;

namespace Nowpose.Kinematics
{
    /// <summary>A robot as a tree of links: the checked and ordered content of a URDF. Immutable, so any thread may use it.</summary>
    public sealed class RobotModel
    {
        readonly MimicStep[] _mimics;
        readonly Dictionary<string, int> _linkIndices = new Dictionary<string, int>(StringComparer.Ordinal);
        readonly Dictionary<string, int> _movingIndices = new Dictionary<string, int>(StringComparer.Ordinal);

        internal RobotModel(
            string name, string sourceHash, RobotLink[] links, RobotJoint[] joints, MimicStep[] mimics, RobotLink toolLink)
        {
            Name = name;
            SourceHash = sourceHash;
            Links = links;
            Joints = joints;
            MovingJoints = Array.FindAll(joints, joint => joint.Kind != JointKind.Fixed);
            ToolLink = toolLink;
            _mimics = mimics;
            for (var i = 0; i < links.Length; i++) _linkIndices.Add(links[i].Name, i);
            foreach (var joint in MovingJoints) _movingIndices.Add(joint.Name, joint.MovingIndex);
            FlangeLink = toolLink;
            while (FlangeLink.ParentIndex >= 0 && FlangeLink.ParentJoint.Kind == JointKind.Fixed) FlangeLink = links[FlangeLink.ParentIndex];
        }

        /// <summary>Name of the robot; empty if the URDF specifies none.</summary>
        public string Name { get; }

        /// <summary>Hash of the URDF, to check whether another URDF describes the same robot.</summary>
        internal string SourceHash { get; }

        /// <summary>The links, with the root first and parents before their children.</summary>
        public IReadOnlyList<RobotLink> Links { get; }

        /// <summary>All joints, in the order of the URDF.</summary>
        public IReadOnlyList<RobotJoint> Joints { get; }

        /// <summary>The joints that are not fixed, including mimic joints, in the order of the URDF: one position each, in rad or m.</summary>
        public IReadOnlyList<RobotJoint> MovingJoints { get; }

        public RobotLink Root => Links[0];

        /// <summary>
        /// Link of the tool: the first existing one of <c>tool_centre_point</c>, <c>tool0</c> and <c>flange</c>. If none exists, the leaf with the
        /// most moving joints above it (the first in the URDF if there are several).
        /// </summary>
        public RobotLink ToolLink { get; }

        /// <summary>
        /// Link on which a tool is mounted: the child of the last moving joint before <see cref="ToolLink"/>; the root if no joint moves.
        /// </summary>
        public RobotLink FlangeLink { get; }

        /// <summary>Returns the index of a link in <see cref="Links"/>; -1 if the robot does not have the link.</summary>
        public int IndexOfLink(string name) => _linkIndices.TryGetValue(name, out var index) ? index : -1;

        /// <summary>Returns the index of a joint in <see cref="MovingJoints"/>; -1 if the joint does not exist or is fixed.</summary>
        public int IndexOfMovingJoint(string name) => _movingIndices.TryGetValue(name, out var index) ? index : -1;

        /// <summary>Returns whether a joint moves a link relative to a given link that is above it in the tree.</summary>
        internal bool HasMovingJointBelow(RobotLink link)
        {
            foreach (var joint in MovingJoints)
                for (var at = IndexOfLink(joint.ParentLink); at >= 0; at = Links[at].ParentIndex)
                    if (Links[at] == link) return true;
            return false;
        }

        /// <summary>Returns the joint that determines the position of a mimic joint, at the end of its chain of mimic joints; for another joint, itself.</summary>
        internal RobotJoint MasterOf(RobotJoint joint)
        {
            while (joint.Mimic != null) joint = MovingJoints[IndexOfMovingJoint(joint.Mimic.Master)];
            return joint;
        }

        /// <summary>Computes the position of each mimic joint without a given position from the position of its master; allocates nothing.</summary>
        /// <param name="positions">One per moving joint, in rad or m.</param>
        /// <param name="given">One per moving joint: whether its position is given and must not be changed.</param>
        public void CompleteMimics(Span<double> positions, ReadOnlySpan<bool> given)
        {
            RequireOnePerMovingJoint(positions.Length, nameof(positions));
            RequireOnePerMovingJoint(given.Length, nameof(given));
            foreach (ref readonly var mimic in _mimics.AsSpan())
            {
                if (!given[mimic.Joint])
                    positions[mimic.Joint] = mimic.Multiplier * positions[mimic.Master] + mimic.Offset;
            }
        }

        internal void RequireOnePerMovingJoint(int length, string argument)
        {
            if (length != MovingJoints.Count)
                throw new ArgumentException(RobotMessages.ValueCount(length, MovingJoints.Count), argument);
        }
    }
}
