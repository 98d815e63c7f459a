using Nowpose.Cli.Calibrate;
using Nowpose.Cli.Calibrate.Range;
using Nowpose.Cli.Figures;
using Nowpose.Cli.Figures.Display;
using Nowpose.Cli.Figures.Model;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Figures;

/// <summary>Figs 10 and 11: what the simulated display shows on every seed, and made-up numbers that change the verdicts.</summary>
public class DisplayFigureTests
{
    const double StoredMs = 40, LimitMs = 15.2;

    /// <summary>Half widths of an even scatter, ms: a camera's, a refresh interval's, and one between that is neither.</summary>
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

    // Whether L_visu also scatters enough between the limit and a refresh interval depends on the seed.
    [TestCase("10", new[] { 0, 1, 2 })]
    [TestCase("11a", new[] { 0, 2 })]
    [TestCase("11b", new[] { 0, 1, 3 })]
    public void Criteria_SimulatedDisplay_AreMetOnEachSeed(string number, int[] indices)
    {
        foreach (var (seed, figures) in Seeds)
        {
            var figure = figures.Single(each => each.Number == number);
            foreach (var criterion in indices.Select(i => figure.Criteria[i]))
                Assert.That(criterion.IsMet, Is.True, $"seed {seed}: {criterion.Measured}");
        }
    }

    // From the data that the figure shows.
    [Test]
    public void Figure10_EachSeed_DeviatesThreeTimesAsMuchAtTheHighLoad()
    {
        foreach (var (seed, figures) in Seeds)
        {
            var table = figures.Single(each => each.Number == "10").Table;
            double Deviation(int column) => Spread.Of(table.Rows.Where(row => row[column].HasValue).Select(row => row[column].Value)).Deviation;

            Assert.That(Deviation(4), Is.GreaterThanOrEqualTo(3 * Deviation(2)), $"seed {seed}");
        }
    }

    // A picture is taken at any time within the 4 ms in which its frame is lit, and the headset's code has whole milliseconds.
    [Test]
    public void Figure10_NormalLoad_ScattersByTheLightAndTheCode()
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

    [Test]
    public void Figure11_EachSeed_DeviatesThreeTimesAsMuchAtEachLoadBeyondARefresh()
    {
        foreach (var (seed, figures) in Seeds)
        {
            var loads = figures.Single(each => each.Number == "11b").Table.Rows.GroupBy(row => row[0].Value).OrderBy(load => load.Key).ToArray();
            var inside = Spread.Of(loads.TakeWhile(load => load.Key < 1.15).SelectMany(load => load).Select(row => row[2].Value));

            foreach (var load in loads.Where(load => load.Key > 1.45))
            {
                var beyond = Spread.Of(load.Select(row => row[2].Value));
                Assert.That(beyond.Deviation, Is.GreaterThanOrEqualTo(3 * inside.Deviation), $"seed {seed}, {load.Key} million");
            }
        }
    }

    // Evenly scattered around the middle, and in no order.
    static IEnumerable<MeasuredPicture> Pictures(double millions, double renderMs, double visuMs, double halfWidthMs) => Enumerable.Range(0, 100)
        .Select(i => new MeasuredPicture(null, (int)(1e6 * millions), renderMs, visuMs + halfWidthMs * (i * 37 % 100 - 49.5) / 50));

    [TestCase(Still, Refresh, "holds")]
    [TestCase(Still, Between, "holds partly")]
    [TestCase(Between, Refresh, "holds partly")]
    [TestCase(Between, Between, "does not hold")]
    [TestCase(Between, 0, "does not hold")]
    public void Figure10_Scatter_ChangesTheVerdict(double normalMs, double highMs, string verdict)
    {
        var criteria = Figure10.Criteria([.. Pictures(0.3, 6.5, 40, normalMs)], [.. Pictures(1.5, 17, 65, highMs)]);

        Assert.That(Criterion.Judge(criteria).Words(), Is.EqualTo(verdict));
    }

    // The plateau of a display that starts every frame at a refresh: later, and as constant.
    [Test]
    public void Figure10_SecondPlateau_DoesNotScatter()
    {
        var criteria = Figure10.Criteria([.. Pictures(0.3, 6.5, 40, Still)], [.. Pictures(1.5, 17, 73.3, Still)]);

        Assert.That(criteria.Select(c => c.IsMet), Is.EqualTo(new[] { true, false, false }));
    }

    [Test]
    public void Figure10_OneSlowFrame_DoesNotScatter()
    {
        var high = Pictures(1.5, 17, 56.7, Still).ToArray();
        high[40] = high[40] with { VisuMs = 200 };

        var criteria = Figure10.Criteria([.. Pictures(0.3, 6.5, 40, Still)], high);

        Assert.That(criteria.Select(c => c.IsMet), Is.EqualTo(new[] { true, false, false }));
    }

    [Test]
    public void Figure10_OneSlowFrameAtTheNormalLoad_IsStillConstant()
    {
        var normal = Pictures(0.3, 6.5, 40, Still).ToArray();
        normal[40] = normal[40] with { VisuMs = 200 };

        Assert.That(Criterion.Judge(Figure10.Criteria(normal, [.. Pictures(1.5, 17, 65, Refresh)])), Is.EqualTo(Verdict.Holds));
    }

