using Nowpose.Cli.Calibrate.Range;
using Nowpose.Cli.Calibrate.Simulate;
using Nowpose.Cli.Messages;
using Nowpose.Latency;
using Nowpose.Latency.Conditions;
using Nowpose.Simulation;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Calibrate;

public class RangeFitTests
{
    const double TrueLimitMs = 1000 / 60.0 - 1.5;
    const double PlateauMs = 40;
    static readonly double[] BelowTheLimit = Enumerable.Range(0, 11).Select(i => 100_000.0 * i).ToArray();

    static int CountNear(SimulatedPictures pictures, out string limits)
    {
        var found = Enumerable.Range(2000, 100).Select(seed => RangeFit.Fit(pictures.Take(seed)).LimitRenderMs ?? 0).ToArray();
        limits = "limits " + string.Join(" ", found.OrderBy(limit => limit).Select(limit => limit.ToString("0.00")));
        return found.Count(limit => limit >= 0.94 * TrueLimitMs && limit <= 1.02 * TrueLimitMs);
    }

    [TestCase(30)]
    [TestCase(100)]
    public void Fit_SweepAcrossTheLimit_ErrsByMinusSixToPlusTwoPercent(int perLoad)
    {
        var near = CountNear(new SimulatedPictures { PerLoad = perLoad }, out var limits);

        Assert.That(near, Is.GreaterThanOrEqualTo(95), limits);
    }

    // The render time that is logged for a picture is that of the newest finished frame. Near the limit, it does not show which frames are late.
    [TestCase(30, 85)]
    [TestCase(100, 95)]
    public void Fit_RenderTimesOfEarlierFrames_ErrsByMinusSixToPlusTwoPercent(int perLoad, int minCount)
    {
        var limits = Enumerable.Range(2000, 100).Select(seed =>
        {
            var sweep = new SimulatedSweep(new SimulationSettings { LoadSteps = 20, Pictures = 21 * perLoad, Seed = seed });
            return RangeFit.Fit(sweep.Moments.Select(sweep.Measured)).LimitRenderMs ?? 0;
        }).Order().ToArray();
        var trueLimitMs = SimulatedSweep.RefreshMs - 1.5;

        Assert.That(
            limits.Count(limit => limit >= 0.94 * trueLimitMs && limit <= 1.02 * trueLimitMs), Is.GreaterThanOrEqualTo(minCount),
            "limits " + string.Join(" ", limits.Select(limit => limit.ToString("0.00"))));
    }

    // A display that scans each frame twice, with an exposure of 8 ms: a frame is seen in one scan or the other, half a refresh interval apart.
    [TestCase(20, 100, 95)]
    [TestCase(10, 100, 95)]
    [TestCase(10, 30, 90)]
    public void Fit_FramesScannedTwice_ErrsByMinusSixToPlusTwoPercent(int loadSteps, int perLoad, int minCount)
    {
        var origin = new PairOrigin(RenderTimeSourceKind.DisplayGpuTime, new DisplayConditions(displayHz: 60));
        var limits = Enumerable.Range(1, 100).Select(seed =>
        {
            var sweep = new SimulatedSweep(new SimulationSettings { LoadSteps = loadSteps, Pictures = (loadSteps + 1) * perLoad, Seed = seed });
            var random = new Random(seed);
            var pairs = sweep.Moments.Where(moment => sweep.Rows[moment.Frame].RenderMs.HasValue).Select(moment => new LatencyPair(
                sweep.Rows[moment.Frame].RenderMs.Value, (sweep.LightOf(moment.Frame) - sweep.StartOf(moment.Frame)).TotalMilliseconds
                    + SimulatedSweep.RefreshMs * (random.Next(2) == 0 ? -0.25 : 0.25) + 6.3 * (random.NextDouble() - 0.5))).ToArray();
            return RangeFit.Fit(pairs, origin).LimitRenderMs ?? 0;
        }).Order().ToArray();
        var trueLimitMs = SimulatedSweep.RefreshMs - 1.5;

        Assert.That(
            limits.Count(limit => limit >= 0.94 * trueLimitMs && limit <= 1.02 * trueLimitMs), Is.GreaterThanOrEqualTo(minCount),
            "limits " + string.Join(" ", limits.Select(limit => limit.ToString("0.00"))));
    }

    [Test]
    public void Fit_CoarseLoadsAndFewPictures_FindsTheLimit()
    {
        var coarse = new SimulatedPictures { PerLoad = 20, Loads = Enumerable.Range(0, 11).Select(i => 200_000.0 * i).ToArray() };

        Assert.That(CountNear(coarse, out var limits), Is.GreaterThanOrEqualTo(95), limits);
    }

