using Nowpose.Cli.Calibrate;
using Nowpose.Cli.Calibrate.Range;
using Nowpose.Cli.Figures;
using Nowpose.Cli.Figures.Display;
using Nowpose.Cli.Figures.Model;
using Nowpose.Cli.Messages;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Figures;

/// <summary>Tests Figs 10 and 11 with the simulated display on several seeds, and with artificial values that change the verdicts.</summary>
public class DisplayFigureTests
{
    const double StoredMs = 40, LimitMs = 15.2;

    /// <summary>
    /// Half-widths of the uniform scatter of L_visu, ms. Still: scatter of the camera's readings while L_visu is constant. Refresh: L_visu varies
    /// over one refresh interval. Between: a value between the two.
    /// </summary>
    const double Still = 1, Refresh = 8.3, Between = 5;

    static readonly Dictionary<int, Figure[]> Seeds = [];

    [OneTimeSetUp]
    public static void Compute()
    {
        foreach (var seed in Enumerable.Range(1, 20))
        {
            var study = new DisplayStudy(FigureSettings.Quick with { Seed = seed });
            foreach (var work in study.Work) work();
            Seeds[seed] = [.. study.Figures()];
        }
    }

    [TestCase("10")]
    [TestCase("11a")]
    [TestCase("11b")]
    public void Criteria_SimulatedDisplay_AreMetForEachSeed(string number)
    {
        foreach (var (seed, figures) in Seeds)
            foreach (var criterion in figures.Single(each => each.Number == number).Criteria)
                Assert.That(criterion.IsMet, Is.True, $"seed {seed}: {criterion.Measured}");
    }

    // Computes the deviations from the data that the figure shows.
    [Test]
    public void Figure10_EachSeed_LatencyDeviatesAtLeastThreeTimesAsMuchAtTheHighLoad()
    {
        foreach (var (seed, figures) in Seeds)
        {
            var table = figures.Single(each => each.Number == "10").Table;
            double Deviation(int column) => Spread.Of(table.Rows.Where(row => row[column].HasValue).Select(row => row[column].Value)).Deviation;

            Assert.That(Deviation(4), Is.GreaterThanOrEqualTo(3 * Deviation(2)), $"seed {seed}");
        }
    }

    // A picture is taken at a random time within the 4 ms for which its frame is lit. The headset's code has a resolution of 1 ms.
    [Test]
    public void Figure10_NormalLoad_ScatterMatchesLitTimeAndCodeResolution()
    {
        var expected = Math.Sqrt((4 * 4 + 1 * 1) / 12.0);
        foreach (var (seed, figures) in Seeds)
        {
            var visuMs = figures.Single(each => each.Number == "10").Table.Rows.Where(row => row[2].HasValue).Select(row => row[2].Value).ToArray();
            var (median, deviation) = Middle.Of(visuMs);

            Assert.That(median, Is.EqualTo(StoredMs).Within(0.5), $"seed {seed}");
            Assert.That(deviation, Is.EqualTo(0.34 * 4).Within(30).Percent, $"seed {seed}: half of the middle 68 % of an even scatter over 4 ms");
            Assert.That(Spread.Of(visuMs).Deviation, Is.EqualTo(expected).Within(20).Percent, $"seed {seed}");
        }
    }

    // Computes the deviation independently of the figure, with steps three times as narrow and a separate variance for each step.
    [Test]
    public void Figure11_EachSeed_LatencyDeviatesAtLeastThreeTimesAsMuchAboveTheLimit()
    {
        foreach (var (seed, figures) in Seeds)
        {
            (double RenderMs, double VisuMs)[] pictures =
                [.. figures.Single(each => each.Number == "11b").Table.Rows.Select(row => (row[1].Value, row[2].Value))];
            var inside = Spread.Of(pictures.Where(each => each.RenderMs <= LimitMs).Select(each => each.VisuMs));
            double[][] steps = [.. pictures.Where(each => each.RenderMs > LimitMs).GroupBy(each => (int)(3 * each.RenderMs), each => each.VisuMs)
                .Where(step => step.Count() >= 30).Select(step => step.ToArray())];

            var squares = steps.Sum(step => (step.Length - 1) * Math.Pow(Spread.Of(step).Deviation, 2));
            var deviation = Math.Sqrt(squares / steps.Sum(step => step.Length - 1));

            Assert.That(deviation, Is.GreaterThanOrEqualTo(3 * inside.Deviation), $"seed {seed}");
        }
    }

