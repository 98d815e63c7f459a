namespace Nowpose.Cli.Studies;

/// <summary>Random variation between cycles, as standard deviations of normal distributions.</summary>
/// <param name="DwellSeconds">Standard deviation of each dwell, s.</param>
/// <param name="TargetMm">Standard deviation of each target position, mm.</param>
/// <param name="SpeedShare">Standard deviation of the speed factor; 0.1 is 10 %.</param>
public readonly record struct CycleVariation(double DwellSeconds = 0, double TargetMm = 0, double SpeedShare = 0);
