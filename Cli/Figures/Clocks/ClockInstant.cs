namespace Nowpose.Cli.Figures.Clocks;

/// <summary>The values of an estimator at one instant, compared with the true ones.</summary>
/// <param name="Seconds">Headset time since the start of the run.</param>
/// <param name="OffsetErrorUs">Estimated minus true offset, µs; null before the first estimate.</param>
/// <param name="SkewPpm">Estimated skew, ppm; null before the first estimate.</param>
readonly record struct ClockInstant(double Seconds, double? OffsetErrorUs, double? SkewPpm);
