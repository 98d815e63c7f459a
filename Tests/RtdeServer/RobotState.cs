namespace Nowpose.RtdeServer;

/// <summary>The controller's state in one control cycle.</summary>
sealed class RobotState
{
    /// <summary>Seconds since the controller was started.</summary>
    public double Timestamp;

    /// <summary>Measured and commanded motion.</summary>
    public readonly ArmState Actual = new(), Target = new();

    public ulong DigitalInputs, DigitalOutputs;
    public RuntimeState Runtime = RuntimeState.Playing;
    public SafetyMode Safety = SafetyMode.Normal;
}

/// <summary>The motion of the arm in one control cycle.</summary>
sealed class ArmState
{
    public readonly double[] Positions = new double[6];
    public readonly double[] Velocities = new double[6];
    public readonly double[] Accelerations = new double[6];

    /// <summary>Position in metres and rotation vector in radians.</summary>
    public readonly double[] ToolPose = new double[6];
}

/// <summary>State of the robot's program, as numbered by RTDE.</summary>
enum RuntimeState
{
    Stopped = 1,
    Playing = 2,
}

/// <summary>Safety modes that the server can be in.</summary>
enum SafetyMode
{
    Normal = 1,
    ProtectiveStop = 3,
}
