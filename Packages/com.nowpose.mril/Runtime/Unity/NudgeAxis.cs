namespace Nowpose.Unity
{
    /// <summary>An axis of the robot's base frame, as URDF has it.</summary>
    public enum NudgeAxis
    {
        /// <summary>Forward.</summary>
        X,

        /// <summary>To the left.</summary>
        Y,

        /// <summary>Up.</summary>
        Z,
    }
}
