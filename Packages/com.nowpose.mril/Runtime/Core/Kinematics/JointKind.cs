namespace Nowpose.Kinematics
{
    /// <summary>How a joint moves. Positions are radians, for <see cref="Prismatic"/> metres.</summary>
    public enum JointKind
    {
        Fixed,
        Revolute,

        /// <summary>Revolute without position limits.</summary>
        Continuous,
        Prismatic,
    }
}
