namespace Nowpose.Cli.Calibrate.Sine;

/// <summary>Determines how much of the measured lag is L_visu.</summary>
/// <param name="KnownMs">Known part of the lag, ms. Negative if the headset already compensates for it; null if L_visu was not requested.</param>
/// <param name="Explanation">Explanation of the known part.</param>
/// <param name="HeldMs">Time for which the hologram stays at each position, T_s, ms; null if it moves continuously.</param>
sealed record SineWay(double? KnownMs, string Explanation, double? HeldMs = null)
{
    /// <exception cref="InputException">The options of both cases, with and without compensation, were given.</exception>
    public static SineWay Of(double? applicationMs, double samplingMs, double? configuredMs)
    {
        if (applicationMs.HasValue && configuredMs.HasValue)
            throw new InputException(SineMessages.BothWays);
        if (configuredMs is double configured)
            return new(-configured, SinePageTexts.Compensated(configured));
        if (applicationMs is double application)
            return new(application + samplingMs / 2, SinePageTexts.NotCompensated(application, samplingMs / 2), samplingMs);
        return new(null, SinePageTexts.TotalOnly);
    }
}
