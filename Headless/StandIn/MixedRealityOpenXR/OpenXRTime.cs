namespace Microsoft.MixedReality.OpenXR;

public class OpenXRTime
{
    OpenXRTime()
    {
    }

    public static OpenXRTime Current { get; } = new();

    /// <summary>Function of the simulated runtime that predicts display times; null simulates the Editor, which has no runtime.</summary>
    internal static Func<FrameTime, long> PredictedXrTime { get; set; }

    /// <summary>OpenXR time, in nanoseconds, at which the performance counter is 0.</summary>
    internal static long XrTimeAtCountZero { get; set; }

    /// <summary>Frequency of the performance counter in Hz.</summary>
    internal static long CountsPerSecond { get; set; } = 10_000_000;

    public long GetPredictedDisplayTimeInXrTime(FrameTime frameTime) => PredictedXrTime?.Invoke(frameTime) ?? 0;

    public long ConvertXrTimeToQpcTime(long xrTime)
    {
        if (PredictedXrTime == null) return 0;

        var sinceZero = xrTime - XrTimeAtCountZero;
        return sinceZero / 1_000_000_000 * CountsPerSecond + sinceZero % 1_000_000_000 * CountsPerSecond / 1_000_000_000;
    }
}
