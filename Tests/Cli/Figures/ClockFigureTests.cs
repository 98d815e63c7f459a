using System.Text.Json;
using Nowpose.Cli.Figures;
using Nowpose.Cli.Figures.Clocks;
using Nowpose.Cli.Figures.Field;
using Nowpose.Cli.Figures.Model;
using Nowpose.Cli.Messages;
using Nowpose.Sync;
using Nowpose.Web;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Figures;

public class ClockFigureTests
{
    static readonly FigureSettings Settings = new() { Phases = 2, ClockRuns = 4, ClockSeconds = 60, Seed = 11 };

    [Test]
    public void Exchanges_Wifi_ErrByAtMostHalfTheRoundTripTime()
    {
        var log = new SimulatedExchanges(Settings.Seed, 60);

        Assert.That(log.All, Has.Count.InRange(280, 300), "one every 200 ms, a few of them late");
        foreach (var each in log.All)
            Assert.That((each.Offset - log.TrueOffset(each.T4)).Duration(), Is.LessThanOrEqualTo(each.RoundTripTime / 2 + TimeSpan.FromTicks(100)));
    }

    [Test]
    public void SkewPpmAt_SimulatedExchanges_EqualsTheSlopeOfTheOffset()
    {
        var log = new SimulatedExchanges(Settings.Seed, 60);

        var slope = (log.TrueOffset(HeadsetTime.FromSeconds(31)) - log.TrueOffset(HeadsetTime.FromSeconds(29))).TotalMicroseconds / 2;

        Assert.That(slope, Is.EqualTo(log.SkewPpmAt(30)).Within(0.1), $"seed {Settings.Seed}");
    }

    [Test]
    public void Figures4And8_PaperEstimator_ErrsByLessThanAMillisecond()
    {
        var study = new ClockAndFieldStudy(Settings);
        Parallel.ForEach(study.Work, work => work());

        var figures = study.Figures().ToDictionary(f => f.Number);

        Assert.That(figures["8"].Criteria[1].IsMet, Is.True, $"{figures["8"].Criteria[1].Measured}, seed {Settings.Seed}");
        var (paper, ours) = (P95(figures["8"], "ransac"), P95(figures["8"], "default"));
        Assert.That(ours, Is.LessThan(0.5 * paper), $"the default beside the paper's on the same exchanges, seed {Settings.Seed}");
        Assert.That(figures["8"].Table.Rows, Has.Count.EqualTo(300), "the table has one row for each exchange");
        Assert.That(figures["4"].Verdict, Is.EqualTo(Verdict.Holds), figures["4"].Criteria[0].Measured);
    }

    [Test]
    public void SyncSteps_Quantities_SatisfyThePapersEquations()
    {
        var log = new SimulatedExchanges(Settings.Seed, 60);

        var steps = SyncSteps.Of(log.All, "ransac");

        Assert.That(steps, Has.Count.EqualTo(log.All.Count));
        Assert.That(steps[0].OffsetMs, Is.Zero, "offsets are relative to the first one");
        foreach (var step in steps.Where(step => step.FitMs.HasValue))
        {
            Assert.That(step.FitErrorMs, Is.EqualTo(step.OffsetMs - step.FitMs).Within(1e-9), "Eq. 6");
            Assert.That(step.InterceptMs + 1e-3 * step.SkewPpm * step.Seconds, Is.EqualTo(step.FitMs).Within(1e-9), "Eq. 3");
        }
        Assert.That(steps[^1].SkewPpm, Is.EqualTo(log.SkewPpmAt(50)).Within(15), $"seed {Settings.Seed}");
        Assert.That(steps.Min(step => step.RoundTripMs), Is.GreaterThan(3), "each direction takes at least 1.5 ms");
    }

