using System.Diagnostics;
using Nowpose.Kinematics;
using Nowpose.Motion;

namespace Nowpose.RtdeServer;

/// <summary>Simulates the robot of the server: its clock, its motion and its state.</summary>
sealed class Controller
{
    /// <summary>Step of the difference quotients for velocities and accelerations, in s.</summary>
    const double Step = 1e-4;

    /// <summary>Delay of the arm behind the commanded positions, in s.</summary>
    const double Lag = 0.006;

    readonly RobotModel _robot;
    readonly PickAndPlaceMotion _motion;
    readonly ForwardKinematics _kinematics;
    readonly RigidTransform[] _links;
    readonly double _rate;
    readonly double[] _before = new double[6], _after = new double[6];
    long _started;
    double _uptimeSeconds;
    double? _stoppedAt;
    double _stoppedSeconds;

    /// <param name="ppm">Rate of the controller's clock minus that of this machine's counter, ppm.</param>
    /// <param name="uptimeSeconds">Time of the clock at startup.</param>
    public Controller(RobotModel robot, double ppm, double uptimeSeconds)
    {
        _robot = robot;
        _motion = new PickAndPlaceMotion(robot);
        _kinematics = new ForwardKinematics(robot);
        _links = new RigidTransform[robot.Links.Count];
        _rate = 1 + ppm / 1e6;
        _uptimeSeconds = uptimeSeconds;
        _started = Stopwatch.GetTimestamp();
    }

    /// <summary>Current time of the controller's clock, s.</summary>
    public double Now => _uptimeSeconds + Stopwatch.GetElapsedTime(_started).TotalSeconds * _rate;

    /// <summary>Returns the time on this machine until the clock shows a time.</summary>
    public TimeSpan Until(double timestamp) => TimeSpan.FromSeconds((timestamp - Now) / _rate);

    /// <summary>
    /// Gets the time of the clock, in ns, at the zero of this machine's monotonic counter, and the rate of the clock relative to the counter.
    /// </summary>
    public (double ZeroNs, double Rate) ClockLine =>
        (_uptimeSeconds * 1e9 - _started * (1e9 / Stopwatch.Frequency) * _rate, _rate);

    public SafetyMode Safety { get; private set; } = SafetyMode.Normal;

    public RuntimeState Runtime { get; private set; } = RuntimeState.Playing;

    /// <summary>Restarts at zero, as after a power cycle of the controller.</summary>
    public void Restart()
    {
        _uptimeSeconds = 0;
        _started = Stopwatch.GetTimestamp();
        _stoppedAt = null;
        _stoppedSeconds = 0;
        (Safety, Runtime) = (SafetyMode.Normal, RuntimeState.Playing);
    }

    /// <summary>Stops the arm and its program.</summary>
    public void Stop(SafetyMode safety)
    {
        _stoppedAt ??= Now;
        (Safety, Runtime) = (safety, RuntimeState.Stopped);
    }

    /// <summary>Continues the motion from where it was stopped.</summary>
    public void Resume()
    {
        if (_stoppedAt is { } since) _stoppedSeconds += Now - since;
        _stoppedAt = null;
        (Safety, Runtime) = (SafetyMode.Normal, RuntimeState.Playing);
    }

    /// <summary>Writes the state that the robot has at a given time of its clock.</summary>
    public void Read(double timestamp, RobotState state)
    {
        var seconds = Math.Max((_stoppedAt ?? timestamp) - _stoppedSeconds, 0);
        state.Timestamp = timestamp;
        state.Safety = Safety;
        state.Runtime = Runtime;
        ReadMotion(seconds, state.Actual);
        ReadMotion(_stoppedAt == null ? seconds + Lag : seconds, state.Target);

        // The gripper is closed for the second half of each cycle.
        state.DigitalOutputs = seconds % _motion.CycleSeconds > _motion.CycleSeconds / 2 ? 1UL : 0;
        state.DigitalInputs = state.DigitalOutputs ^ 1;
    }

    void ReadMotion(double seconds, ArmState arm)
    {
        _motion.At(seconds, arm.Positions);
        _motion.At(seconds - Step, _before);
        _motion.At(seconds + Step, _after);
        for (var i = 0; i < 6; i++)
        {
            arm.Velocities[i] = _stoppedAt == null ? (_after[i] - _before[i]) / (2 * Step) : 0;
            arm.Accelerations[i] = _stoppedAt == null ? (_after[i] - 2 * arm.Positions[i] + _before[i]) / (Step * Step) : 0;
        }

        _kinematics.Compute(arm.Positions, _links);
        RotationVector.Write(_links[_robot.IndexOfLink("tool0")], arm.ToolPose);
    }
}
