namespace Nowpose.Cli.Studies;

/// <summary>The true motion of one simulated axis.</summary>
/// <param name="name">Name of the motion in tables.</param>
/// <param name="seconds">Duration of the study, s. The motion is also defined after it.</param>
/// <param name="at">
/// Returns the position, in any unit, at a given time since the start in s. Must be smooth enough for finite differences over 1 ms.
/// </param>
public sealed class AxisMotion(string name, double seconds, Func<double, double> at)
{
    const double Step = 5e-4;

    public string Name { get; } = name;

    public double Seconds { get; } = seconds;

    public double At(double t) => at(t);

    /// <summary>Gets the velocity, in units per second, as a central difference.</summary>
    public double VelocityAt(double t) => (at(t + Step) - at(t - Step)) / (2 * Step);

    /// <summary>Gets the acceleration, in units per second squared, as a central difference.</summary>
    public double AccelerationAt(double t) => (at(t + Step) - 2 * at(t) + at(t - Step)) / (Step * Step);
}
