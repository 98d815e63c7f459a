namespace Nowpose.Headless.Tests.Ros;

/// <summary>Version of rosbridge that a <see cref="RosbridgeDouble"/> simulates.</summary>
public enum RosFlavour
{
    /// <summary>rosbridge_suite 0.11 (branch ros1): times have secs and nsecs; each service call has its own thread.</summary>
    Ros1,

    /// <summary>rosbridge_suite 2 (branch ros2): times have sec and nanosec; service calls run in the client's thread.</summary>
    Ros2,
}
