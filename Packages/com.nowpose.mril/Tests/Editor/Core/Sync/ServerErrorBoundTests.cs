using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Simulation;
using Nowpose.Sync;
using Nowpose.Sync.Ransac;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Sync
{
    [Category("Study")]
    public class ServerErrorBoundTests
    {
        // Simulates a gateway that has just started. The error of its first time stamps exceeds the error bound that it states later.
        [TestCase(ClockEstimators.Default)]
        [TestCase(ClockEstimators.Ransac)]
        public void ErrorBound_ServerErrorBoundDecreases_Holds(string estimator)
        {
            foreach (var network in new[] { NetworkProfile.Lan, NetworkProfile.Wifi })
                foreach (var firstMs in new[] { -4.0, 1, 4 })
                    for (var seed = 40; seed < 44; seed++)
                    {
                        var run = new SyncRun(ClockEstimators.Create(estimator));
                        double AheadMs(double s) => firstMs * Math.Exp(-s / 5);

                        run.Run(new SimulatedLink(network, seed, 40) { Server = s => (AheadMs(s), Math.Abs(AheadMs(s)) + 0.1) }, 0, 90);

                        var known = run.Instants.Where(i => i.Model.State == ClockState.Synchronised || i.Model.State == ClockState.Coarse).ToList();
                        var label = network.Name + " " + firstMs + " ms, seed " + seed;
                        RequireWithinBounds(known, label);
                        Assert.That(known.Count, Is.GreaterThan(0.95 * run.Instants.Count()), label);
                        Assert.That(run.PercentileMs(85, 1), Is.LessThan(1), label);
                    }
        }

        // Simulates a gateway that loses contact with the plant's clock and continues at a wrong rate.
        [TestCase(ClockEstimators.Default)]
        [TestCase(ClockEstimators.Ransac)]
        public void ErrorBound_ServerErrorBoundGrows_Holds(string estimator)
        {
            for (var seed = 50; seed < 54; seed++)
            {
                var run = new SyncRun(ClockEstimators.Create(estimator));
                double AheadMs(double s) => s < 40 ? 0 : 0.2 * (s - 40);

                run.Run(new SimulatedLink(NetworkProfile.Wifi, seed, 40) { Server = s => (AheadMs(s), AheadMs(s) + 0.1) }, 0, 60);

                var beyond = run.Instants.Count(i => i.Model.IsKnown && Math.Abs(i.ErrorMs) > i.Model.ErrorBound.TotalMilliseconds);
                Assert.That(beyond, Is.EqualTo(0), "seed " + seed);
            }
        }

        // Simulates a gateway whose first estimate of the plant's clock is wrong by 4 ms.
        [TestCase(ClockEstimators.Default)]
        [TestCase(ClockEstimators.Ransac)]
        public void Steps_ServerCorrectsItsClockOnce_StayZero(string estimator)
        {
            RequireUsable(estimator, "once", s => s < 40 ? (4, 4.5) : (0.2, 0.5), run => Assert.That(run.PercentileMs(70, 1), Is.LessThan(0.8)));
        }

        // Simulates a gateway that estimates the plant's clock over a busy path: each new estimate moves the clock that it serves.
        [Test]
        public void Steps_ServerCorrectsItsClockRepeatedly_StayZero()
        {
            RequireUsable(ClockEstimators.Default, "back and forth", s => (s % 20 < 10 ? 2 : -2, 2.5), run => { });
            RequireUsable(ClockEstimators.Default, "by chance each second", s => (6 * Uniform(s) - 3, 3.5), run => { });
            RequireUsable(ClockEstimators.Default, "by chance every 5 s", s => (6 * Uniform(s / 5) - 3, 3.5), run => { });
        }

        // Simulates a gateway that has just started and estimates the plant's clock over a busy path: every 4 s, it states a smaller error bound, and
        // its clock is wrong by any amount within the bound.
        [Test]
        public void ErrorBound_ServerErrorBoundDecreasesInSteps_Holds()
        {
            foreach (var network in new[] { NetworkProfile.Lan, NetworkProfile.Wifi, NetworkProfile.BusyWifi })
                for (var seed = 100; seed < 104; seed++)
                {
                    var run = new SyncRun(ClockEstimators.Create(ClockEstimators.Default));
                    double MaxMs(double s) => 8 * Math.Pow(0.6, Math.Floor(s / 4));
                    double AheadMs(double s) => (2 * Uniform(s / 4 + 1000 * seed) - 1) * MaxMs(s);

                    var link = new SimulatedLink(network, seed, 40) { Server = s => (AheadMs(s), MaxMs(s) + 0.1) };
                    run.Run(link, 0, 90);

                    var label = network.Name + ", seed " + seed;
                    Assert.That(run.Clock.Steps, Is.EqualTo(0), label);
                    RequireWithinBounds(run.Instants.Where(i => i.At > 3).ToList(), label);
                    Assert.That(run.PercentileMs(85, 1), Is.LessThan(2), label);
                    Assert.That(run.Instants.Where(i => i.At > 60).Select(i => i.Model.State), Has.None.EqualTo(ClockState.Converging), label);
                }
        }

        // Returns a value from 0 to 1 that changes with the integer part of its argument.
        static double Uniform(double at)
        {
            var value = (ulong)(long)Math.Floor(at) * 0x9E3779B97F4A7C15;
            value = (value ^ (value >> 30)) * 0xBF58476D1CE4E5B9;
            return (value >> 11) / (double)(1L << 53);
        }

        static void RequireWithinBounds(IReadOnlyCollection<(double At, double ErrorMs, ClockModel Model)> instants, string label)
        {
            Assert.That(instants.Count(i => Math.Abs(i.ErrorMs) > i.Model.ErrorBound.TotalMilliseconds), Is.EqualTo(0), label);
            var beyond = instants.Count(i => Math.Abs(i.ErrorMs) > i.Model.EstimatedError.TotalMilliseconds);
            Assert.That(beyond, Is.LessThanOrEqualTo(0.01 * instants.Count), label);
        }

        static void RequireUsable(string estimator, string name, Func<double, (double AheadMs, double StatedMs)> server, Action<SyncRun> require)
        {
            var networks = new[] { NetworkProfile.Lan, NetworkProfile.Wifi, NetworkProfile.BusyWifi };
            // RANSAC does not include such a change in its standard error on a busy network.
            foreach (var network in networks.Take(estimator == ClockEstimators.Default ? 3 : 2))
                for (var seed = 70; seed < 74; seed++)
                {
                    var run = new SyncRun(ClockEstimators.Create(estimator));

                    run.Run(new SimulatedLink(network, seed, 40) { Server = server }, 0, 90);

                    var label = network.Name + " " + name + ", seed " + seed;
                    Assert.That(run.Clock.Steps, Is.EqualTo(0), label);
                    var later = run.Instants.Where(i => i.At > 3).ToList();
                    Assert.That(
                        later.Select(i => i.Model.State).Distinct(), Is.SubsetOf(new[] { ClockState.Synchronised, ClockState.Coarse }), label);
                    RequireWithinBounds(later, label);
                    require(run);
                }
        }

        [Test]
        public void ErrorBound_ServerStatesABound_IsWider()
        {
            TimeSpan BoundWith(TimeSpan server)
            {
                var clock = new ClockSynchroniser(new RansacClockEstimator(RansacSettings.Paper), ClockSettings.Default);
                clock.Add(new SyncExchange(default, default, default, HeadsetTime.FromSeconds(0.002), serverErrorBound: server), out _);
                return clock.ModelAt(HeadsetTime.FromSeconds(0.002)).ErrorBound;
            }

            Assert.That(BoundWith(TimeSpan.Zero).TotalMilliseconds, Is.EqualTo(1).Within(0.002), "half the round-trip time");
            Assert.That(BoundWith(TimeSpan.FromMilliseconds(3)).TotalMilliseconds, Is.EqualTo(4).Within(0.002));
        }
    }
}
