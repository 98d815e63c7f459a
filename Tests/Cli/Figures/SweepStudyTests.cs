using Nowpose.Cli.Figures;
using Nowpose.Cli.Figures.Model;
using Nowpose.Cli.Figures.Sweeps;
using Nowpose.Cli.Messages;
using Nowpose.Cli.Studies;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Figures;

/// <summary>Compares the data of the figures for the paper's polynomials with the results of an independent simulation in Python.</summary>
public class SweepStudyTests
{
    const double Tolerance = 0.02;

    static readonly FigureSettings Settings = new() { Phases = 16, ClockRuns = 1, RandomSeconds = 3, Ours = [], Seed = 23 };
    static readonly Dictionary<string, Figure> Figures = [];

    [OneTimeSetUp]
    public static void Compute()
    {
        var studies = SweepStudy.All(Settings).ToArray();
        Parallel.ForEach(studies.SelectMany(s => s.Work), work => work());
        foreach (var figure in studies.SelectMany(s => s.Figures())) Figures[figure.Number] = figure;
    }

    [TestCase("13a", 10, .247, .101, .067)]
    [TestCase("13a", 20, .280, .136, .105)]
    [TestCase("13a", 30, .311, .172, .155)]
    [TestCase("13a", 50, .374, .255, .271)]
    [TestCase("13a", 70, .436, .345, .419)]
    [TestCase("13a", 100, .521, .477, .646)]
    [TestCase("13b", 0, .190, .084, .065)]
    [TestCase("13b", 50, .280, .157, .144)]
    [TestCase("13b", 75, .333, .210, .209)]
    [TestCase("13b", 150, .465, .368, .447)]
    [TestCase("13b", 250, .632, .621, .938)]
    [TestCase("13c", -50, .488, .392, .399)]
    [TestCase("13c", -20, .375, .214, .224)]
    [TestCase("13c", 20, .437, .410, .440)]
    [TestCase("13c", 50, .604, .709, .784)]
    [TestCase("13d", 2, .379, .290, .487)]
    [TestCase("13d", 5, .391, .431, 1.07)]
    public void Figure13_Ratios_MatchAnIndependentSimulation(string number, double at, double linear, double quadratic, double cubic)
    {
        Assert.That(Ratio(number, at, "linear"), Is.EqualTo(linear).Within(Tolerance), Seed);
        Assert.That(Ratio(number, at, "quadratic"), Is.EqualTo(quadratic).Within(Tolerance), Seed);
        Assert.That(Ratio(number, at, "cubic"), Is.EqualTo(cubic).Within(Tolerance * Math.Max(1, 2 * cubic)), Seed);
    }

    [Test]
    public void Figure13_SofterLimits_ReduceTheErrorOfTheCubicMost()
    {
        var soft = SweepStudy.All(Settings with { Limits = new(1000, 2500, 12_500), Phases = 4 }).First();
        Parallel.ForEach(soft.Work, work => work());

        var figure = soft.Figures().First();

        Assert.That(Ratio(figure, 50, "cubic"), Is.LessThan(Ratio(figure, 50, "quadratic")), Seed);
        Assert.That(Ratio("13a", 50, "cubic"), Is.GreaterThan(Ratio("13a", 50, "quadratic")), Seed);
        Assert.That(figure.Conditions, Is.EqualTo(SweepFigureTexts.Conditions(figure.Table.Columns[0].Label, 1000, 2500, 12_500)));
    }

    [TestCase(1000, 5000, 50_000, 2.4)]
    [TestCase(500, 5000, 50_000, 3.2)]
    public void SwingPeriod_Limits_IsTwoMovesAndTwoDwells(double velocity, double acceleration, double jerk, double expected) =>
        Assert.That(Motions.SwingPeriod(new MotionLimits(velocity, acceleration, jerk).Move()), Is.EqualTo(expected).Within(1e-9));

    [TestCase("14a", 10, .113, .126)]
    [TestCase("14a", 50, .328, .404)]
    [TestCase("14a", 100, .604, .743)]
    [TestCase("14b", 0, .145, .225)]
    [TestCase("14b", 250, .702, .779)]
    [TestCase("14c", -50, .399, .413)]
    [TestCase("14c", 20, .487, .567)]
    [TestCase("14d", 5, .378, .424)]
    [TestCase("14d", 10, .499, .475)]
    public void Figure14_Ratios_MatchAnIndependentSimulation(string number, double at, double h3, double h4)
    {
        Assert.That(Ratio(number, at, "quadratic-h3"), Is.EqualTo(h3).Within(Tolerance), Seed);
        Assert.That(Ratio(number, at, "quadratic-h4"), Is.EqualTo(h4).Within(Tolerance), Seed);
    }

    [TestCase("13a", Verdict.HoldsPartly)]
    [TestCase("13b", Verdict.HoldsPartly)]
    [TestCase("13c", Verdict.HoldsPartly)]
    [TestCase("13d", Verdict.Holds)]
    [TestCase("14a", Verdict.Holds)]
    [TestCase("14b", Verdict.Holds)]
    [TestCase("14c", Verdict.Holds)]
    [TestCase("14d", Verdict.Holds)]
    public void Verdict_EachSweepFigure_EqualsTheRecordedVerdict(string number, object verdict)
    {
        Assert.That(Figures[number].Verdict, Is.EqualTo(verdict), Seed);
    }

    [Test]
    public void Figure14d_Crossovers_AreAtFourAndEightMilliseconds()
    {
        var data = new SweepData(
            [.. Column("14d", "stamp error (ms)")],
            new[] { "hold", "quadratic", "quadratic-h3", "quadratic-h4" }.ToDictionary(p => p, p => Column("14d", $"{p} RMS (mm)")));

        Assert.That(data.Crossover("quadratic-h3", "quadratic"), Is.InRange(3.0, 5.0), Seed);
        Assert.That(data.Crossover("quadratic-h4", "quadratic-h3"), Is.InRange(7.0, 10.0), Seed);
    }

    static string Seed => $"seed {Settings.Seed}";

    static double Ratio(string number, double at, string predictor) => Ratio(Figures[number], at, predictor);

    static double Ratio(Figure figure, double at, string predictor) =>
        Column(figure, $"{predictor} ratio")[Array.IndexOf(Column(figure, figure.Table.Columns[0].Label), at)];

    static double[] Column(string number, string label) => Column(Figures[number], label);

    static double[] Column(Figure figure, string label)
    {
        var table = figure.Table;
        var column = table.Columns.Select(c => c.Label).ToList().IndexOf(label);
        return [.. table.Rows.Select(row => row[column].Value)];
    }
}
