namespace Nowpose.Unity
{
    /// <summary>The pose of a frame that a rig shows.</summary>
    public enum RigPose
    {
        /// <summary>The robot's pose at the display time.</summary>
        Displayed,

        /// <summary>The newest samples unchanged, as without compensation.</summary>
        Held,
    }
}
