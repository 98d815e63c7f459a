using System;
using Nowpose.Kinematics;
using Nowpose.Unity.Messages;
using UnityEngine;

namespace Nowpose.Unity.Robot
{
    /// <summary>The transforms of a rig, which are named and nested in the same way as the robot's links, and the drives that move them.</summary>
    sealed class RigHierarchy
    {
        // Tolerance above rounding errors. Unity's == is not used, because it tolerates rotations of a sixth of a degree.
        const float Tolerance = 1e-5f;

        readonly RobotModel _model;
        readonly Transform[] _links;
        readonly JointDrive[] _drives;

        /// <summary>Constructs the hierarchy, and moves all links to joint position 0, and the root link to the rig.</summary>
        /// <param name="links">One transform per link of the model, in the order of the model.</param>
        RigHierarchy(RobotModel model, Transform[] links)
        {
            _model = model;
            _links = links;
            _drives = new JointDrive[model.MovingJoints.Count];
            links[0].Place(RigidTransform.Identity);
            for (var i = 1; i < links.Length; i++)
            {
                var joint = model.Links[i].ParentJoint;
                if (joint.Kind == JointKind.Fixed) links[i].Place(joint.Origin);
                else _drives[joint.MovingIndex] = new JointDrive(links[i], joint);
            }
        }

        public Transform Tool => Link(_model.ToolLink.Name);
        public Transform Flange => Link(_model.FlangeLink.Name);

        /// <summary>Whether all links exist; false if one was destroyed.</summary>
        public bool IsWhole
        {
            get
            {
                foreach (var link in _links)
                    if (link == null) return false;
                return true;
            }
        }

        /// <summary>Returns the transform of a link; null if the robot has no such link.</summary>
        public Transform Link(string name)
        {
            var index = _model.IndexOfLink(name);
            return index < 0 ? null : _links[index];
        }

        /// <summary>Returns the index of the link that is an object or is above it, the nearest one; −1 if there is none.</summary>
        /// <param name="below">An object below the rig.</param>
        /// <param name="place">The transform of the link; null if there is none.</param>
        public int LinkAbove(Transform below, out Transform place)
        {
            for (place = below; !(place is null); place = place.parent)
            {
                var index = Array.IndexOf(_links, place);
                if (index >= 0) return index;
            }
            return -1;
        }

        /// <summary>Moves the links to joint positions.</summary>
        /// <param name="joints">One position per moving joint of the model, in rad or m.</param>
        public void Apply(ReadOnlySpan<double> joints)
        {
            for (var i = 0; i < _drives.Length; i++) _drives[i].Apply(joints[i]);
        }

        /// <summary>Finds the transforms of a robot below a rig.</summary>
        /// <returns>Null if no transform below the rig has the name of the root link, and nothing is drawn below the rig.</returns>
        /// <exception cref="InputException">
        /// The root link exists, but another link is missing, or a link is misplaced or scaled; or the root link is missing, but something is drawn
        /// below the rig.
        /// </exception>
        public static RigHierarchy Find(RobotModel model, Transform rig)
        {
            var root = RootLink(model, rig);
            if (root == null)
            {
                RequireEmpty(model, rig);
                return null;
            }
            var links = new Transform[model.Links.Count];
            links[0] = root;
            RequireUnmoved(model, root, rig);
            for (var i = 1; i < links.Length; i++)
            {
                var link = model.Links[i];
                var parent = links[link.ParentIndex];
                links[i] = Below(parent, link.Name);
                if (links[i] == null) throw Missing(model, link, rig);
                RequireUnmoved(model, links[i], parent);
            }
            return new RigHierarchy(model, links);
        }

        /// <summary>Returns the object below a rig that has the name of the robot's root link; null if there is none. Changes nothing.</summary>
        public static Transform RootLink(RobotModel model, Transform rig) => Below(rig, model.Root.Name);

        /// <summary>
        /// Rejects drawn objects other than tools, because the wearer could mistake another, motionless robot below the rig for this robot.
        /// </summary>
        /// <exception cref="InputException">Something is drawn below the rig.</exception>
        public static void RequireEmpty(RobotModel model, Transform rig)
        {
            for (var i = 0; i < rig.childCount; i++)
                if (IsDrawn(rig.GetChild(i)))
                    throw new InputException(RigMessages.NoRootLink(model.Name, rig.name, model.Root.Name, rig.GetChild(i).name));
        }

        /// <summary>Returns whether something other than tools and other rigs is drawn at or below an object.</summary>
        public static bool IsDrawn(Transform at)
        {
            if (at.TryGetComponent<RobotRig>(out _) || at.TryGetComponent<VirtualGripper>(out _)) return false;
            if (at.TryGetComponent<MeshFilter>(out _)) return true;
            for (var i = 0; i < at.childCount; i++)
                if (IsDrawn(at.GetChild(i))) return true;
            return false;
        }

        // Rejects transformed objects between two links, because the origin of a joint is relative to the parent link, and between the rig and the
        // root link, because the rig is the robot's base frame.
        static void RequireUnmoved(RobotModel model, Transform link, Transform parent)
        {
            for (var at = link.parent; at != parent; at = at.parent)
            {
                if (at.localPosition.magnitude > Tolerance || IsTurned(at.localRotation) || IsScaled(at))
                    throw new InputException(RigMessages.MovedBetween(model.Name, at.name, parent.name, link.name));
            }
            if (IsScaled(link))
                throw new InputException(RigMessages.ScaledLink(model.Name, link.name));
        }

        static bool IsTurned(Quaternion q) => new Vector3(q.x, q.y, q.z).magnitude > Tolerance;

        static bool IsScaled(Transform at) => (at.localScale - Vector3.one).magnitude > Tolerance;

        static InputException Missing(RobotModel model, RobotLink link, Transform rig)
        {
            var joint = link.ParentJoint;
            var where = Below(rig, link.Name) == null ? "is missing" : "is elsewhere";
            return new InputException(RigMessages.MissingLink(model.Name, joint.ParentLink, rig.name, link.Name, joint.Name, where));
        }

        // Does not search below other rigs, because the objects there belong to those rigs.
        static Transform Below(Transform parent, string name)
        {
            for (var i = 0; i < parent.childCount; i++)
            {
                var child = parent.GetChild(i);
                if (child.name == name) return child;
                if (child.TryGetComponent<RobotRig>(out _)) continue;
                var found = Below(child, name);
                if (found != null) return found;
            }
            return null;
        }
    }
}
