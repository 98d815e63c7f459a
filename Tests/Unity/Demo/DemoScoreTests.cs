using Nowpose.Cli;
using Nowpose.Cli.Demo;
using Nowpose.Cli.Messages;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Session;
using Nowpose.Simulation;
using NUnit.Framework;

namespace Nowpose.Unity.Tests.Demo;

/// <summary>Tests the score of a run whose frames have known errors. The robot is a slider with one joint.</summary>
public class DemoScoreTests
{
    const double CycleSeconds = 4;
    static readonly TimeSpan Converged = TimeSpan.FromSeconds(5);

    static readonly RobotModel Slider = UrdfReader.Read(
        """
        <robot name="slider"><link name="base"/><link name="tool0"/>
        <joint name="s" type="prismatic"><parent link="base"/><child link="tool0"/><axis xyz="1 0 0"/></joint></robot>
        """, "slider");

    /// <summary>Errors of one frame. The true position is 0.</summary>
    readonly record struct Wrong(double HeldMm, double Mm, double LightMs = 0, double OffsetUs = 0);

    static readonly TimeSpan Stated = TimeSpan.FromMilliseconds(0.3);

    static DemoResult Score(double seconds, Func<double, Wrong> wrongAt, TimeSpan? converged = null, double skewErrorPpm = 0) =>
        new DemoScore(Run(seconds, wrongAt, converged ?? Converged, skewErrorPpm)).Result();

    static DemoRun Run(double seconds, Func<double, Wrong> wrongAt, TimeSpan converged, double skewErrorPpm = 0, double? nan = null)
    {
        var frames = new DemoFrames(1, 100);
        for (var i = 0; i < (int)(seconds * 60); i++)
        {
            var elapsed = TimeSpan.FromSeconds(i / 60.0);
            var wrong = wrongAt(elapsed.TotalSeconds);
            var light = new ControlTime(elapsed);
            var state = elapsed >= converged ? ClockState.Synchronised : ClockState.Converging;
            // These joint values deliberately do not match the errors: the score must use the position of the tool in the scene.
            frames.Add([nan ?? 7], [7], new DemoFrames.Row(
                elapsed, new HeadsetTime(elapsed), light, light + TimeSpan.FromMilliseconds(wrong.LightMs),
                new ClockModel(default, default, (Truth.SkewPpm + skewErrorPpm) * 1e-6, default, state, estimatedError: Stated), PoseState.Current, wrong.OffsetUs,
                new ToolPosition(wrong.Mm / 1000, 0, 0), new ToolPosition(wrong.HeldMm / 1000, 0, 0),
                elapsed.TotalSeconds < 3 ? 1000 : 2, elapsed.TotalSeconds < 3 ? 500 : 0));
        }
        var settings = new DemoSettings
        {
            Seconds = seconds, Robot = Slider, Network = NetworkProfile.Lan, Predictor = "quadratic", VisualisationMs = 40, VisualisationErrorMs = 3,
        };
        return new DemoRun(settings, new Truth(), frames, [.. Enumerable.Range(0, 101).Select(ms => TimeSpan.FromMilliseconds(ms))], Statistics());
    }

    [Test]
    public void Score_FramesBeforeTheClockConverged_AreExcluded()
    {
        var result = Score(10, s => s < 5 ? new Wrong(999, 999, 99, 9999) : new Wrong(10, 2, 1, 50));

        Assert.That(result.ToolErrorMm.HoldMax, Is.EqualTo(10).Within(1e-9));
        Assert.That(result.ToolErrorMm.Max, Is.EqualTo(2).Within(1e-9));
        Assert.That(result.LatencyMs.TotalErrorP95, Is.EqualTo(1).Within(1e-4));
        Assert.That(result.Clock.OffsetErrorUsMax, Is.EqualTo(50).Within(1e-9));
        Assert.That(result.Clock.ConvergedS, Is.EqualTo(5).Within(0.02));
        Assert.That(result.Frames, Is.EqualTo(600), "all events are written");
    }