    // All pictures at one load have nearly the same render time, so the gap around the limit is as wide as a load step.
    [TestCase(0.001)]
    [TestCase(0.003)]
    [TestCase(0.01)]
    public void Fit_CoarseLoadsWithConstantRenderTimes_FindsTheLimit(double scatter)
    {
        var steady = new SimulatedPictures
        {
            PerLoad = 30, Loads = Enumerable.Range(0, 11).Select(i => 200_000.0 * i).ToArray(),
            Display = new DisplayPipelineSettings(scatter: scatter),
        };

        Assert.That(CountNear(steady, out var limits), Is.GreaterThanOrEqualTo(95), limits);
    }

    [Test]
    public void Fit_FivePercentMisreadPicturesAndThreePercentSlowFrames_FindsTheLimit()
    {
        var spoiled = new SimulatedPictures { Misread = 0.05, Display = new DisplayPipelineSettings(spikeChance: 0.03) };

        Assert.That(CountNear(spoiled, out var limits), Is.GreaterThanOrEqualTo(95), limits);
    }

    [Test]
    public void Fit_PicturesMisreadByUpToAPeriod_AreRejected()
    {
        foreach (var seed in Enumerable.Range(1, 20))
        {
            var pairs = new SimulatedPictures { Misread = 0 }.Take(seed);
            var random = new Random(seed);
            var spoiled = pairs.Select(
                (pair, i) => i % 50 == 0 ? new LatencyPair(pair.RenderMs, 65_536 * (2 * random.NextDouble() - 1)) : pair).ToArray();

            RangeFitResult clean = RangeFit.Fit(pairs), fit = RangeFit.Fit(spoiled);

            Assert.That(fit.VisuMs, Is.EqualTo(clean.VisuMs).Within(0.1), "seed " + seed);
            Assert.That(fit.LimitRenderMs, Is.EqualTo(clean.LimitRenderMs.Value).Within(0.05), "seed " + seed);
        }
    }

    // On a display that is lit continuously, a frame is seen up to half a refresh interval before or after its middle.
    [Test]
    public void Fit_LatencyScattersByHalfARefreshPeriod_FindsTheLimit()
    {
        var near = CountNear(new SimulatedPictures { NoiseMs = 4 }, out var limits);

        Assert.That(near, Is.GreaterThanOrEqualTo(90), limits);
    }

    [TestCase(30, 0.02, 0.01)]
    [TestCase(30, 0.05, 0.01)]
    [TestCase(100, 0.02, 0.03)]
    public void Fit_AllLoadsBelowTheLimit_FindsNoLimit(int perLoad, double misread, double spikeChance)
    {
        var plateau = new SimulatedPictures { PerLoad = perLoad, Loads = BelowTheLimit, Misread = misread, Display = new DisplayPipelineSettings(spikeChance: spikeChance) };

        foreach (var seed in Enumerable.Range(3000, 100))
        {
            var pairs = plateau.Take(seed);

            var fit = RangeFit.Fit(pairs);

            Assert.That(fit.LimitRenderMs, Is.Null, "seed " + seed);
            Assert.That(fit.ValidToRenderMs, Is.InRange(0.9 * pairs.Select(pair => pair.RenderMs).Where(each => each < TrueLimitMs).Max(), 32), "seed " + seed);
        }
    }

    [Test]
    public void Fit_Sweep_FindsThePlateauAndItsSpread()
    {
        foreach (var seed in Enumerable.Range(1, 20))
        {
            var fit = RangeFit.Fit(new SimulatedPictures().Take(seed));

            Assert.That(fit.VisuMs, Is.EqualTo(PlateauMs).Within(0.25), "seed " + seed);
            Assert.That(fit.SpreadMs, Is.InRange(0.8, 1.4), "seed " + seed);
            Assert.That(fit.Rejected, Is.InRange(1, 0.08 * fit.Pairs), "seed " + seed);
        }
    }

    [Test]
    public void Fit_StepInTheLatency_PutsTheLimitAtTheStep()
    {
        var pairs = Enumerable.Range(0, 200).Select(i => new LatencyPair(5 + 0.1 * i, i < 100 ? 40 : 57)).ToArray();

        var fit = RangeFit.Fit(pairs);

        Assert.That(fit.LimitRenderMs, Is.GreaterThan(14.9).And.LessThan(15));
        Assert.That(fit.VisuMs, Is.EqualTo(40));
        Assert.That(fit.Rejected, Is.Zero);
        Assert.That((fit.Pairs, fit.Used), Is.EqualTo((200, 100)), "L_visu uses only the pairs before the turn");
    }

