namespace Nowpose.Motion
{
    /// <summary>A motion that takes an object in each cycle and puts it down.</summary>
    interface IGrippingMotion : IMotion
    {
        /// <summary>Time in the cycle at which the gripper takes the object, s. The arm is at rest then.</summary>
        double GripSeconds { get; }

        /// <summary>Time in the cycle at which the gripper puts it down, s; after <see cref="GripSeconds"/>. The arm is at rest then.</summary>
        double ReleaseSeconds { get; }
    }
}
