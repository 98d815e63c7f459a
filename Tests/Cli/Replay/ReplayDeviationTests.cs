using System.Text.Json;
using Nowpose.Cli.Replay;
using Nowpose.Headless.Tests.Cli;
using Nowpose.Headless.Tests.Cli.SessionFiles;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Replay;

/// <summary>Tests the standard deviations that predictors state in a replay.</summary>
public class ReplayDeviationTests
{
    string _folder;
    string _motion;
    string _session;

    [SetUp]
    public void WriteRecordings()
    {
        _folder = Directory.CreateTempSubdirectory("nowpose-replay-").FullName;
        _motion = new MotionFile(10, MotionFile.EvenTimes(20, 0.01m), t => Math.Sin(2 * t), t => 10 * Math.Sin(2 * t)).WriteTo(_folder);
        _session = Path.Combine(_folder, "session.jsonl");
    }

    [TearDown]
    public void DeleteFolder() => Directory.Delete(_folder, recursive: true);

    static async Task<JsonElement[]> Axes(params string[] arguments)
    {
        var run = await CliRun.OfAsync(["replay", "--json", .. arguments]);

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        using var json = JsonDocument.Parse(run.Output);
        return [.. json.RootElement.GetProperty("axes").EnumerateArray().Select(axis => axis.Clone())];
    }

    [Test]
    public async Task Replay_GpAsJson_StatesTheDeviationOfEachAxis()
    {
        var axes = await Axes(_motion, "--predictor", "gp");

        Assert.That(axes[0].EnumerateObject().Select(property => property.Name),
            Is.EqualTo(new[]
            {
                "name", "rms_hold", "rms", "p95", "max", "sd", "inside_1sd", "inside_2sd", "sd_rms", "sd_frames", "moving_frames", "moving_inside_1sd",
                "moving_inside_2sd",
            }));
        foreach (var axis in axes)
        {
            Assert.That(axis.GetProperty("sd").GetDouble() / axis.GetProperty("rms").GetDouble(), Is.InRange(0.7, 1.3));
            Assert.That(axis.GetProperty("inside_1sd").GetDouble(), Is.InRange(0.4, axis.GetProperty("inside_2sd").GetDouble()));
            Assert.That(axis.GetProperty("inside_2sd").GetDouble(), Is.InRange(0.9, 1));
            Assert.That(axis.GetProperty("sd_rms").GetDouble(), Is.GreaterThan(axis.GetProperty("sd").GetDouble()));
            Assert.That(axis.GetProperty("moving_frames").GetInt32(), Is.InRange(1, axis.GetProperty("sd_frames").GetInt32()));
        }
        Assert.That(axes[1].GetProperty("sd").GetDouble(), Is.EqualTo(10 * axes[0].GetProperty("sd").GetDouble()).Within(0.1).Percent);
    }

    [TestCase("adaptive")]
    [TestCase("quadratic")]
    public async Task Replay_PredictorWithoutDeviation_OmitsTheField(string predictor)
    {
        var axes = await Axes(_motion, "--predictor", predictor);

        Assert.That(axes[0].EnumerateObject().Select(property => property.Name), Is.EqualTo(new[] { "name", "rms_hold", "rms", "p95", "max" }));
    }

    [Test]
    public async Task Replay_Gp_PrintsColumnsOfTheDeviation()
    {
        var (gp, adaptive) = (await CliRun.OfAsync("replay", _motion, "--predictor", "gp"), await CliRun.OfAsync("replay", _motion));

        Assert.That(gp.Output, Does.Contain("mean SD").And.Contain("inside 2 SD"));
        Assert.That(adaptive.Output, Does.Not.Contain("SD"));
    }

    [Test]
    public async Task Replay_GpOnASession_StatesTheDeviation()
    {
        VirtualRecording.To(_session, predictor: "gp", seconds: 30);

        var axis = (await Axes(_session, "--predictor", "gp"))[0];

        Assert.That(axis.GetProperty("sd").GetDouble() / axis.GetProperty("rms").GetDouble(), Is.InRange(0.5, 1.5));
        Assert.That(axis.GetProperty("inside_2sd").GetDouble(), Is.InRange(0.85, 1));
    }

    [Test]
    public void Replay_SessionWithPlan_StatesDeviationsOfForecastsOnly()
    {
        VirtualRecording.To(_session, predictor: "gp", planLagMs: 0);
        var session = RecordedSession.Read(_session);
        ReplayResult.Deviation? Of(bool followPlan) =>
            new SessionReplay(_session, session, new SessionTruth(session), new ReplaySettings { Predictor = "gp", FollowPlan = followPlan }).Run()
                .Axes[0].Deviation;

        Assert.That(Of(followPlan: false).HasValue, Is.True);
        Assert.That(Of(followPlan: true), Is.EqualTo(null));
    }

    [Test]
    public void Summary_DeviationUnknownInSomeFrames_IgnoresThem()
    {
        var errors = new AxisError();
        foreach (var (error, deviation) in new[] { (-0.5, 1.0), (1.5, 1), (2, 1), (-7, 2), (9, double.NaN) }) errors.Add(0, error, deviation);

        Assert.That(errors.Summary("a").Deviation, Is.EqualTo(new ReplayResult.Deviation(1.25, Math.Sqrt(7 / 4.0), new(4, 0.25, 0.75), default)));
    }

    [Test]
    public void Summary_FramesInWhichHoldHasAnError_AreCountedAsMoving()
    {
        var errors = new AxisError();
        foreach (var (held, error) in new[] { (0.002, 1.5), (-0.002, -0.5), (0.0009, 0), (0, 0) }) errors.Add(held, error, 1);

        Assert.That(errors.Summary("a").Deviation, Is.EqualTo(new ReplayResult.Deviation(1, 1, new(4, 0.75, 1), new(2, 0.5, 1))));
    }
}
