using Microsoft.MixedReality.OpenXR;
using Nowpose.Counter;
using Nowpose.OpenXR;

namespace Nowpose.Unity.Tests.Devices;

/// <summary>Simulates an OpenXR runtime that predicts the display time of frames.</summary>
sealed class PlayedRuntime : IDisposable
{
    /// <summary>OpenXR time at the count 0, ns. It is not 0, because OpenXR and the counter have different epochs.</summary>
    const long XrTimeAtCountZero = 987_654_321_123_456_789;

    /// <summary>Reading of the counter when the stopwatch starts: the counter starts with the device, the stopwatch with the application.</summary>
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

    /// <summary>Returns the predicted display time of the frame, for a request in Update or before rendering; null if it is unknown.</summary>
    public Func<FrameTime, HeadsetTime?> LightOf { get; set; } = _ => null;

    /// <summary>Value that the runtime returns if the display time is unknown.</summary>
    public long Unknown { get; set; }

    /// <summary>Makes a component use the counters of this device.</summary>
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
