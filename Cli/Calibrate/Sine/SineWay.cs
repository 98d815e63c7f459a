using Nowpose.Cli.Messages;

namespace Nowpose.Cli.Calibrate.Sine;

/// <summary>Determines which part of the lag is L_visu.</summary>
/// <param name="KnownMs">Known part of the lag, ms; negative if the headset has already compensated for it. Null if L_visu was not requested.</param>
/// <param name="Words">Explains how the known part is composed.</param>
/// <param name="HeldMs">Time for which each position of the hologram is held, T_s; null if it is not held.</param>
sealed record SineWay(double? KnownMs, string Words, double? HeldMs = null)
{
    /// <exception cref="InputException">Options of both ways were given.</exception>
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
