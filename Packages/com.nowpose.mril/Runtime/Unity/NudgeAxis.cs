namespace Nowpose.Unity
{
    /// <summary>An axis of the robot's base frame in URDF axes.</summary>
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
