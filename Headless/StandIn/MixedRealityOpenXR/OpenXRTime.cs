using System;

namespace Microsoft.MixedReality.OpenXR;

public class OpenXRTime
{
    OpenXRTime()
    {
    }

    public static OpenXRTime Current { get; } = new();

    /// <summary>The simulated runtime of a test; null for the behaviour in the Editor.</summary>
    internal static Func<FrameTime, long> PredictedXrTime { get; set; }

    /// <summary>OpenXR time at the counter's zero: nanoseconds since its own epoch.</summary>
    internal static long XrTimeAtCountZero { get; set; }

    /// <summary>Counts of the performance counter per second.</summary>
    internal static long CountsPerSecond { get; set; } = 10_000_000;

    public long GetPredictedDisplayTimeInXrTime(FrameTime frameTime) => PredictedXrTime?.Invoke(frameTime) ?? 0;

    public long ConvertXrTimeToQpcTime(long xrTime)
    {
        if (PredictedXrTime == null) return 0;

        var sinceZero = xrTime - XrTimeAtCountZero;
        return sinceZero / 1_000_000_000 * CountsPerSecond + sinceZero % 1_000_000_000 * CountsPerSecond / 1_000_000_000;
    }
}
