namespace Nowpose.Unity
{
    /// <summary>Selects the pose that a rig or object shows.</summary>
    public enum RigPose
    {
        /// <summary>The pose at the display time.</summary>
        Displayed,

        /// <summary>The pose of the newest samples, without compensation.</summary>
        Held,
    }
}