    // Two loads inside, one between the limit and a refresh, and two beyond a refresh.
    static IEnumerable<MeasuredPicture> Sweep(double insideMs, double secondMs, double beyondMs, double lastMs, double lateMs = Refresh) =>
    [
        .. Pictures(0, 4, StoredMs, insideMs), .. Pictures(1, 12.5, secondMs, insideMs), .. Pictures(1.4, 15.9, 56.7, lateMs),
        .. Pictures(1.6, 17.6, 66, beyondMs), .. Pictures(2, 21, 72, lastMs),
    ];

    [TestCase(Still, 40.5, Refresh, Refresh, "holds")]
    [TestCase(Still, 42, Refresh, Refresh, "holds partly", TestName = "Figure11a_MedianMoves_HoldsPartly")]
    [TestCase(Still, 40.5, Refresh, Still, "holds partly", TestName = "Figure11a_OneLoadBeyondIsConstant_HoldsPartly")]
    [TestCase(Between, 42, Refresh, Still, "does not hold")]
    [TestCase(Still, 42, Still, Still, "does not hold")]
    public void Figure11a_Numbers_ChangeTheVerdict(double insideMs, double secondMs, double beyondMs, double lastMs, string verdict)
    {
        var criteria = Figure11.LoadCriteria(Sweep(insideMs, secondMs, beyondMs, lastMs), StoredMs);

        Assert.That(Criterion.Judge(criteria).Words(), Is.EqualTo(verdict));
    }

    // The paper calls all loads beyond the limit scattered, also those whose render time is less than a refresh interval.
    [TestCase(Refresh, true)]
    [TestCase(Still, false)]
    public void Figure11_LoadBetweenLimitAndRefresh_IsJudgedAndNamed(double lateMs, bool isMet)
    {
        var sweep = Sweep(Still, 40.5, Refresh, Refresh, lateMs).ToList();

        var (loads, steps) = (Figure11.LoadCriteria(sweep, StoredMs), Figure11.RangeCriteria(sweep, StoredMs, LimitMs, LimitMs));

        foreach (var criterion in loads.Skip(1).Concat(steps.Skip(2))) Assert.That(criterion.IsMet, Is.EqualTo(isMet), criterion.Measured);
        foreach (var criterion in loads.Skip(1)) Assert.That(criterion.Measured.Contains("less at 1.4 million (", StringComparison.Ordinal), Is.Not.EqualTo(isMet));
        foreach (var criterion in steps.Skip(2)) Assert.That(criterion.Measured.Contains("less at 15.2 ms", StringComparison.Ordinal), Is.Not.EqualTo(isMet));
    }

    [TestCase(4, true)]
    [TestCase(20, false)]
    public void Figure11a_LoadsOnOneSideOnly_MeetNoCriterionOfTheOther(double renderMs, bool isConstant)
    {
        var criteria = Figure11.LoadCriteria([.. Pictures(0, renderMs, StoredMs, Still), .. Pictures(1, renderMs, StoredMs, Still)], StoredMs);

        Assert.That(criteria.Select(c => c.IsMet), Is.EqualTo(new[] { isConstant, false, false }));
    }

    [TestCase(Still, Refresh, 15.0, "holds")]
    [TestCase(Still, Refresh, 13.0, "holds partly", TestName = "Figure11b_LimitDependsOnTheScene_HoldsPartly")]
    [TestCase(Between, Refresh, 15.0, "holds partly", TestName = "Figure11b_OneStoredLatencyIsNotSufficient_HoldsPartly")]
    [TestCase(Still, Still, 15.0, "holds partly", TestName = "Figure11b_LatencyIsConstantOutside_HoldsPartly")]
    [TestCase(Between, Still, 13.0, "does not hold")]
    public void Figure11b_Numbers_ChangeTheVerdict(double insideMs, double beyondMs, double otherLimitMs, string verdict)
    {
        var criteria = Figure11.RangeCriteria([.. Sweep(insideMs, StoredMs, beyondMs, beyondMs, beyondMs)], StoredMs, LimitMs, otherLimitMs);

        Assert.That(Criterion.Judge(criteria).Words(), Is.EqualTo(verdict));
    }

    // Two plateaus 6 ms apart: all pictures outside together would scatter, but those of one render time do not.
    [Test]
    public void Figure11b_PlateausOutside_DoNotScatter()
    {
        var criteria = Figure11.RangeCriteria([.. Sweep(Still, StoredMs, Still, Still, Still)], StoredMs, LimitMs, LimitMs);

        Assert.That(criteria.Select(c => c.IsMet), Is.EqualTo(new[] { true, true, false, false }));
    }

    [TestCase(15.2, 14.0, true)]
    [TestCase(15.2, 13.9, false)]
    [TestCase(15.2, null, false)]
    [TestCase(null, null, false)]
    public void Figure11b_Limits_MustBeFoundInBothScenesAndAgree(double? limitMs, double? otherLimitMs, bool isMet)
    {
        var criteria = Figure11.RangeCriteria([.. Sweep(Still, StoredMs, Refresh, Refresh)], StoredMs, limitMs, otherLimitMs);

        Assert.That(criteria[0].IsMet, Is.EqualTo(isMet));
    }

    [Test]
    public void Figure11b_NoLimitFound_DoesNotHold()
    {
        var criteria = Figure11.RangeCriteria([.. Sweep(Between, StoredMs, Between, Between)], StoredMs, null, null);

        Assert.That(Criterion.Judge(criteria), Is.EqualTo(Verdict.DoesNotHold));
    }
}
