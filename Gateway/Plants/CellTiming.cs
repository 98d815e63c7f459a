namespace Nowpose.Gateway.Plants;

/// <summary>When a simulated cell samples, and how long a sample takes until it is sent.</summary>
public sealed record CellTiming
{
    /// <summary>The cell's control cycle: stamps are whole cycles.</summary>
    public static readonly TimeSpan Cycle = TimeSpan.FromMilliseconds(1);

    /// <param name="samplingInterval">T_s, at least one cycle.</param>
    /// <param name="acquisitionMin">Shortest time from t_k until the sample is sent.</param>
    /// <param name="acquisitionMax">Longest; in between all are equally likely.</param>
    public CellTiming(TimeSpan samplingInterval, TimeSpan acquisitionMin, TimeSpan acquisitionMax)
    {
        if (samplingInterval < Cycle)
            throw new ArgumentOutOfRangeException(nameof(samplingInterval), samplingInterval, "at least one control cycle of 1 ms");
        if (acquisitionMin < TimeSpan.Zero || acquisitionMax < acquisitionMin)
            throw new ArgumentOutOfRangeException(nameof(acquisitionMin), acquisitionMin, $"from 0 to the longest, {acquisitionMax}");
        SamplingInterval = samplingInterval;
        AcquisitionMin = acquisitionMin;
        AcquisitionMax = acquisitionMax;
    }

    public TimeSpan SamplingInterval { get; }
    public TimeSpan AcquisitionMin { get; }
    public TimeSpan AcquisitionMax { get; }
}
