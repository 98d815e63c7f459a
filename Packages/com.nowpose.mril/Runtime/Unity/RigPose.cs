namespace Nowpose.Unity
{
    /// <summary>Which of a frame's two poses a rig shows.</summary>
    public enum RigPose
    {
        /// <summary>Where the robot is when the light reaches the eye.</summary>
        Displayed,

        /// <summary>The newest samples as they came: what a headset without compensation shows.</summary>
        Held,
    }
}