    [Test]
    public void Score_ClockConvergesImmediately_ExcludesTheFirstThreeSecondsOfFrames()
    {
        var result = Score(10, s => s < 3 ? new Wrong(999, 999, 99, 700) : new Wrong(10, 2, 1, 50), TimeSpan.FromSeconds(1));

        Assert.That(result.ToolErrorMm.HoldMax, Is.EqualTo(10).Within(1e-9));
        Assert.That(result.LatencyMs.TotalErrorP95, Is.EqualTo(1).Within(1e-4));
        Assert.That(result.Clock.OffsetErrorUsMax, Is.EqualTo(700), "the maximum is over all times after convergence");
    }

    [Test]
    public void Score_Reduction_IsOneMinusTheRmsRatio()
    {
        // The errors are 30 mm (hold) and 3 mm in half of the scored frames, 40 mm and 4 mm in the other half.
        var result = Score(15, s => s < 10 ? new Wrong(30, 3) : new Wrong(40, 4));

        Assert.That(result.ToolErrorMm.HoldRms, Is.EqualTo(Math.Sqrt((900 + 1600) / 2.0)).Within(1e-6));
        Assert.That(result.ToolErrorMm.Rms, Is.EqualTo(Math.Sqrt((9 + 16) / 2.0)).Within(1e-6));
        Assert.That(result.ToolErrorMm.Reduction, Is.EqualTo(0.9).Within(1e-9));
    }

    [Test]
    public void Score_Percentiles_AreInterpolatedBetweenOrderStatistics()
    {
        // The magnitude of the errors increases evenly from 0 to 1 mm over the 600 scored frames; their signs differ.
        var result = Score(15, s => new Wrong(1, (s - 5) / 10, -(s - 5) / 10, -(s - 5) * 100));

        Assert.That(result.ToolErrorMm.P95, Is.EqualTo(0.95).Within(2e-3));
        Assert.That(result.LatencyMs.TotalErrorP95, Is.EqualTo(0.95).Within(2e-3), "the percentile is that of the magnitude");
        Assert.That(result.LightErrorMs.P50, Is.EqualTo(0.5).Within(2e-3));
        Assert.That(result.LightErrorMs.P95, Is.EqualTo(result.LatencyMs.TotalErrorP95));
        Assert.That(result.LightErrorMs.Max, Is.EqualTo(1).Within(2e-3));
        Assert.That(result.Clock.OffsetErrorUsP50, Is.EqualTo(500).Within(2));
        Assert.That(result.Clock.OffsetErrorUsP95, Is.EqualTo(950).Within(2));
        Assert.That(result.Clock.StatedErrorUsP50, Is.EqualTo(300));
        Assert.That(result.Clock.WithinStatedShare, Is.EqualTo(0.3).Within(2e-3));
        Assert.That(result.LatencyMs.AppP50, Is.EqualTo(50));
        Assert.That(result.LatencyMs.AppP95, Is.EqualTo(95));
        Assert.That(result.LatencyMs.Visu, Is.EqualTo(40), "the true L_visu is reported");
    }

    [Test]
    public void Score_SeveralCycles_SeparatesTheFirstCycleFromTheThirdAndLaterCycles()
    {
        // A cycle takes 4 s. Scoring starts at 5 s, after the first cycle. The error ratios of cycles 2 to 4 are 0.5, 0.2 and 0.1.
        var result = Score(16, s => new Wrong(10, s < 8 ? 5 : s < 12 ? 2 : 1));

        Assert.That(result.ToolErrorMm.ReductionFirstCycle, Is.Null);
        Assert.That(result.ToolErrorMm.ReductionRepeated, Is.EqualTo(1 - Math.Sqrt((4 + 1) / 2.0) / 10).Within(1e-4));

        result = Score(6, s => new Wrong(10, s < 4 ? 3 : 1), TimeSpan.FromSeconds(1));

        Assert.That(result.ToolErrorMm.ReductionFirstCycle, Is.EqualTo(0.7).Within(1e-9));
        Assert.That(result.ToolErrorMm.ReductionRepeated, Is.Null);
    }

