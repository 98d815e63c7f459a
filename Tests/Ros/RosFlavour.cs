namespace Nowpose.Headless.Tests.Ros;

/// <summary>Which rosbridge a <see cref="RosbridgeDouble"/> stands in for.</summary>
public enum RosFlavour
{
    /// <summary>rosbridge_suite 0.11 (branch ros1): times as secs and nsecs, a thread for each service call.</summary>
    Ros1,

    /// <summary>rosbridge_suite 2 (branch ros2): times as sec and nanosec, service calls in the client's own thread.</summary>
    Ros2,
}