    // In this network, 5.5 % of the exchanges are in a burst with delays of 5 to 30 ms. For 4.6 % of the other exchanges, half the difference of two
    // gamma-distributed jitters (shape 1.2, scale 0.6 ms) is 1 ms or more.
    [Test]
    public void FitErrors_TrueOffset_MatchTheNetworksDelays()
    {
        double[] errors = [.. Enumerable.Range(1, 20).Select(seed => new SimulatedExchanges(seed, 60))
            .SelectMany(log => FitErrors.OfExchanges(SyncSteps.Of(log.All, "ransac"), log.All[0].Offset, log.TrueOffset))];

        Assert.That(FitErrors.ShareBelow(errors), Is.EqualTo(0.945 * 0.954).Within(0.015));
    }

    // Adds exchanges whose reply precedes the request, with negative round-trip times, and exchanges that are logged twice.
    [Test]
    public void SyncSteps_InvalidExchanges_AreIgnored()
    {
        var log = new SimulatedExchanges(Settings.Seed, 60);
        IEnumerable<SyncExchange> WithInvalid(SyncExchange each, int i) => i % 25 == 0
            ? [new(each.T1, each.T2, each.T3, each.T1 - TimeSpan.FromMilliseconds(3)), each, each] : [each];

        var steps = SyncSteps.Of(log.All.SelectMany(WithInvalid), "ransac");

        Assert.That(steps, Is.EqualTo(SyncSteps.Of(log.All, "ransac")));
    }

    [TestCase(0, false)]
    [TestCase(700, true)]
    public void SyncFigure_SlowFirstExchange_LimitsTheVerticalAxis(double firstMs, bool isLimited)
    {
        SyncStep[] steps = [.. Steps(0.05, 0.8, 3, 0.5).Select((step, i) => i == 0 ? step with { OffsetMs = firstMs } : step)];

        var plot = SyncFigure.Of(steps, SyncClaims.Of(steps), "").Plots[0];

        Assert.That(plot.YRange.HasValue, Is.EqualTo(isLimited));
        Assert.That(plot.Title.EndsWith(Figure08Texts.BeyondAxis("", 1, 600), StringComparison.Ordinal), Is.EqualTo(isLimited), plot.Title);
        if (plot.YRange is var (from, to))
            Assert.That(new[] { from, to }, Is.EqualTo(new[] { -2.4, 2.4 }).Within(1e-9), "three times the range of the settled values");
    }

    static double P95(Figure figure, string estimator) => double.Parse(
        figure.Summary.Rows.Single(row => row[0] == estimator)[2], System.Globalization.CultureInfo.InvariantCulture);

    [TestCase(0.96, 312, 88, 7, 280, 12_300, Verdict.Holds)]
    [TestCase(0.94, 312, 88, 7, 280, 12_300, Verdict.HoldsPartly)]
    [TestCase(0.96, 1312, 88, 7, 280, 12_300, Verdict.HoldsPartly)]
    [TestCase(0.94, 1312, 88, 50, 280, 400, Verdict.DoesNotHold)]
    public void Figure8_MeasuredValues_DecideTheVerdict(
        double fitShare, double maxUs, double early, double late, double shortUs, double longUs, object verdict)
    {
        var criteria = Figure08.Criteria(fitShare, new ClockErrors(50, 200, maxUs, early, late), new RoundTrips(shortUs, longUs));

        Assert.That(Criterion.Judge(criteria), Is.EqualTo(verdict));
    }

    [TestCase(30.2, Verdict.Holds)]
    [TestCase(31, Verdict.HoldsPartly)]
    [TestCase(3, Verdict.DoesNotHold)]
    public void Figure4_ErrorOfHold_DecidesTheVerdict(double freshMm, object verdict)
    {
        Assert.That(Criterion.Judge(Figure04.Criteria([new FieldPoint(1000, 30, freshMm, 55, [])])), Is.EqualTo(verdict));
    }

