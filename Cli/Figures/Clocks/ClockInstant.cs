namespace Nowpose.Cli.Figures.Clocks;

/// <summary>What one estimator believed at a moment, against the truth.</summary>
/// <param name="Seconds">Headset time since the start.</param>
/// <param name="OffsetErrorUs">Believed less true offset; null before it believes anything.</param>
/// <param name="SkewPpm">Believed; null likewise.</param>
readonly record struct ClockInstant(double Seconds, double? OffsetErrorUs, double? SkewPpm);
