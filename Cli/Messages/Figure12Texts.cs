namespace Nowpose.Cli.Messages;

/// <summary>Text of Fig. 12.</summary>
static class Figure12Texts
{
    public const string Claim =
        "A position profile of seven phases with limited velocity, acceleration and jerk, as is usual for servo drives, is sampled every T_s "
        + "and displayed L later. T_s and L may both be inaccurate.";

    public static string Conditions(double velocity, double acceleration, double jerk) =>
        FormattableString.Invariant($"500 mm with limits of {velocity:0} mm/s, {acceleration:0} mm/s² and {jerk:0} mm/s³. We chose the limits, ")
        + "because the paper states none. Drawn with 240 points per second.";

    public const string SevenPhases = "The profile has seven phases of constant jerk.";
    public const string Limits = "Velocity, acceleration and jerk exceed their limits by at most 0.1 %.";
    public const string Hold = "At full speed, hold lags by v·L to v·(L + T_s), 100 to 150 mm.";
    public const string Derivatives = "Derivatives, each as a share of its limit";
    public const string Share = "share of the limit";
}
