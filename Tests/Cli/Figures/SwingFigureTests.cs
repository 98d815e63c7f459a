using System.Xml.Linq;
using Nowpose.Cli.Figures;
using Nowpose.Cli.Figures.Model;
using Nowpose.Cli.Figures.Swing;
using Nowpose.Cli.Messages;
using Nowpose.Latency;
using Nowpose.Latency.Profile;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Figures;

public class SwingFigureTests
{
    static readonly FigureSettings Settings = new() { Phases = 8, ClockRuns = 1, Seed = 31, Profile = SwingProfile.Of(40) };
    static SwingRuns s_runs;
    static SwingSet s_set;

    [OneTimeSetUp]
    public static void Compute()
    {
        s_runs = new SwingRuns(Settings, default);
        Parallel.ForEach(s_runs.Work, work => work());
        s_set = s_runs.Set;
    }

    [Test]
    public void Swing_Speed_EqualsTheDerivativeOfTheDistance()
    {
        var swing = s_runs.Swing;
        foreach (var t in new[] { 0.05, 0.2, 0.6, 1.1, 1.35 })
        {
            var slope = (swing.WayMm(swing.Motion.At(swing.Start + t + 1e-4)) - swing.WayMm(swing.Motion.At(swing.Start + t - 1e-4))) / 2e-4;
            Assert.That(swing.ToolSpeedAt(t), Is.EqualTo(slope).Within(0.1), $"at {t} s");
        }
    }

    [Test]
    public void Swing_Moves_AreContinuous([Values] bool isCold)
    {
        var motion = new YoubotSwing(isCold).Motion;
        for (var t = 0.0; t < motion.Seconds; t += 0.001)
            Assert.That(Math.Abs(motion.At(t + 0.001) - motion.At(t)), Is.LessThan(0.0015), $"at {t} s");
    }

    [Test]
    public void Swing_Gap_EqualsTheDistanceBetweenTheTools()
    {
        var swing = s_runs.Swing;
        var tool = swing.Robot.IndexOfLink(swing.Robot.ToolLink.Name);
        var (a, b) = (swing.LinksAt(2.5)[tool], swing.LinksAt(2.9)[tool]);

        var distance = 1000 * Math.Sqrt(Math.Pow(a.X - b.X, 2) + Math.Pow(a.Y - b.Y, 2) + Math.Pow(a.Z - b.Z, 2));

        Assert.That(swing.GapMm(2.5, 2.9), Is.EqualTo(distance).Within(1e-6));
        Assert.That(distance, Is.GreaterThan(150));
    }

    [Test]
    public void Swing_AngleOfTheTool_EqualsTheAngleOfTheFirstAxis()
    {
        var swing = s_runs.Swing;
        foreach (var angle in new[] { YoubotSwing.FirstAngle, 2.5, 3.3, 3.7 })
        {
            var tool = swing.LinksAt(angle)[swing.Robot.IndexOfLink(swing.Robot.ToolLink.Name)];
            Assert.That(swing.AngleOf(tool.X, tool.Y), Is.EqualTo(angle).Within(1e-9));
        }
    }

    [Test]
    public void SwingMotion_Joints_RepeatTheSwing()
    {
        var swing = new YoubotSwing(isCold: true);
        var motion = new SwingMotion(swing);
        var (first, third) = (new double[motion.JointNames.Count], new double[motion.JointNames.Count]);

        motion.At(swing.Start + 0.7, first);
        motion.At(swing.Start + 0.7 + 2 * motion.CycleSeconds, third);

        Assert.That(third, Is.EqualTo(first).Within(1e-9));
        Assert.That(first[swing.Robot.IndexOfMovingJoint("arm_joint_1")], Is.EqualTo(swing.Motion.At(swing.Start + 0.7)).Within(1e-12));
    }

    [Test]
    public void Runs_Quadratic_ReducesTheErrorByAbout80Percent()
    {
        var quadratic = s_set.Standard[0];

        var left = quadratic.RmsMm(Figure18.IsWithin) / quadratic.HoldRmsMm(Figure18.IsWithin);

        Assert.That(1 - left, Is.InRange(0.75, 0.88), $"seed {Settings.Seed}");
    }

    [Test]
    public void Runs_ConsecutiveRuns_DifferInPhase()
    {
        foreach (var frames in s_set.All)
        {
            Assert.That(frames.Phases, Has.Count.EqualTo(Settings.Phases), frames.Scenario.Name);
            var first = frames.Phases.Select(phase => phase.First(frame => frame.Time >= 0).Time).ToList();
            Assert.That(first.Distinct().Count(), Is.EqualTo(Settings.Phases));
            Assert.That(first, Is.All.LessThan(0.017));
        }
    }

