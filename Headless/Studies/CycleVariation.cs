namespace Nowpose.Studies;

/// <summary>How one cycle differs from the next: standard deviations of normal distributions.</summary>
/// <param name="DwellSeconds">Variation of each dwell, s.</param>
/// <param name="TargetMm">Variation of each target, mm.</param>
/// <param name="SpeedShare">Variation of the speed override, dimensionless: 0.1 is 10 %.</param>
public readonly record struct CycleVariation(double DwellSeconds = 0, double TargetMm = 0, double SpeedShare = 0);
