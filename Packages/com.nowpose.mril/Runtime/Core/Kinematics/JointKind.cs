namespace Nowpose.Kinematics
{
    /// <summary>The motion of a joint. Positions are in radians, for <see cref="Prismatic"/> in metres.</summary>
    public enum JointKind
    {
        Fixed,
        Revolute,

        /// <summary>Revolute without position limits.</summary>
        Continuous,
        Prismatic,
    }
}
