namespace Nowpose.Headless.Tests.Ros;

/// <summary>The version of rosbridge that a <see cref="RosbridgeDouble"/> simulates.</summary>
public enum RosFlavour
{
    /// <summary>rosbridge_suite 0.11 (branch ros1): times as secs and nsecs, one thread per service call.</summary>
    Ros1,

    /// <summary>rosbridge_suite 2 (branch ros2): times as sec and nanosec, service calls in the client's own thread.</summary>
    Ros2,
}