    // Creates values that are distributed uniformly around the middle, in random order.
    static IEnumerable<MeasuredPicture> Pictures(double millions, double renderMs, double visuMs, double halfWidthMs) => Enumerable.Range(0, 100)
        .Select(i => new MeasuredPicture(null, (int)(1e6 * millions), renderMs, visuMs + halfWidthMs * (i * 37 % 100 - 49.5) / 50));

    [TestCase(Still, Refresh, Verdict.Holds)]
    [TestCase(Still, Between, Verdict.HoldsPartly)]
    [TestCase(Between, Refresh, Verdict.HoldsPartly)]
    [TestCase(Between, Between, Verdict.DoesNotHold)]
    [TestCase(Between, 0, Verdict.DoesNotHold)]
    public void Figure10_Scatter_DecidesTheVerdict(double normalMs, double highMs, object verdict)
    {
        var criteria = Figure10.Criteria([.. Pictures(0.3, 6.5, 40, normalMs)], [.. Pictures(1.5, 17, 65, highMs)]);

        Assert.That(Criterion.Judge(criteria), Is.EqualTo(verdict));
    }

    // On a display that starts every frame at a refresh, L_visu is longer at the high load but still constant.
    [Test]
    public void Figure10_SecondPlateau_IsNotScatter()
    {
        var criteria = Figure10.Criteria([.. Pictures(0.3, 6.5, 40, Still)], [.. Pictures(1.5, 17, 73.3, Still)]);

        Assert.That(criteria.Select(c => c.IsMet), Is.EqualTo(new[] { true, false, false }));
    }

    [Test]
    public void Figure10_OneSlowFrame_IsNotScatter()
    {
        var high = Pictures(1.5, 17, 56.7, Still).ToArray();
        high[40] = high[40] with { VisuMs = 200 };

        var criteria = Figure10.Criteria([.. Pictures(0.3, 6.5, 40, Still)], high);

        Assert.That(criteria.Select(c => c.IsMet), Is.EqualTo(new[] { true, false, false }));
    }

    [Test]
    public void Figure10_OneSlowFrameAtTheNormalLoad_Holds()
    {
        var normal = Pictures(0.3, 6.5, 40, Still).ToArray();
        normal[40] = normal[40] with { VisuMs = 200 };

        Assert.That(Criterion.Judge(Figure10.Criteria(normal, [.. Pictures(1.5, 17, 65, Refresh)])), Is.EqualTo(Verdict.Holds));
    }

    // Two loads within the range, one between the limit and a refresh interval, and two beyond a refresh interval.
    static IEnumerable<MeasuredPicture> Sweep(double insideMs, double secondMs, double lateMs, double beyondMs, double lastMs) =>
    [
        .. Pictures(0, 4, StoredMs, insideMs), .. Pictures(1, 12.5, secondMs, insideMs), .. Pictures(1.4, 15.9, 56.7, lateMs),
        .. Pictures(1.6, 17.6, 66, beyondMs), .. Pictures(2, 21, 72, lastMs),
    ];

    [TestCase(Still, 40.5, Refresh, Verdict.Holds)]
    [TestCase(Still, 42, Refresh, Verdict.HoldsPartly, TestName = "Figure11a_MedianMoves_HoldsPartly")]
    [TestCase(Still, 40.5, Between, Verdict.HoldsPartly, TestName = "Figure11a_ScatterBelowARefreshPeriod_HoldsPartly")]
    [TestCase(Still, 40.5, Still, Verdict.HoldsPartly, TestName = "Figure11a_LatencyConstantBeyondTheLimit_HoldsPartly")]
    [TestCase(Between, 42, Between, Verdict.DoesNotHold)]
    [TestCase(Still, 42, Still, Verdict.DoesNotHold)]
    public void Figure11a_MeasuredValues_DecideTheVerdict(double insideMs, double secondMs, double beyondMs, object verdict)
    {
        var criteria = Figure11.LoadCriteria(Sweep(insideMs, secondMs, beyondMs, beyondMs, beyondMs), StoredMs);

        Assert.That(Criterion.Judge(criteria), Is.EqualTo(verdict));
    }

