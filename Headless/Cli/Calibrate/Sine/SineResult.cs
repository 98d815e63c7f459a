namespace Nowpose.Cli.Calibrate.Sine;

/// <summary>What a jog to and fro says.</summary>
sealed record SineResult(SineTracks Tracks, LagEstimate Lag, SineWay Way)
{
    public double TotalMs => 1000 * Lag.LagSeconds;

    /// <summary>Standard error of <see cref="TotalMs"/>, and of <see cref="VisuMs"/> as far as the camera goes.</summary>
    public double DeviationMs => 1000 * Lag.Deviation;

    /// <summary>Null when it was not asked for.</summary>
    public double? VisuMs => TotalMs - Way.KnownMs;
}
