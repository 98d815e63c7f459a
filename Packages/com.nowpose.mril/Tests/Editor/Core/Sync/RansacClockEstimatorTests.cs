using System;
using System.Linq;
using Nowpose.Simulation;
using Nowpose.Sync;
using Nowpose.Sync.Ransac;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Sync
{
    /// <summary>
    /// Tests the paper's estimator. The limits of the 95th percentile are 1.3 times the errors of an independent implementation of the same
    /// method on the same networks.
    /// </summary>
    public class RansacClockEstimatorTests
    {
        static (double P95, double Max) Worst(NetworkProfile network, double loss, double after, Func<double, Random, (double, double)> load = null)
        {
            double p95 = 0, max = 0;
            const int seeds = 4;
            for (var seed = 0; seed < seeds; seed++)
            {
                var link = new SimulatedLink(network, seed, skewPpm: (seed % 2 == 0 ? 1 : -1) * (5 + 25 * seed), skewVariationPpm: 2, lossChance: loss);
                if (load != null) link.Load = load;
                var run = new SyncRun(new RansacClockEstimator(RansacSettings.Paper));
                run.Run(link, 0, 300);
                p95 += run.PercentileMs(after, 0.95) / seeds;
                max = Math.Max(max, run.PercentileMs(after, 1));
            }
            return (p95, max);
        }

        // Its lines follow the middle of the bounds, so after a change of the path they may be outside the bounds of the last minute.
        [Test]
        public void Exchanges_HeadsetRoamsToAndFro_AreAllKept()
        {
            var link = new SimulatedLink(NetworkProfile.Lan, 600, skewPpm: 20);
            var run = new SyncRun(new RansacClockEstimator(RansacSettings.Paper));
            for (var i = 0; i < 8; i++)
            {
                link.LongerUpMs = i % 2 == 0 ? 0 : 8;
                run.Run(link, 40 * i, 40 * (i + 1));
            }

            Assert.That((run.Clock.Steps, run.Clock.Exchanges), Is.EqualTo((0, 1600)));
        }

        [Category("Study")]
        [Test]
        public void Error_Lan_IsCloseToTheReference()
        {
            var error = Worst(NetworkProfile.Lan, 0, 10);

            Assert.That(error.P95, Is.LessThan(0.035 * 1.3));
            Assert.That(error.Max, Is.LessThan(0.2));
        }

        [Category("Study")]
        [Test]
        public void Error_Wifi_IsCloseToTheReference()
        {
            var error = Worst(NetworkProfile.Wifi, 0, 10);

            Assert.That(error.P95, Is.LessThan(0.198 * 1.3));
            Assert.That(error.Max, Is.LessThan(0.6));
        }

        [Category("Study")]
        [Test]
        public void Error_BusyWifi_IsCloseToTheReference()
        {
            var error = Worst(NetworkProfile.BusyWifi, 0.02, 10);

            Assert.That(error.P95, Is.LessThan(1.01 * 1.3));
            Assert.That(error.Max, Is.LessThan(5));
        }

        [Category("Study")]
        [Test]
        public void Error_BusyWifiUnderLoad_IsCloseToTheReference()
        {
            var error = Worst(NetworkProfile.BusyWifi, 0.02, 60, SimulatedLink.Queues);

            Assert.That(error.P95, Is.LessThan(5.4 * 1.3));
        }

        [Test]
        public void Skew_SymmetricPathWithoutJitter_IsExact()
        {
            const double skewPpm = 50;
            var estimator = new RansacClockEstimator(RansacSettings.Paper);
            for (var i = 0; i < 150; i++)
            {
                var t1 = HeadsetTime.FromSeconds(1e5 + i * 0.2);
                var t4 = t1 + TimeSpan.FromMilliseconds(4);
                var middle = t1 + TimeSpan.FromMilliseconds(2);
                var offset = new ClockOffset(Lengths.Seconds(-1.7e9) + TimeSpan.FromTicks((long)Math.Round(i * 0.2e7 * skewPpm * 1e-6)));
                estimator.Add(new SyncExchange(t1, offset.ToControl(middle), offset.ToControl(middle), t4));
            }

            Assert.That(estimator.Line.Skew * 1e6, Is.EqualTo(skewPpm).Within(0.05));
        }

        [Test]
        public void Outliers_UpToAThird_DoNotMoveTheLine()
        {
            var estimator = new RansacClockEstimator(RansacSettings.Paper);
            var random = new Random(5);
            for (var i = 0; i < 100; i++)
            {
                var t1 = HeadsetTime.FromSeconds(i * 0.2);
                var lateMs = i % 3 == 0 ? 20 + 200 * random.NextDouble() : 0;
                var t4 = t1 + Lengths.Ms(2 + lateMs);
                var at = new ControlTime(t1.SinceEpoch + TimeSpan.FromMilliseconds(1));
                estimator.Add(new SyncExchange(t1, at, at, t4));
            }

            var offsetMs = estimator.Line.Offset.HeadsetMinusControl.TotalMilliseconds;
            Assert.That(offsetMs, Is.EqualTo(0).Within(0.01), "late replies do not affect the offset; seed 5");
        }

        [Test]
        public void Line_AfterRestart_IsEmpty()
        {
            var estimator = new RansacClockEstimator(RansacSettings.Paper);
            estimator.Add(new SyncExchange(default, default, default, HeadsetTime.FromSeconds(0.01)));

            estimator.Restart(0);

            Assert.That(estimator.Line.Exchanges, Is.EqualTo(0));
        }

        [TestCase(2, 20, 1.0, 20, "history: 2")]
        [TestCase(100, 0, 1.0, 20, "hypotheses: 0")]
        [TestCase(100, 20, 0.0, 20, "inlier bound: 0 ms")]
        [TestCase(100, 20, 0.00005, 20, "inlier bound: 5E-05 ms")]
        [TestCase(100, 20, double.NaN, 20, "inlier bound: NaN ms")]
        public void Settings_OutOfRange_NameTheValue(int history, int hypotheses, double boundMs, int average, string named)
        {
            var error = Assert.Throws<InputException>(() => new RansacSettings(history, hypotheses, boundMs, average));

            Assert.That(error.Message, Does.StartWith(named));
        }
    }
}
