using Nowpose.Simulation;
using Nowpose.Sync;

namespace Nowpose.Cli.Figures.Clocks;

/// <summary>Simulates sync exchanges over good WiFi, every 200 ms as in the paper, between two clocks with a known offset.</summary>
/// <remarks>
/// The random numbers are seeded. The skew is 5 to 80 ppm in either direction and varies slowly by ±2 ppm, as for quartz oscillators.
/// </remarks>
sealed class SimulatedExchanges
{
    const double Interval = 0.2;
    const double Turnaround = 20e-6;
    const double SkewVariationPpm = 2;
    const double SkewVariationPeriod = 120;

    /// <summary>Time of the control clock at the epoch of the headset clock. It is large, as if the control clock showed Unix time.</summary>
    static readonly TimeSpan ControlEpoch = TimeSpan.FromTicks(1_700_000_000 * TimeSpan.TicksPerSecond);

    readonly double _skewPpm;

    public SimulatedExchanges(int seed, double seconds)
    {
        var random = new Random(unchecked(seed * 7919 + 17));
        _skewPpm = (5 + 75 * random.NextDouble()) * (random.NextDouble() < 0.5 ? -1 : 1);
        var (up, down) = (NetworkProfile.Wifi.Up(random.Next()), NetworkProfile.Wifi.Down(random.Next()));
        var all = new List<SyncExchange>();
        for (var next = 0.0; next < seconds;)
        {
            var sent = HeadsetTime.FromSeconds(next);
            var arrived = sent + up.Next();
            var replied = arrived + TimeSpan.FromTicks((long)(Turnaround * TimeSpan.TicksPerSecond));
            var received = replied + down.Next();
            all.Add(new SyncExchange(sent, Control(arrived), Control(replied), received));
            // Exchanges do not overlap: the next one waits for a late reply.
            next = Math.Max(next + Interval, received.SinceEpoch.TotalSeconds);
        }
        All = all;
    }

    /// <summary>The exchanges in the order in which their replies arrived.</summary>
    public IReadOnlyList<SyncExchange> All { get; }

    /// <summary>Gets the true skew γ₂ − 1 at a headset time, ppm.</summary>
    public double SkewPpmAt(double seconds) => _skewPpm + SkewVariationPpm * Math.Sin(2 * Math.PI * seconds / SkewVariationPeriod);

    /// <summary>Gets the true offset Φ at a headset time.</summary>
    public ClockOffset TrueOffset(HeadsetTime t)
    {
        var s = t.SinceEpoch.TotalSeconds;
        var variation = SkewVariationPpm * SkewVariationPeriod / (2 * Math.PI) * (1 - Math.Cos(2 * Math.PI * s / SkewVariationPeriod));
        return new ClockOffset(TimeSpan.FromTicks((long)Math.Round((_skewPpm * s + variation) * 10)) - ControlEpoch);
    }

    ControlTime Control(HeadsetTime t) => TrueOffset(t).ToControl(t);
}
