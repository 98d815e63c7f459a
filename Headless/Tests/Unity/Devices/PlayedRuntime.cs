using Microsoft.MixedReality.OpenXR;

namespace Nowpose.Headless.Tests.Unity.Devices;

/// <summary>An OpenXR runtime that predicts when the light of frames appears, on the stand-in of Microsoft's plugin.</summary>
sealed class PlayedRuntime : IDisposable
{
    /// <summary>The counter of a device that has run for a while is not at zero, and OpenXR's epoch is another one.</summary>
    const long XrTimeAtCountZero = 987_654_321_123_456_789;

    const long CountsPerSecond = 3_579_545;

    public PlayedRuntime(SteppedClock clock)
    {
        clock.CountsPerSecond = CountsPerSecond;
        OpenXRTime.CountsPerSecond = CountsPerSecond;
        OpenXRTime.XrTimeAtCountZero = XrTimeAtCountZero;
        OpenXRTime.PredictedXrTime = tick => LightOf(tick) is { } light ? XrTimeAtCountZero + light.Nanoseconds : Unknown;
    }

    /// <summary>When the light of the frame appears, as it is asked for in Update or before rendering; null: not known.</summary>
    public Func<FrameTime, HeadsetTime?> LightOf { get; set; } = _ => null;

    /// <summary>What is said where it is not known.</summary>
    public long Unknown { get; set; }

    public void Dispose()
    {
        OpenXRTime.PredictedXrTime = null;
        OpenXRTime.XrTimeAtCountZero = 0;
        OpenXRTime.CountsPerSecond = 10_000_000;
    }
}
