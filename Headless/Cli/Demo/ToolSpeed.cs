namespace Nowpose.Cli.Demo;

/// <summary>How fast the real tool moves, by a central difference over 2 ms.</summary>
sealed class ToolSpeed(DemoRun run)
{
    static readonly TimeSpan Half = TimeSpan.FromMilliseconds(1);

    readonly ToolKinematics _kinematics = new(run.Settings.Robot);
    readonly double[] _joints = new double[run.Settings.Robot.MovingJoints.Count];

    /// <summary>mm/s.</summary>
    public double At(ControlTime t) => PositionAt(t + Half).DistanceMm(PositionAt(t - Half)) / (2 * Half.TotalSeconds);

    ToolPosition PositionAt(ControlTime t)
    {
        run.Truth.JointsAt(t, _joints);
        return _kinematics.At(_joints);
    }
}