    [Test]
    public void Fit_LatencyConstantEverywhere_IsValidUpToTheMaximumRenderTime()
    {
        var fit = RangeFit.Fit(Enumerable.Range(0, 60).Select(i => new LatencyPair(4 + 0.1 * i, 40 + i % 3)).ToArray());

        Assert.That(fit.LimitRenderMs, Is.Null);
        Assert.That(fit.ValidToRenderMs, Is.EqualTo(9.9).Within(1e-9));
    }

    [Test]
    public void Fit_TooFewPairs_StatesTheMinimum() =>
        Assert.That(() => RangeFit.Fit(new LatencyPair[19]), Throws.TypeOf<InputException>().With.Message.Contains("19").And.Message.Contains("20"));

    // Some sources count whole milliseconds or frames. The limit must not be within a group of equal render times.
    [TestCase(1)]
    [TestCase(2)]
    [TestCase(1000 / 60.0)]
    public void Fit_RoundedRenderTimes_PutsTheLimitBetweenTwoValues(double stepMs)
    {
        foreach (var seed in Enumerable.Range(1, 20))
        {
            var pairs = new SimulatedPictures().Take(seed)
                .Select(pair => new LatencyPair(Math.Ceiling(pair.RenderMs / stepMs) * stepMs, pair.VisuMs)).ToArray();

            var limit = RangeFit.Fit(pairs).LimitRenderMs;

            // The limit must lie between the two rounded values next to the true limit, or at most 2.1 % above the larger one.
            var (before, after) = (Math.Floor(TrueLimitMs / stepMs) * stepMs, Math.Ceiling(TrueLimitMs / stepMs) * stepMs);
            Assert.That(limit, Is.InRange(before - 1e-9, 1.021 * after), "seed " + seed);
        }
    }

    [Test]
    public void Fit_ConstantRenderTime_FindsNoLimit()
    {
        var pairs = new SimulatedPictures().Take(1).Select(pair => new LatencyPair(8, pair.VisuMs)).ToArray();

        double? limit = null;
        try
        {
            limit = RangeFit.Fit(pairs).LimitRenderMs;
        }
        catch (InputException)
        {
            // The exception is an acceptable result, because the fit need not find a limit.
        }

        Assert.That(limit, Is.Null);
    }

    [Test]
    public void Fit_NoiseWithoutAPlateau_Throws()
    {
        var random = new Random(4);
        var noise = Enumerable.Range(0, 300).Select(i => new LatencyPair(4 + 0.05 * i, 20 + 60 * random.NextDouble())).ToArray();

        var fault = Assert.Throws<InputException>(() => RangeFit.Fit(noise));
        var numbers = MessageNumbers.In(fault.Message, RangeMessages.Scatters(0, 0));
        Assert.That(numbers[0], Is.GreaterThan(10), "scatter, ms");
        Assert.That(numbers[1], Is.EqualTo(10), "maximum, ms");
    }

    [TestCase(21, false)]
    [TestCase(5, true)]
    public void Fit_ManyOrFewLoads_StatesTheRangeOfTheLimitOnlyIfFew(int loads, bool isOpen)
    {
        var pictures = new SimulatedPictures { Loads = Enumerable.Range(0, loads).Select(i => 2e6 * i / (loads - 1)).ToArray() };

        foreach (var seed in Enumerable.Range(1, 20))
        {
            var fit = RangeFit.Fit(pictures.Take(seed));

            Assert.That(fit.OpenToRenderMs.HasValue, Is.EqualTo(isOpen), "seed " + seed);
            if (isOpen) Assert.That(TrueLimitMs, Is.InRange(fit.LimitRenderMs, fit.OpenToRenderMs), "seed " + seed);
        }
    }

    // Any input must lead to a plausible result or to an error message that states why there is none.
    [Test]
    public void Fit_RandomPairs_ReturnsAPlausibleResultOrThrows()
    {
        var refused = 0;
        for (var seed = 0; seed < 500; seed++)
        {
            var random = new Random(seed);
            var clusters = Enumerable.Range(0, 1 + random.Next(5)).Select(_ => -500 + 1000 * random.NextDouble()).ToArray();
            var width = Math.Pow(10, 3 * random.NextDouble() - 1);
            var pairs = Enumerable.Range(0, 20 + random.Next(60)).Select(_ => new LatencyPair(
                0.1 + 30 * random.NextDouble(), clusters[random.Next(clusters.Length)] + width * (random.NextDouble() - 0.5))).ToArray();
            try
            {
                var fit = RangeFit.Fit(pairs);

                Assert.That(fit.ValidToRenderMs, Is.InRange(pairs.Min(pair => pair.RenderMs), pairs.Max(pair => pair.RenderMs)), "seed " + seed);
                Assert.That(fit.VisuMs, Is.InRange(-1000, 1000), "seed " + seed);
            }
            catch (InputException)
            {
                refused++;
            }
        }
        Assert.That(refused, Is.InRange(1, 400));
    }
}
