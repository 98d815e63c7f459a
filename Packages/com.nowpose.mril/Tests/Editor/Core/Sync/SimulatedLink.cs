using System;
using Nowpose.Simulation;
using Nowpose.Sync;
using static Nowpose.Tests.Core.Lengths;

namespace Nowpose.Tests.Core.Sync
{
    /// <summary>Simulates a headset and a control system with known clocks, and the network between them, in virtual time.</summary>
    /// <remarks>
    /// The constants of the default estimator were chosen with another program on other seeds, so every seed here is independent.
    /// Accuracy tests use seeds from 100, step tests from 200.
    /// </remarks>
    sealed class SimulatedLink
    {
        readonly PathDelay _up, _down;
        readonly Random _random;
        readonly double _skew, _skewVariation, _skewPeriod, _lossChance;
        readonly ControlTime _controlStart;

        public SimulatedLink(
            NetworkProfile network, int seed, double skewPpm, double skewVariationPpm = 0, double lossChance = 0, double controlEpoch = 1.7e9,
            double skewPeriod = 120)
        {
            _up = network.Up(seed * 2 + 1);
            _down = network.Down(seed * 2 + 2);
            _random = new Random(seed);
            _skew = skewPpm * 1e-6;
            _skewVariation = skewVariationPpm * 1e-6;
            _skewPeriod = skewPeriod;
            _lossChance = lossChance;
            _controlStart = ControlTime.FromSeconds(controlEpoch);
        }

        /// <summary>Additional queueing delay of a request (up) and of a reply (down), as a function of seconds since the start.</summary>
        public Func<double, Random, (double UpMs, double DownMs)> Load { get; set; } = (s, r) => (0, 0);

        /// <summary>Returns the load of a busy network: queues during 20 s of each minute, with longer queues towards the headset.</summary>
        public static (double UpMs, double DownMs) Queues(double seconds, Random random) => seconds % 60 < 20
            ? (-2 * Math.Log(1 - random.NextDouble()), -15 * Math.Log(1 - random.NextDouble()))
            : (0, 0);

        /// <summary>Additional delay of later requests in ms. It simulates a change of the path.</summary>
        public double LongerUpMs { get; set; }

        /// <summary>Additional delay of later replies in ms.</summary>
        public double LongerDownMs { get; set; }

        /// <summary>Time that is added to the control clock from now on.</summary>
        public TimeSpan Step { get; set; }

        /// <summary>Returns the true offset at a headset time. The skew varies slowly around its mean.</summary>
        public ClockOffset TrueOffset(HeadsetTime t)
        {
            var s = t.SinceEpoch.TotalSeconds;
            var wander = _skewVariation * _skewPeriod / (2 * Math.PI) * (1 - Math.Cos(2 * Math.PI * s / _skewPeriod));
            return new ClockOffset(TimeSpan.FromTicks((long)((_skew * s + wander) * TimeSpan.TicksPerSecond)) - _controlStart.SinceEpoch - Step);
        }

        /// <summary>
        /// Resolution of the control clock. Its times are rounded down to a multiple of the resolution, and each exchange states the
        /// resolution.
        /// </summary>
        public TimeSpan Resolution { get; set; }

        /// <summary>Resolution reported in each exchange instead of the true resolution; null to report the true resolution.</summary>
        public TimeSpan? StatedResolution { get; set; }

        /// <summary>
        /// Error of the server's clock (positive when it is ahead) and the error bound that the server states, ms, as a function of seconds since the
        /// start.
        /// </summary>
        public Func<double, (double AheadMs, double StatedMs)> Server { get; set; } = s => (0, 0);

        /// <returns>False if the exchange was lost.</returns>
        public bool TryExchange(HeadsetTime at, out SyncExchange exchange)
        {
            var load = Load(at.SinceEpoch.TotalSeconds, _random);
            var arrival = at + _up.Next() + Ms(load.UpMs + LongerUpMs);
            var sent = arrival + Ms(0.02);
            var back = sent + _down.Next() + Ms(load.DownMs + LongerDownMs);
            exchange = new SyncExchange(
                at, Stamp(arrival), Stamp(sent), back, StatedResolution ?? Resolution, Ms(Server(arrival.SinceEpoch.TotalSeconds).StatedMs), true);
            return _random.NextDouble() >= _lossChance;
        }

        ControlTime Stamp(HeadsetTime moment)
        {
            var exact = (TrueOffset(moment).ToControl(moment) + Ms(Server(moment.SinceEpoch.TotalSeconds).AheadMs)).SinceEpoch.Ticks;
            return new ControlTime(new TimeSpan(Resolution == TimeSpan.Zero ? exact : exact / Resolution.Ticks * Resolution.Ticks));
        }
    }
}
