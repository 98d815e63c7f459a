namespace Nowpose.Cli.Calibrate.Sine;

/// <summary>What a jog to and fro says.</summary>
sealed record SineResult(SineTracks Tracks, LagEstimate Lag, SineWay Way)
{
    public double TotalMs => 1000 * Lag.LagSeconds;

    /// <summary>
    /// Standard error of <see cref="TotalMs"/> and <see cref="VisuMs"/>, with what comes of a hologram that steps in time with the pictures:
    /// anywhere between −<see cref="StepsMs"/> and that.
    /// </summary>
    public double DeviationMs => Math.Sqrt(Lag.Deviation * Lag.Deviation * 1e6 + StepsMs * StepsMs / 3);

    /// <summary>By how much the mean age of the places that the pictures show may be off T_s/2, ms.</summary>
    public double StepsMs => Way.HeldMs is double held ? HeldSteps.GreatestErrorMs(held, 1000 * Tracks.Interval, Tracks.Shown.Length) : 0;

    /// <summary>Null when it was not asked for.</summary>
    public double? VisuMs => TotalMs - Way.KnownMs;
}