    [Test]
    public void Score_SkewError_IsEstimateMinusTruth()
    {
        Assert.That(Score(10, _ => new Wrong(1, 1), skewErrorPpm: 7).Clock.SkewErrorPpm, Is.EqualTo(7).Within(0.05));
    }

    [Test]
    public void Score_FrameCost_ExcludesTheFirstThreeSeconds()
    {
        var result = Score(10, _ => new Wrong(1, 1));

        Assert.That(result.Frame.CpuUsP99, Is.EqualTo(2));
        Assert.That(result.Frame.AllocatedBytesPerFrame, Is.EqualTo(0));
    }

    [Test]
    public void Score_ClockNeverConverged_HasNoResults()
    {
        var result = Score(4, _ => new Wrong(1, 1));

        Assert.That(result.ToolErrorMm.Reduction, Is.Null);
        Assert.That(result.Clock.ConvergedS, Is.Null);
        Assert.That(JsonText.Of(result), Does.Contain("\"reduction\": null"));
    }

    [Test]
    public void Failure_RunFailed_NamesTheCause()
    {
        Assert.That(Run(10, _ => new Wrong(1, 1), Converged, nan: double.NaN).Failure(), Is.EqualTo(DemoMessages.JointNotFinite(0, 0)));
        Assert.That(Run(4, _ => new Wrong(1, 1), Converged).Failure(), Does.StartWith(DemoMessages.NoSample(0, "")));
    }

    [TestCase(true)]
    [TestCase(false)]
    public void Failure_PoseOfAnObjectIsNotFinite_NamesTheObject(bool isDisplayed)
    {
        var work = VirtualDemo.Settings(20, "wifi", 1).Motion.Work;
        var (good, bad) = (RigidTransform.Identity, RigidTransform.FromXyzRpy(0, double.NaN, 0, 0, 0, 0));
        var bodies = new DemoBodies(work);
        for (var body = 0; body < 2 * work.Names.Count; body++)
            bodies.Add(body <= work.Names.Count ? default : new DemoBodies.Shown(true, isDisplayed ? bad : good, isDisplayed ? good : bad, "world"));

        var run = Run(10, _ => new Wrong(1, 1), Converged) with { Bodies = bodies };

        var name = work.Names[1];
        Assert.That(run.Failure(), Is.EqualTo(isDisplayed ? DemoMessages.BodyNotFinite(1, name) : DemoMessages.GhostBodyNotFinite(1, name)));
    }

    static SessionStatistics Statistics()
    {
        var settings = new SessionSettings(new ConnectionSettings("127.0.0.1"), new VisualisationLatency(TimeSpan.FromMilliseconds(40)));
        using var session = new CompensationSession(settings, Slider, new StopwatchHeadsetClock());
        return session.Statistics(default);
    }

    sealed class Truth : IDemoTruth
    {
        public const double SkewPpm = -37;

        public ControlTime ControlAt(HeadsetTime t) => new(t.SinceEpoch - TimeSpan.FromTicks((long)(t.SinceEpoch.Ticks * SkewPpm * 1e-6)));

        public void JointsAt(ControlTime t, Span<double> positions) => positions.Clear();

        public double MotionSecondsAt(ControlTime t) => t.SinceEpoch.TotalSeconds;

        public int CycleAt(ControlTime t) => (int)(MotionSecondsAt(t) / CycleSeconds);
    }

    [TestCase(0.826, 0.013, "82.6 ± 1.3 %")]
    [TestCase(0.826, null, "82.6 % ± –")]
    [TestCase(null, null, "–")]
    public void ReductionText_UnknownNumber_IsADash(double? reduction, double? uncertainty, string text) =>
        Assert.That(new DemoResult.Hindcasts(reduction, uncertainty, null, null, null).ReductionText, Is.EqualTo(text));
}
