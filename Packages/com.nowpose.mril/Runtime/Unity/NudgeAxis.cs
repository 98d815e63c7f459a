namespace Nowpose.Unity
{
    /// <summary>Axis of the robot's base frame, as in URDF.</summary>
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
