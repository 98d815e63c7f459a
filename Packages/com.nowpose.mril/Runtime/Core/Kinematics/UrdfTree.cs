using System;
using System.Collections.Generic;
using System.Linq;
using System.Xml.Linq;
using Nowpose.Messages;

namespace Nowpose.Kinematics
{
    /// <summary>Connects links by joints and checks that they form one tree.</summary>
    sealed class UrdfTree
    {
        static readonly string[] ToolNames = { "tool_centre_point", "tool0", "flange" };

        readonly UrdfSource _source;
        readonly Dictionary<string, UrdfLink> _links = new Dictionary<string, UrdfLink>(StringComparer.Ordinal);
        readonly Dictionary<string, UrdfJoint> _above = new Dictionary<string, UrdfJoint>(StringComparer.Ordinal);
        readonly ILookup<string, UrdfJoint> _below;

        public UrdfTree(UrdfSource source, XElement robot, UrdfLink[] links, UrdfJoint[] joints)
        {
            _source = source;
            if (links.Length == 0) throw source.Error(robot, UrdfMessages.NoLinks);
            foreach (var link in links)
                if (!_links.TryAdd(link.Name, link)) throw source.Error(link.Element, UrdfMessages.LinkTwice);
            foreach (var joint in joints) Connect(joint);
            _below = joints.ToLookup(joint => joint.Joint.ParentLink, StringComparer.Ordinal);
            Links = OrderFromRoot(Root(links));
            var reached = new HashSet<string>(Links.Select(link => link.Name), StringComparer.Ordinal);
            if (Array.Find(links, link => !reached.Contains(link.Name)) is UrdfLink unreached) throw Cycle(unreached);
        }

        /// <summary>The links: the root first, parents before children, children in the order of their joints in the URDF.</summary>
        public RobotLink[] Links { get; }

        /// <param name="links">The links in the order of the URDF; the first of several equal candidates is chosen.</param>
        public RobotLink ToolLink(UrdfLink[] links)
        {
            foreach (var name in ToolNames)
                if (Array.Find(Links, link => link.Name == name) is RobotLink named) return named;
            var depths = MovingJointsAbove();
            var leaves = links.Where(link => !_below.Contains(link.Name));
            var tool = leaves.OrderByDescending(link => depths[link.Name]).First();
            return Array.Find(Links, link => link.Name == tool.Name);
        }

        void Connect(UrdfJoint joint)
        {
            Require(joint, "parent", joint.Joint.ParentLink);
            Require(joint, "child", joint.Joint.ChildLink);
            if (_above.TryGetValue(joint.Joint.ChildLink, out var other))
                throw _source.Error(joint.Element, UrdfMessages.TwoParents(UrdfSource.Quote(joint.Joint.ChildLink), UrdfSource.Quote(other.Joint.Name)));
            _above.Add(joint.Joint.ChildLink, joint);
        }

        void Require(UrdfJoint joint, string role, string link)
        {
            if (!_links.ContainsKey(link))
                throw _source.Error(UrdfSource.Child(joint.Element, role), UrdfMessages.UnknownLink(UrdfSource.Quote(link)));
        }

        UrdfLink Root(UrdfLink[] links)
        {
            var roots = links.Where(link => !_above.ContainsKey(link.Name)).ToArray();
            if (roots.Length == 0) throw Cycle(links[0]);
            if (roots.Length > 1)
                throw _source.Error(roots[1].Element, UrdfMessages.TwoRoots(UrdfSource.Quote(roots[0].Name)));
            return roots[0];
        }

        RobotLink[] OrderFromRoot(UrdfLink root)
        {
            var links = new List<RobotLink>();
            var open = new Stack<(UrdfLink Link, RobotJoint Joint, int Parent)>();
            open.Push((root, null, -1));
            while (open.Count > 0)
            {
                var (link, joint, parent) = open.Pop();
                foreach (var child in _below[link.Name].Reverse())
                    open.Push((_links[child.Joint.ChildLink], child.Joint, links.Count));
                links.Add(new RobotLink(link.Name, joint, parent, link.Visuals));
            }
            return links.ToArray();
        }

        // The path upwards from a link that the root does not reach ends in the cycle.
        InputException Cycle(UrdfLink unreached)
        {
            var passed = new HashSet<string>();
            var link = unreached.Name;
            while (passed.Add(link)) link = _above[link].Joint.ParentLink;
            return _source.Error(_above[link].Element, UrdfMessages.Cycle(UrdfSource.Quote(link)));
        }

        Dictionary<string, int> MovingJointsAbove()
        {
            var depths = new Dictionary<string, int>(StringComparer.Ordinal);
            foreach (var link in Links)
            {
                var moves = link.ParentJoint != null && link.ParentJoint.Kind != JointKind.Fixed ? 1 : 0;
                depths.Add(link.Name, link.ParentIndex < 0 ? 0 : depths[Links[link.ParentIndex].Name] + moves);
            }
            return depths;
        }
    }
}
