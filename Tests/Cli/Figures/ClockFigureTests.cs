using Nowpose.Cli.Figures;
using Nowpose.Cli.Figures.Clocks;
using Nowpose.Cli.Figures.Field;
using Nowpose.Cli.Figures.Model;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Figures;

public class ClockFigureTests
{
    static readonly FigureSettings Settings = new() { Phases = 2, ClockRuns = 4, ClockSeconds = 60, Seed = 11 };

    [Test]
    public void Exchanges_Wifi_LieWithinTheirRoundTripsOfTheTruth()
    {
        var log = new SimulatedExchanges(Settings.Seed, 60);

        Assert.That(log.All, Has.Count.InRange(280, 300), "one every 200 ms, now and then a late one");
        foreach (var each in log.All)
            Assert.That((each.Offset - log.TrueOffset(each.T4)).Duration(), Is.LessThanOrEqualTo(each.RoundTripTime / 2 + TimeSpan.FromTicks(100)));
    }

    [Test]
    public void Exchanges_Skew_IsTheSlopeOfTheOffset()
    {
        var log = new SimulatedExchanges(Settings.Seed, 60);

        var slope = (log.TrueOffset(HeadsetTime.FromSeconds(31)) - log.TrueOffset(HeadsetTime.FromSeconds(29))).TotalMicroseconds / 2;

        Assert.That(slope, Is.EqualTo(log.SkewPpmAt(30)).Within(0.1), $"seed {Settings.Seed}");
    }

    [Test]
    public void Figures4And8_PaperEstimator_StaysBelowAMillisecond()
    {
        var study = new ClockAndFieldStudy(Settings);
        Parallel.ForEach(study.Work, work => work());

        var figures = study.Figures().ToDictionary(f => f.Number);

        Assert.That(figures["8"].Criteria[0].IsMet, $"{figures["8"].Criteria[0].Measured}, seed {Settings.Seed}");
        var (paper, ours) = (P95(figures["8"], "ransac"), P95(figures["8"], "default"));
        Assert.That(ours, Is.LessThan(0.5 * paper), $"the default beside the paper's on the same exchanges, seed {Settings.Seed}");
        Assert.That(figures["8"].Table.Rows, Has.Count.EqualTo(300), "an exchange each");
        Assert.That(figures["4"].Verdict, Is.EqualTo(Verdict.Holds), figures["4"].Criteria[0].Measured);
    }

    static double P95(Figure figure, string estimator) => double.Parse(
        figure.Summary.Rows.Single(row => row[0] == estimator)[2], System.Globalization.CultureInfo.InvariantCulture);

    [TestCase(312, 88, 7, 280, 12_300, "holds")]
    [TestCase(1312, 88, 7, 280, 12_300, "holds partly")]
    [TestCase(1312, 88, 50, 280, 400, "does not hold")]
    public void Figure8_Numbers_TurnTheVerdict(double greatestUs, double early, double late, double shortUs, double longUs, string verdict)
    {
        var criteria = Figure08.Criteria(new ClockErrors(50, 200, greatestUs, early, late), new RoundTrips(shortUs, longUs));

        Assert.That(Criterion.Judge(criteria).Words(), Is.EqualTo(verdict));
    }

    [TestCase(30.2, "holds")]
    [TestCase(31, "holds partly")]
    [TestCase(3, "does not hold")]
    public void Figure4_ErrorOfHold_TurnsTheVerdict(double freshMm, string verdict)
    {
        Assert.That(Criterion.Judge(Figure04.Criteria([new FieldPoint(1000, 30, freshMm, 55, [])])).Words(), Is.EqualTo(verdict));
    }
}
