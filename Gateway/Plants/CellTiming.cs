using Nowpose.Gateway.Messages;

namespace Nowpose.Gateway.Plants;

/// <summary>The sampling times of a simulated cell, and the delay until a sample is sent.</summary>
public sealed record CellTiming
{
    /// <summary>The control cycle of the cell. Stamps are multiples of this time.</summary>
    public static readonly TimeSpan Cycle = TimeSpan.FromMilliseconds(1);

    /// <param name="samplingInterval">T_s, at least one cycle.</param>
    /// <param name="acquisitionMin">Minimum time from t_k until the sample is sent.</param>
    /// <param name="acquisitionMax">Maximum time from t_k until the sample is sent. The time is uniformly distributed between the two.</param>
    public CellTiming(TimeSpan samplingInterval, TimeSpan acquisitionMin, TimeSpan acquisitionMax)
    {
        if (samplingInterval < Cycle)
            throw new ArgumentOutOfRangeException(nameof(samplingInterval), samplingInterval, PlantMessages.SamplingTime);
        if (acquisitionMin < TimeSpan.Zero || acquisitionMax < acquisitionMin)
            throw new ArgumentOutOfRangeException(nameof(acquisitionMin), acquisitionMin, PlantMessages.AcquisitionTime(acquisitionMax));
        SamplingInterval = samplingInterval;
        AcquisitionMin = acquisitionMin;
        AcquisitionMax = acquisitionMax;
    }

    public TimeSpan SamplingInterval { get; }
    public TimeSpan AcquisitionMin { get; }
    public TimeSpan AcquisitionMax { get; }
}
