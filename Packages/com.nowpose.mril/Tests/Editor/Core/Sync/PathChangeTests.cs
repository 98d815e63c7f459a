using System;
using System.Linq;
using Nowpose.Simulation;
using Nowpose.Sync;
using Nowpose.Sync.Envelope;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Sync
{
    /// <summary>
    /// Tests the default estimator when the minimum delay of the path changes, for example because a headset roams to another access point.
    /// The physical limit of the error is half the difference of the two one-way delays; the tests allow 20 % more.
    /// </summary>
    [Category("Study")]
    public class PathChangeTests
    {
        const int FirstSeed = 241, Seeds = 2;
        const double ChangeAt = 150;

        static SimulatedLink Link(string network, int seed) => new SimulatedLink(
            NetworkProfile.Named(network), seed, skewPpm: 33 - 30 * (seed % 3), skewVariationPpm: 1, skewPeriod: 400);

        static SyncRun Run(SimulatedLink link, double upMs, double downMs, double? backAfter = null)
        {
            var run = new SyncRun(new DefaultClockEstimator());
            run.Run(link, 0, ChangeAt);
            (link.LongerUpMs, link.LongerDownMs) = (upMs, downMs);
            run.Run(link, ChangeAt, ChangeAt + (backAfter ?? 120));
            if (!backAfter.HasValue) return run;
            (link.LongerUpMs, link.LongerDownMs) = (0, 0);
            run.Run(link, ChangeAt + backAfter.Value, ChangeAt + backAfter.Value + 100);
            return run;
        }

        static double SkewDeviationPpm(SyncRun run)
        {
            var before = run.Instants.Last(i => i.At < ChangeAt).Model.Skew;
            return run.Instants.Where(i => i.At > ChangeAt + 5).Max(i => Math.Abs(i.Model.Skew - before)) * 1e6;
        }

        [Test]
        public void Error_OneDirectionBecomesLonger_StaysWithinThePhysicalLimit(
            [Values("lan", "wifi", "busy-wifi")] string network, [Values(2.0, 4.0, 20.0)] double changeMs, [Values(true, false)] bool isUp)
        {
            for (var seed = FirstSeed; seed < FirstSeed + Seeds; seed++)
            {
                var run = Run(Link(network, seed), isUp ? changeMs : 0, isUp ? 0 : changeMs);

                var noise = run.ErrorsMs(60).Take((int)((ChangeAt - 60) / 0.02)).Max();
                Assert.That(run.ErrorsMs(ChangeAt).Max(), Is.LessThan(1.2 * changeMs / 2 + noise), "seed " + seed);
                Assert.That(SkewDeviationPpm(run), Is.LessThan(5), "seed " + seed);
                Assert.That(run.Clock.Steps, Is.Zero, "seed " + seed);
                Assert.That(run.Instants.Where(i => i.At > ChangeAt).All(i => Math.Abs(i.ErrorMs) <= i.Model.ErrorBound.TotalMilliseconds), Is.True, "bound, seed " + seed);
            }
        }

        [TestCase("lan")]
        [TestCase("wifi")]
        public void Error_OneDirectionBecomesLongerOnAQuietNetwork_StaysSmall(string network)
        {
            for (var seed = FirstSeed; seed < FirstSeed + Seeds; seed++)
            {
                var run = Run(Link(network, seed), 4, 0);

                Assert.That(run.ErrorsMs(ChangeAt).Max(), Is.LessThan(0.2), "the earlier minimum delays are still valid; seed " + seed);
            }
        }

        [TestCase("lan", 4, 2)]
        [TestCase("wifi", 4, 2)]
        [TestCase("wifi", 1, 8)]
        [TestCase("busy-wifi", 6, 2)]
        public void Error_BothDirectionsBecomeLonger_StaysWithinThePhysicalLimit(string network, double upMs, double downMs)
        {
            for (var seed = FirstSeed; seed < FirstSeed + Seeds; seed++)
            {
                var run = Run(Link(network, seed), upMs, downMs);

                Assert.That(run.ErrorsMs(ChangeAt).Max(), Is.LessThan(1.2 * Math.Abs(upMs - downMs) / 2), "seed " + seed);
                Assert.That(SkewDeviationPpm(run), Is.LessThan(5), "seed " + seed);
            }
        }

        [TestCase("lan", 0.5)]
        [TestCase("wifi", 0.5)]
        [TestCase("wifi", 4)]
        [TestCase("busy-wifi", 4)]
        [TestCase("wifi", 20)]
        public void Error_PathChangesAndChangesBack_StaysWithinThePhysicalLimit(string network, double changeMs)
        {
            for (var seed = FirstSeed; seed < FirstSeed + Seeds; seed++)
            {
                var run = Run(Link(network, seed), changeMs, 0, backAfter: 100);

                Assert.That(run.ErrorsMs(ChangeAt).Max(), Is.LessThan(1.2 * changeMs / 2), "seed " + seed);
                Assert.That(run.Clock.Steps, Is.Zero, "seed " + seed);
                Assert.That(run.PercentileMs(ChangeAt + 130, 1), Is.LessThan(network == "busy-wifi" ? 0.3 : 0.15),
                    "the original path is back; seed " + seed);
            }
        }

        [TestCase("wifi", -0.5)]
        [TestCase("wifi", -1)]
        [TestCase("wifi", 0.5)]
        [TestCase("busy-wifi", -0.5)]
        [TestCase("busy-wifi", 0.5)]
        [TestCase("busy-wifi", 4)]
        public void EstimatedError_ChangeTooSmallToRecognise_Holds(string network, double changeMs)
        {
            for (var seed = FirstSeed; seed < FirstSeed + Seeds; seed++)
            {
                var run = Run(Link(network, seed), 0, changeMs);

                var after = run.Instants.Where(i => i.At > ChangeAt + 5).ToArray();
                Assert.That(after.Average(i => Math.Abs(i.ErrorMs) <= i.Model.EstimatedError.TotalMilliseconds ? 1 : 0), Is.GreaterThan(0.99), "seed " + seed);
                Assert.That(after.Last().Model.EstimatedError.TotalMilliseconds, Is.LessThan(network == "wifi" ? 1.6 : 2),
                    "the estimate stays useful; seed " + seed);
            }
        }

        [TestCase("wifi", 0.3)]
        [TestCase("busy-wifi", 0.3)]
        public void EstimatedError_UnrecognisedThenRecognisedChange_IncludesBothChanges(string network, double changeMs)
        {
            for (var seed = FirstSeed; seed < FirstSeed + Seeds; seed++)
            {
                var link = Link(network, seed);
                var run = new SyncRun(new DefaultClockEstimator());
                run.Run(link, 0, ChangeAt);
                link.LongerDownMs = changeMs;
                run.Run(link, ChangeAt, ChangeAt + 300);
                link.LongerUpMs = 4;
                run.Run(link, ChangeAt + 300, ChangeAt + 600);

                var after = run.Instants.Where(i => i.At > ChangeAt + 305).ToArray();
                var share = after.Average(i => Math.Abs(i.ErrorMs) <= i.Model.EstimatedError.TotalMilliseconds ? 1 : 0);
                var before = run.Instants.Last(i => i.At < ChangeAt + 300).Model.EstimatedError.TotalMilliseconds;
                Assert.That(after.Min(i => i.Model.EstimatedError.TotalMilliseconds), Is.GreaterThan(0.9 * before), "seed " + seed);
                Assert.That(share, Is.GreaterThan(0.99), "seed " + seed);
            }
        }

        [Test]
        public void Skew_DelayFallsBelowItsMinimum_ChangesByAFewPpmAtMost(
            [Values("lan", "wifi", "busy-wifi")] string network, [Values(2.0, 4.0, 20.0)] double changeMs)
        {
            for (var seed = FirstSeed; seed < FirstSeed + Seeds; seed++)
            {
                var link = Link(network, seed);
                link.LongerUpMs = changeMs;
                var run = new SyncRun(new DefaultClockEstimator());
                run.Run(link, 0, ChangeAt);
                link.LongerUpMs = 0;
                run.Run(link, ChangeAt, ChangeAt + 120);

                Assert.That(SkewDeviationPpm(run), Is.LessThan(network == "busy-wifi" ? 7 : 5), "seed " + seed);
                Assert.That(run.PercentileMs(ChangeAt + 60, 1), Is.LessThan(network == "busy-wifi" ? 0.3 : 0.15),
                    "the path is symmetric again; seed " + seed);
            }
        }

        [Test]
        public void Error_DelayFallsBelowItsMinimum_StaysWithinTheEstimatedError()
        {
            const string network = "wifi";
            const double changeMs = 1;
            for (var seed = FirstSeed; seed < FirstSeed + Seeds; seed++)
            {
                var run = Run(Link(network, seed), 0, -changeMs);

                Assert.That(run.ErrorsMs(ChangeAt + 5).Max(), Is.LessThan(1.2 * changeMs / 2 + 0.15), "seed " + seed);
                var last = run.Instants.Last();
                Assert.That(Math.Abs(last.ErrorMs), Is.LessThan(last.Model.EstimatedError.TotalMilliseconds), "estimated error; seed " + seed);
            }
        }
    }
}
