namespace Nowpose.Cli.Calibrate.Sine;

/// <summary>The lag of the hologram behind the robot.</summary>
/// <param name="LagSeconds">Lag with the maximum correlation, interpolated between instants, s.</param>
/// <param name="Deviation">Standard error of the lag caused by the camera's noise, s.</param>
/// <param name="Correlation">Maximum of the correlation, 0 to 1.</param>
/// <param name="Lags">The tested lags, s.</param>
/// <param name="Correlations">Correlation at each of the tested lags.</param>
sealed record LagEstimate(double LagSeconds, double Deviation, double Correlation, double[] Lags, double[] Correlations);