    // Of the three groups beyond the limit, two scatter. Together they meet the criteria, and the result names the third group.
    [Test]
    public void Figure11_OneGroupIsConstantBeyondTheLimit_NamesTheGroup()
    {
        var sweep = Sweep(Still, 40.5, Still, Refresh, Refresh).ToList();

        var (loads, steps) = (Figure11.LoadCriteria(sweep, StoredMs), Figure11.RangeCriteria(sweep, StoredMs, LimitMs, LimitMs));

        Assert.That(loads, Has.Count.GreaterThan(1));
        Assert.That(steps, Has.Count.GreaterThan(2));
        foreach (var criterion in loads.Skip(1))
            Assert.That((criterion.IsMet, criterion.Measured.Contains(Figure11Texts.IndividuallyTooSmall("", "1.4 million ("))),
                Is.EqualTo((true, true)));
        foreach (var criterion in steps.Skip(2))
            Assert.That((criterion.IsMet, criterion.Measured.Contains(Figure11Texts.IndividuallyTooSmall("", Figure11Texts.Step("15.2") + " ("))),
                Is.EqualTo((true, true)));
    }

    [TestCase(4, true)]
    [TestCase(20, false)]
    public void Figure11a_LoadsOnOneSideOfTheLimit_DoNotMeetAllCriteria(double renderMs, bool isConstant)
    {
        var criteria = Figure11.LoadCriteria([.. Pictures(0, renderMs, StoredMs, Still), .. Pictures(1, renderMs, StoredMs, Still)], StoredMs);

        Assert.That(criteria.Select(c => c.IsMet), Is.EqualTo(new[] { isConstant, false, false }));
    }

    [TestCase(Still, Refresh, 15.0, Verdict.Holds)]
    [TestCase(Still, Between, 15.0, Verdict.HoldsPartly, TestName = "Figure11b_ScatterBelowARefreshPeriod_HoldsPartly")]
    [TestCase(Still, Refresh, 13.0, Verdict.HoldsPartly, TestName = "Figure11b_LimitDependsOnTheScene_HoldsPartly")]
    [TestCase(Between, Refresh, 15.0, Verdict.HoldsPartly, TestName = "Figure11b_LatencyScattersWithinTheRange_HoldsPartly")]
    [TestCase(Still, Still, 15.0, Verdict.HoldsPartly, TestName = "Figure11b_LatencyConstantOutsideTheRange_HoldsPartly")]
    [TestCase(Between, Still, 13.0, Verdict.DoesNotHold)]
    public void Figure11b_MeasuredValues_DecideTheVerdict(double insideMs, double beyondMs, double otherLimitMs, object verdict)
    {
        var criteria = Figure11.RangeCriteria([.. Sweep(insideMs, StoredMs, beyondMs, beyondMs, beyondMs)], StoredMs, LimitMs, otherLimitMs);

        Assert.That(Criterion.Judge(criteria), Is.EqualTo(verdict));
    }

    // Three plateaus of L_visu, 9 and 6 ms apart: in all, L_visu varies by about a refresh interval, but at each render time it is constant.
    [Test]
    public void Figure11_PlateausBeyondTheLimit_AreNotScatter()
    {
        var sweep = Sweep(Still, StoredMs, Still, Still, Still).ToList();

        var (loads, steps) = (Figure11.LoadCriteria(sweep, StoredMs), Figure11.RangeCriteria(sweep, StoredMs, LimitMs, LimitMs));

        Assert.That(loads.Select(c => c.IsMet), Is.EqualTo(new[] { true, false, false }));
        Assert.That(steps.Select(c => c.IsMet), Is.EqualTo(new[] { true, true, false, false }));
    }

    [TestCase(15.2, 14.0, true)]
    [TestCase(15.2, 13.9, false)]
    [TestCase(15.2, null, false)]
    [TestCase(null, null, false)]
    public void Figure11b_LimitsOfBothScenes_MustAgree(double? limitMs, double? otherLimitMs, bool isMet)
    {
        var criteria = Figure11.RangeCriteria([.. Sweep(Still, StoredMs, Refresh, Refresh, Refresh)], StoredMs, limitMs, otherLimitMs);

        Assert.That(criteria[0].IsMet, Is.EqualTo(isMet));
    }

    [Test]
    public void Figure11b_NoLimitFound_DoesNotHold()
    {
        var criteria = Figure11.RangeCriteria([.. Sweep(Between, StoredMs, Between, Between, Between)], StoredMs, null, null);

        Assert.That(Criterion.Judge(criteria), Is.EqualTo(Verdict.DoesNotHold));
    }
}
