namespace Nowpose.Cli.Calibrate.Sine;

/// <summary>How much later the hologram does what the robot does.</summary>
/// <param name="LagSeconds">Where the correlation is greatest, between instants.</param>
/// <param name="Deviation">Standard error of it as far as the camera goes, s.</param>
/// <param name="Correlation">At the peak, 0 to 1.</param>
/// <param name="Lags">The lags that were tried, s.</param>
/// <param name="Correlations">At each of them.</param>
sealed record LagEstimate(double LagSeconds, double Deviation, double Correlation, double[] Lags, double[] Correlations);
