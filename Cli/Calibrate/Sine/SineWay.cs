namespace Nowpose.Cli.Calibrate.Sine;

/// <summary>What of the lag is L_visu.</summary>
/// <param name="KnownMs">What of it is known; negative where the headset has taken it off already. Null when L_visu was not asked for.</param>
/// <param name="Words">How that is made up.</param>
/// <param name="HeldMs">How long each place of the hologram is held, T_s; null where it is not.</param>
sealed record SineWay(double? KnownMs, string Words, double? HeldMs = null)
{
    /// <exception cref="InputException">Both ways at once.</exception>
    public static SineWay Of(double? applicationMs, double samplingMs, double? toldMs)
    {
        if (applicationMs.HasValue && toldMs.HasValue)
            throw new InputException("--app-ms and --told-ms exclude each other: film either the ghost, which is not compensated, or the gripper, which is");
        if (toldMs is double told)
            return new(-told, FormattableString.Invariant($"compensated: what lags is the error of the {told:0.##} ms that the headset was told"));
        if (applicationMs is double application)
            return new(application + samplingMs / 2,
                FormattableString.Invariant($"not compensated: L_app {application:0.##} ms and half of T_s, {samplingMs / 2:0.##} ms, are taken off"), samplingMs);
        return new(null, "the total latency only");
    }
}
