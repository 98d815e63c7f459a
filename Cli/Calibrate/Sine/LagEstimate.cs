namespace Nowpose.Cli.Calibrate.Sine;

/// <summary>The lag of the hologram behind the robot.</summary>
/// <param name="LagSeconds">The lag of the maximum correlation, interpolated between instants, s.</param>
/// <param name="Deviation">Standard error of the lag from the camera's noise, s.</param>
/// <param name="Correlation">Correlation at the maximum, 0 to 1.</param>
/// <param name="Lags">The tested lags, s.</param>
/// <param name="Correlations">The correlation at each of them.</param>
sealed record LagEstimate(double LagSeconds, double Deviation, double Correlation, double[] Lags, double[] Correlations);
