namespace Nowpose.Studies;

/// <summary>The true motion of one simulated axis.</summary>
/// <param name="name">Name for tables.</param>
/// <param name="seconds">Length to be studied, s. The motion is defined beyond it, too.</param>
/// <param name="at">Position at seconds since the start, in any unit; smooth enough for differences over 1 ms.</param>
public sealed class AxisMotion(string name, double seconds, Func<double, double> at)
{
    const double Step = 5e-4;

    public string Name { get; } = name;

    public double Seconds { get; } = seconds;

    public double At(double t) => at(t);

    /// <summary>By a central difference, per second.</summary>
    public double VelocityAt(double t) => (at(t + Step) - at(t - Step)) / (2 * Step);

    /// <summary>By a central difference, per second squared.</summary>
    public double AccelerationAt(double t) => (at(t + Step) - 2 * at(t) + at(t - Step)) / (Step * Step);
}
