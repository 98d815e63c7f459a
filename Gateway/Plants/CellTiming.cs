namespace Nowpose.Gateway.Plants;

/// <summary>The sampling times of a simulated cell, and the delay until a sample is sent.</summary>
/// <param name="SamplingInterval">T_s, at least one cycle.</param>
/// <param name="AcquisitionMin">Minimum time from t_k until the sample is sent.</param>
/// <param name="AcquisitionMax">Maximum time from t_k until the sample is sent. The time is uniformly distributed between the two.</param>
public sealed record CellTiming(TimeSpan SamplingInterval, TimeSpan AcquisitionMin, TimeSpan AcquisitionMax)
{
    /// <summary>The control cycle of the cell. Stamps are multiples of this time.</summary>
    public static readonly TimeSpan Cycle = TimeSpan.FromMilliseconds(1);
}