    static SyncStep[] Steps(double shortMs, double longMs, double earlyPpm, double latePpm) => [.. Enumerable.Range(0, 300).Select(i =>
    {
        var (sign, isShort, seconds) = (i % 2 == 0 ? 1 : -1, i % 4 < 2, i * 0.2);
        var skew = 40 + sign * (seconds < 45 ? earlyPpm : latePpm);
        return new SyncStep(seconds, sign * (isShort ? shortMs : longMs), 0, skew, 0, isShort ? 4 : 12);
    })];

    [TestCase(0.05, 0.8, 3, 0.5, new[] { true, true, true })]
    [TestCase(0.05, 1.2, 3, 0.5, new[] { false, true, true }, TestName = "SyncClaims_HalfOfTheExchangesFitTheClock_IsNotMet")]
    [TestCase(1.2, 3, 3, 0.5, new[] { false, true, true })]
    [TestCase(0.05, 0.8, 3, 2, new[] { true, false, true })]
    [TestCase(0.5, 0.8, 3, 0.5, new[] { true, true, false })]
    public void SyncClaims_MeasuredValues_DecideTheVerdict(double shortMs, double longMs, double earlyPpm, double latePpm, bool[] areMet)
    {
        var claims = SyncClaims.Of(Steps(shortMs, longMs, earlyPpm, latePpm));

        Assert.That(claims.Select(claim => claim.IsMet), Is.EqualTo(areMet), string.Join("; ", claims.Select(claim => claim.Measured)));
    }

    // The skew changes from 10 to 35 ppm, either at a constant rate or exponentially, as if it converged.
    [TestCase(20, double.PositiveInfinity, false)]
    [TestCase(60, double.PositiveInfinity, false)]
    [TestCase(600, double.PositiveInfinity, false)]
    [TestCase(60, 30, true)]
    [TestCase(60, 8, true)]
    [TestCase(600, 60, true)]
    public void SyncClaims_ChangingSkew_ConvergesOnlyIfTheChangesDecrease(double seconds, double timeConstant, bool isMet)
    {
        double SkewAt(double t) => double.IsInfinity(timeConstant) ? 10 + 25 * t / seconds : 35 - 25 * Math.Exp(-t / timeConstant);
        SyncStep[] steps = [.. Enumerable.Range(0, (int)(5 * seconds)).Select(i => new SyncStep(i * 0.2, 0.1, 0, SkewAt(i * 0.2), 0, 4))];

        var claim = SyncClaims.Of(steps)[1];

        Assert.That(claim.IsMet, Is.EqualTo(isMet), claim.Measured);
    }

    [TestCase(30, 45)]
    [TestCase(0, 10)]
    public void SyncClaims_SkewTemporarilyUnknown_IsNotMeasured(double from, double to)
    {
        var steps = Steps(0.05, 0.8, 3, 0.5).Select(step => step.Seconds >= from && step.Seconds < to ? step with { FitMs = null, SkewPpm = null } : step);

        Assert.That(SyncClaims.Of([.. steps])[1].IsMet, Is.Null);
    }

    [Test]
    public void PlainPage_ClaimsOfAShortLog_AreNotMeasured()
    {
        var steps = Steps(0.05, 0.8, 3, 0.5)[..60];
        using var data = JsonDocument.Parse(FiguresJson.Of("Log", "", [], [], [SyncFigure.Of(steps, SyncClaims.Of(steps), "")]));

        var page = PlainFigures.Render(data.RootElement);

        var measured = $"<td>{Figure08Texts.TooFewExchanges(10, 20)}</td><td>{Verdict.NotMeasured.Words()}</td>";
        Assert.That(page.Split(measured), Has.Length.EqualTo(4), page);
    }

    [Test]
    public void SyncClaims_ShortLog_AreNotMeasured()
    {
        var claims = SyncClaims.Of(Steps(0.05, 0.8, 3, 0.5)[..60]);

        Assert.That(claims.Select(claim => claim.IsMet), Is.Not.Empty.And.All.Null);
        Assert.That(claims.Select(claim => claim.Measured), Is.Not.Empty.And.All.EqualTo(Figure08Texts.TooFewExchanges(10, 20)));
    }
}
