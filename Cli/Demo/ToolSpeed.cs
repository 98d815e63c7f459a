namespace Nowpose.Cli.Demo;

/// <summary>Computes the speed of the real tool as a central difference over 2 ms.</summary>
sealed class ToolSpeed(DemoRun run)
{
    static readonly TimeSpan Half = TimeSpan.FromMilliseconds(1);

    readonly ToolKinematics _kinematics = new(run.Settings.Robot);

    /// <summary>Gets the speed at a control time, mm/s.</summary>
    public double At(ControlTime t) => PositionAt(t + Half).DistanceMm(PositionAt(t - Half)) / (2 * Half.TotalSeconds);

    ToolPosition PositionAt(ControlTime t) => _kinematics.TrueAt(run.Truth, t);
}
