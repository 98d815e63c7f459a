namespace Nowpose.Kinematics
{
    /// <summary>Kind of motion of a joint. Positions are in radians, or in metres for <see cref="Prismatic"/>.</summary>
    public enum JointKind
    {
        Fixed,
        Revolute,

        /// <summary>A revolute joint without position limits.</summary>
        Continuous,
        Prismatic,
    }

    /// <summary>The connection of a link to its parent.</summary>
    public sealed class RobotJoint
    {
        internal RobotJoint(
            string name, JointKind kind, string parentLink, string childLink, int movingIndex,
            in RigidTransform origin, (double X, double Y, double Z) axis, in JointLimits limits, JointMimic mimic)
        {
            Name = name;
            Kind = kind;
            ParentLink = parentLink;
            ChildLink = childLink;
            MovingIndex = movingIndex;
            Origin = origin;
            Axis = axis;
            Limits = limits;
            Mimic = mimic;
        }

        public string Name { get; }
        public JointKind Kind { get; }
        public string ParentLink { get; }
        public string ChildLink { get; }

        /// <summary>
        /// Index of the joint in <see cref="RobotModel.MovingJoints"/>, and of its position in an array of positions; -1 for a fixed joint.
        /// </summary>
        public int MovingIndex { get; }

        /// <summary>The joint's frame in the parent link's frame, which is also the child link's pose at position 0.</summary>
        public RigidTransform Origin { get; }

        /// <summary>
        /// Unit vector in the joint's own frame. Positive positions turn about it by the right-hand rule, or slide along it. Undefined for a
        /// fixed joint.
        /// </summary>
        public (double X, double Y, double Z) Axis { get; }

        /// <summary>Limits of the joint; <see cref="JointLimits.None"/> for a fixed joint.</summary>
        public JointLimits Limits { get; }

        /// <summary>Rule by which the joint follows another joint; null if it follows none.</summary>
        public JointMimic Mimic { get; }

        public override string ToString() => Name;
    }

    /// <summary>Rule by which a joint follows another joint: position = multiplier · master's position + offset.</summary>
    public sealed class JointMimic
    {
        internal JointMimic(string master, double multiplier, double offset) => (Master, Multiplier, Offset) = (master, multiplier, offset);

        /// <summary>Name of the joint that is mimicked. It is a moving joint, and may mimic another joint.</summary>
        public string Master { get; }

        public double Multiplier { get; }

        /// <summary>Offset in radians, or in metres if the follower is prismatic.</summary>
        public double Offset { get; }
    }
}
