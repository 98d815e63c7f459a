namespace Nowpose.Cli.Calibrate.Sine;

/// <summary>The result of a back-and-forth jog.</summary>
sealed record SineResult(SineTracks Tracks, LagEstimate Lag, SineWay Way, SineCamera Camera)
{
    /// <summary>Time by which the hologram is behind the robot at the same moment, ms.</summary>
    public double TotalMs => 1000 * Lag.LagSeconds + Tracks.LaterMs;

    /// <summary>
    /// Standard error of <see cref="TotalMs"/> and <see cref="VisuMs"/>. For a hologram that is held between samples, it includes the error
    /// of the mean age, which is distributed uniformly within ±<see cref="StepsMs"/>. For the display, which is lit for a part of the exposure, it
    /// includes an error within ±<see cref="FlashMs"/>.
    /// </summary>
    public double DeviationMs => Math.Sqrt(Lag.Deviation * Lag.Deviation * 1e6 + (StepsMs * StepsMs + FlashMs * FlashMs) / 3);

    /// <summary>Maximum difference between T_s/2 and the mean age of the positions in the pictures, ms; 0 if positions are not held.</summary>
    public double StepsMs => Way.HeldMs is double held ? HeldSteps.MaxErrorMs(held, 1000 * Tracks.Interval, Tracks.Shown.Length) : 0;

    /// <summary>Maximum difference between the mean time at which the display is lit during the exposures and their middles, ms.</summary>
    public double FlashMs => Camera.MaxFlashErrorMs(1000 * Tracks.Interval, Tracks.Shown.Length);

    /// <summary>Period of the jog, s; null if the recording contains no complete period.</summary>
    public double? PeriodSeconds => JogPeriod.Of(Tracks.Robot) * Tracks.Interval;

    /// <summary>L_visu, ms; null if it was not requested.</summary>
    public double? VisuMs => TotalMs - Way.KnownMs;

    public string Json() => JsonText.Of(new
    {
        TotalMs, TotalSdMs = DeviationMs, VisuMs, Lag.Correlation, Pictures = Tracks.Shown.Length, period_s = PeriodSeconds,
    });
}