    [Test]
    public void Runs_ProfileOfAnotherDisplay_ClaimDoesNotHold()
    {
        var runs = new SwingRuns(Settings with { Phases = 2, Profile = SwingProfile.Of(75) }, default);
        foreach (var work in runs.Work) work();
        var figure = Figure18.Of(runs.Set);

        Assert.That(figure.Verdict, Is.Not.EqualTo(Verdict.Holds), string.Join("; ", figure.Criteria.Select(c => c.Measured)));
        Assert.That(figure.Criteria[0].IsMet, Is.False, "35 ms too much");
    }

    [Test]
    public void Run_CancelledWhileTheDisplayIsMeasured_IsCancelled()
    {
        using var cancel = new CancellationTokenSource();
        var runs = new SwingRuns(Settings with { Phases = 1, Profile = null, PicturesPerLoad = 2 }, cancel.Token);

        cancel.Cancel();

        Assert.Throws<OperationCanceledException>(() => runs.Work[0]());
    }

    [Test]
    public void Figures16To18_MeasuredRuns_ClaimsHold()
    {
        foreach (var figure in new[] { Figure16.Of(s_set), Figure17.Of(s_set), Figure18.Of(s_set) })
            Assert.That(figure.Verdict, Is.EqualTo(Verdict.Holds), $"{figure.Number}: {string.Join("; ", figure.Criteria.Select(c => c.Measured))}");
    }

    // With the first run alone, the values would be different.
    [Test]
    public void Runs_GapRatiosAndLatencies_IncludeAllRuns()
    {
        var all = s_set.Standard[0];
        var alone = all.Phases.Select(phase => all with { Phases = [phase] }).ToList();

        for (var m = 0; m < 3; m++)
            Assert.That(all.GapRatios[m], Is.InRange(alone.Min(run => run.GapRatios[m]), alone.Max(run => run.GapRatios[m])).And.Not.EqualTo(alone[0].GapRatios[m]));
        Assert.That(all.LatencyMs, Is.InRange(alone.Min(run => run.LatencyMs), alone.Max(run => run.LatencyMs)).And.Not.EqualTo(alone[0].LatencyMs));
        Assert.That(all.HoldLatencyMs, Is.InRange(100, 200), "acquisition 55 to 105 ms, network, L_visu 40 ms and half a sampling interval");
    }

    [Test]
    public void Figure17_Drawings_ShowThreeInstantsPerPredictor()
    {
        var figure = Figure17.Of(s_set);

        Assert.That(figure.Drawings, Has.Count.EqualTo(3 * SwingRuns.Predicted.Count));
        foreach (var drawing in figure.Drawings)
        {
            var svg = XDocument.Parse(drawing.Svg).Root;
            Assert.That(svg.Descendants().Count(e => e.Name.LocalName == "line"), Is.GreaterThan(20), "the drawing has three arms");
            Assert.That(drawing.Svg, Does.Contain("uncompensated: ").And.Contain("var(--truth)").And.Contain("var(--hold)"));
        }
    }

    [Test]
    public void Figure17_DrawnGaps_MatchTheTable()
    {
        var figure = Figure17.Of(s_set);

        for (var i = 0; i < 3; i++)
            Assert.That(figure.Drawings[i].Svg, Does.Contain($"uncompensated: {Numbers.Mm(figure.Table.Rows[i][2].Value)} off")
                .And.Contain($"compensated: {Numbers.Mm(figure.Table.Rows[i][3].Value)} off"));
    }

    [TestCase(0.2, 126, 10, Verdict.Holds)]
    [TestCase(0.3, 126, 10, Verdict.HoldsPartly)]
    [TestCase(0.3, 126, 60, Verdict.DoesNotHold)]
    public void Figure18_MeasuredValues_DecideTheVerdict(double ratio, double heldMs, double predictedMs, object verdict)
    {
        Assert.That(Criterion.Judge(Figure18.Criteria(ratio, heldMs, predictedMs)), Is.EqualTo(verdict));
    }

    [TestCase(0.2, 2, 9, Verdict.Holds)]
    [TestCase(0.2, 9, 9, Verdict.HoldsPartly)]
    [TestCase(0.6, 9, 9, Verdict.DoesNotHold)]
    public void Figure16_MeasuredValues_DecideTheVerdict(double ratio, double steady, double curved, object verdict)
    {
        Assert.That(Criterion.Judge(Figure16.Criteria(ratio, steady, curved)), Is.EqualTo(verdict));
    }

    [TestCase(new[] { 0.45, 0.2, 0.3 }, Verdict.Holds)]
    [TestCase(new[] { 0.45, 0.55, 0.3 }, Verdict.HoldsPartly)]
    [TestCase(new[] { 0.55, 0.6, 0.7 }, Verdict.DoesNotHold)]
    public void Figure17_GapRatios_DecideTheVerdict(double[] ratios, object verdict)
    {
        var criteria = ratios.Select((ratio, i) => Figure17.Criterion("ABC"[i].ToString(), ratio)).ToList();

        Assert.That(Criterion.Judge(criteria), Is.EqualTo(verdict));
    }
}
