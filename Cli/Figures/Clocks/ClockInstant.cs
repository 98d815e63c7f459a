namespace Nowpose.Cli.Figures.Clocks;

/// <summary>One estimator's values at an instant, compared with the truth.</summary>
/// <param name="Seconds">Headset time since the start.</param>
/// <param name="OffsetErrorUs">Estimated minus true offset, µs; null before the first estimate.</param>
/// <param name="SkewPpm">Estimated skew, ppm; null before the first estimate.</param>
readonly record struct ClockInstant(double Seconds, double? OffsetErrorUs, double? SkewPpm);
