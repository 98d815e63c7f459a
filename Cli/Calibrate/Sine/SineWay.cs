namespace Nowpose.Cli.Calibrate.Sine;

/// <summary>Determines how much of the measured lag is L_visu.</summary>
/// <param name="KnownMs">Known part of the lag, ms. Negative if the headset already compensates for it; null if L_visu was not requested.</param>
/// <param name="Words">Explanation of the known part.</param>
/// <param name="HeldMs">Time for which the hologram stays at each position, T_s, ms; null if it moves continuously.</param>
sealed record SineWay(double? KnownMs, string Words, double? HeldMs = null)
{
    /// <exception cref="InputException">The options of both cases, with and without compensation, were given.</exception>
    public static SineWay Of(double? applicationMs, double samplingMs, double? configuredMs)
    {
        if (applicationMs.HasValue && configuredMs.HasValue)
            throw new InputException("--app-ms and --told-ms exclude each other: film either the ghost, which is not compensated, or the gripper, which is");
        if (configuredMs is double configured)
            return new(-configured,
                FormattableString.Invariant($"compensated: the remaining lag is the error of the {configured:0.##} ms that the headset used"));
        if (applicationMs is double application)
            return new(application + samplingMs / 2,
                FormattableString.Invariant($"not compensated: L_app {application:0.##} ms and half of T_s, {samplingMs / 2:0.##} ms, are subtracted"), samplingMs);
        return new(null, "the total latency only");
    }
}
