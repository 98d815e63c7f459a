using Nowpose.Sync;

namespace Nowpose.Cli.Figures.Clocks;

/// <summary>Feeds simulated exchanges to the headset's clock synchroniser and reads its estimates 60 times per second.</summary>
static class ClockRun
{
    /// <summary>Frame rate of a headset.</summary>
    public const double InstantsPerSecond = 60;

    public static ClockInstant[] Of(string estimator, SimulatedExchanges exchanges, double seconds)
    {
        var clock = new ClockSynchroniser(ClockEstimators.Create(estimator), ClockSettings.Default);
        var instants = new ClockInstant[(int)(seconds * InstantsPerSecond)];
        var next = 0;
        for (var i = 0; i < instants.Length; i++)
        {
            var s = i / InstantsPerSecond;
            var now = HeadsetTime.FromSeconds(s);
            for (; next < exchanges.All.Count && exchanges.All[next].T4 <= now; next++) clock.Add(exchanges.All[next], out _);
            var model = clock.ModelAt(now);
            instants[i] = model.IsKnown
                ? new ClockInstant(s, (model.OffsetAt(now) - exchanges.TrueOffset(now)).TotalMicroseconds, model.Skew * 1e6)
                : new ClockInstant(s, null, null);
        }
        return instants;
    }
}

/// <summary>The values of an estimator at one instant, compared with the true ones.</summary>
/// <param name="Seconds">Headset time since the start of the run.</param>
/// <param name="OffsetErrorUs">Estimated minus true offset, µs; null before the first estimate.</param>
/// <param name="SkewPpm">Estimated skew, ppm; null before the first estimate.</param>
readonly record struct ClockInstant(double Seconds, double? OffsetErrorUs, double? SkewPpm);
