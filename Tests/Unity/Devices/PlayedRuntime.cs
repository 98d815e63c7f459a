using Microsoft.MixedReality.OpenXR;
using Nowpose.Counter;
using Nowpose.OpenXR;

namespace Nowpose.Unity.Tests.Devices;

/// <summary>An OpenXR runtime that predicts the display time of frames, on the stand-in of Microsoft's plugin.</summary>
sealed class PlayedRuntime : IDisposable
{
    /// <summary>OpenXR's epoch differs from that of the counter.</summary>
    const long XrTimeAtCountZero = 987_654_321_123_456_789;

    /// <summary>The stopwatch may start with the application, while the counter starts with the device.</summary>
    static readonly TimeSpan UpTime = TimeSpan.FromDays(90);

    readonly SteppedClock _clock;
    readonly long _countsPerSecond;

    public PlayedRuntime(SteppedClock clock, long countsPerSecond = 19_200_000)
    {
        (_clock, _countsPerSecond) = (clock, countsPerSecond);
        OpenXRTime.CountsPerSecond = countsPerSecond;
        OpenXRTime.XrTimeAtCountZero = XrTimeAtCountZero;
        OpenXRTime.PredictedXrTime = tick =>
            LightOf(tick) is { } light ? XrTimeAtCountZero + (light + UpTime).Nanoseconds : Unknown;
    }

    /// <summary>Predicted display time of the frame, for a request in Update or before rendering; null if it is not known.</summary>
    public Func<FrameTime, HeadsetTime?> LightOf { get; set; } = _ => null;

    /// <summary>The value returned if the display time is not known.</summary>
    public long Unknown { get; set; }

    /// <summary>Gives a component the counters of this device.</summary>
    public void Equip(OpenXrDisplayTime component)
    {
        component.OpenCounter = () => new Counter(_clock, UpTime, _countsPerSecond);
        component.Stopwatch = new Counter(_clock, TimeSpan.Zero, _clock.CountsPerSecond);
    }

    public void Dispose()
    {
        OpenXRTime.PredictedXrTime = null;
        OpenXRTime.XrTimeAtCountZero = 0;
        OpenXRTime.CountsPerSecond = 10_000_000;
    }

    sealed class Counter(SteppedClock clock, TimeSpan atStart, long frequency) : ICounter
    {
        public long Frequency => frequency;

        public long Read() => (long)((Int128)(clock.Now.SinceEpoch + atStart).Ticks * frequency / TimeSpan.TicksPerSecond);
    }
}
