using System.Text.Json;
using Nowpose.Cli;
using Nowpose.Cli.Messages;
using Nowpose.Cli.Replay;
using Nowpose.Cli.SessionFiles;
using Nowpose.Prediction;
using Nowpose.Session;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.SessionFiles;

public class SessionReplayTests : SessionReplayFixture
{
    static readonly string[] Names = [.. Predictors.Names];

    // Returns the differences between the replayed and the displayed position, for each joint in each frame.
    List<double> Differences(string predictor, bool followPlan = true, List<PredictionKind> seen = null)
    {
        var session = RecordedSession.Read(_path);
        using var file = new SessionFileReader(_path);
        var displayed = file.Lines().OfType<FrameLine>().Select(frame => frame.Joints).ToList();
        var differences = new List<double>();
        var settings = new ReplaySettings { Predictor = predictor, FollowPlan = followPlan };
        var replay = new SessionReplay(_path, session, new SessionTruth(session), settings)
        {
            Predicted = (frame, positions, kinds) =>
            {
                seen?.AddRange(kinds);
                for (var joint = 0; joint < positions.Length; joint++)
                    if (kinds[joint] != PredictionKind.None) differences.Add(Math.Abs(positions[joint] - displayed[frame.First][joint]));
            }
        };
        replay.Run();
        return differences;
    }

    [TestCaseSource(nameof(Names))]
    public void Replay_SamePredictor_EqualsTheDisplayedPositions(string predictor)
    {
        // Samples overtake each other, some are lost, and the control clock steps.
        VirtualRecording.To(_path, predictor: predictor, jitterMs: 120, loss: 0.05, stepAfter: 12, blendMs: 14);

        var differences = Differences(predictor);

        Assert.That(differences, Has.Count.GreaterThan(5000));
        Assert.That(differences.Max(), Is.EqualTo(0).Within(1e-12));
    }

    // The clock step ends the plan. The next plan arrives within a quarter of a second.
    [TestCase("adaptive", 0)]
    [TestCase("quadratic", 60)]
    public void Replay_SessionFollowedAPlan_EqualsTheDisplayedPositions(string predictor, double lagMs)
    {
        VirtualRecording.To(_path, predictor: predictor, jitterMs: 20, loss: 0.05, stepAfter: 12, blendMs: 14, planLagMs: lagMs, planUntil: 15);
        var kinds = new List<PredictionKind>();

        var differences = Differences(predictor, seen: kinds);

        Assert.That(kinds.Count(kind => kind == PredictionKind.Planned), Is.GreaterThan(1000));
        Assert.That(kinds.Count(kind => kind == PredictionKind.Predicted), Is.GreaterThan(1000), "after the last plan");
        Assert.That(differences.Max(), Is.EqualTo(0).Within(1e-12));
        Assert.That(Differences(predictor, followPlan: false).Max(), Is.GreaterThan(1e-3), "the plan changes the displayed positions");
    }

    [TestCase("hold", true)]
    [TestCase("quadratic", false)]
    public void Replay_SessionIgnoredThePlan_DoesNotFollowThePlan(string predictor, bool followPlan)
    {
        VirtualRecording.To(_path, planLagMs: 0, prediction: new PredictionSettings(predictor, followPlan: followPlan));
        var kinds = new List<PredictionKind>();

        var differences = Differences(predictor, seen: kinds);

        Assert.That(File.ReadLines(_path).Count(line => line.StartsWith("{\"kind\":\"plan\"", StringComparison.Ordinal)), Is.GreaterThan(50));
        Assert.That(kinds, Has.None.EqualTo(PredictionKind.Planned));
        Assert.That(differences.Max(), Is.EqualTo(0).Within(1e-12));
    }

    [Test]
    public void Replay_LimitsOfRobotAndSettings_EqualsTheDisplayedPositions()
    {
        var prediction = new PredictionSettings("adaptive", speedShare: 0.2, accelerationLimit: 2.1, jerkLimit: 17);
        VirtualRecording.To(_path, seconds: 60, jitterMs: 20, loss: 0.02, stepAfter: 12, prediction: prediction);

        var differences = Differences("adaptive");

        // No profile fits the recorded motion, so the jerk has no effect on it.
        Assert.That(RecordedSession.Read(_path).Header.Prediction.JerkLimit, Is.EqualTo(17));
        Assert.That(RecordedSession.Read(_path).Header.Joints.Select(joint => joint.Limits.Velocity), Has.Some.LessThan(100));
        Assert.That(differences.Max(), Is.EqualTo(0).Within(1e-12));
        foreach (var limit in new[] { "\"velocity\":", "\"acceleration_limit\":", "\"speed_share\":" })
        {
            var recorded = File.ReadAllText(_path);
            var header = recorded.IndexOf('\n');
            File.WriteAllText(_path, recorded[..header].Replace(limit, "\"unknown\":") + recorded[header..]);
            Assert.That(Differences("adaptive").Max(), Is.GreaterThan(1e-6), limit + " has no effect on the displayed positions");
            File.WriteAllText(_path, recorded);
        }
    }

    [Test]
    public void Replay_AnotherPredictor_Differs()
    {
        VirtualRecording.To(_path, predictor: "quadratic", blendMs: 14);

        Assert.That(Differences("linear").Max(), Is.GreaterThan(1e-3));
    }

    [Test]
    public void Run_ContinuousJointWraps_HasTheErrorsOfTheUnwrappedMotion()
    {
        var unwrapped = Elbow(angle => angle);
        var wrapped = Elbow(angle => Math.IEEERemainder(angle, 2 * Math.PI));

        Assert.That(unwrapped.Rms, Is.GreaterThan(1e-3));
        Assert.That(wrapped.Rms, Is.EqualTo(unwrapped.Rms).Within(1e-9));
        Assert.That(wrapped.Max, Is.EqualTo(unwrapped.Max).Within(1e-9));
        Assert.That(wrapped.RmsHold, Is.EqualTo(unwrapped.RmsHold).Within(1e-9));

        ErrorComparison Elbow(Func<double, double> published)
        {
            var times = Enumerable.Range(0, 240).Select(i => 0.05 * i);
            File.WriteAllLines(_path, [JointFile.Header, .. times.Select(t => JointFile.Sample(t, t + 0.1, published(1.5 * t + 0.3 * Math.Sin(2 * t))))]);
            var session = RecordedSession.Read(_path);
            return new SessionReplay(_path, session, new SessionTruth(session), new ReplaySettings { Predictor = "quadratic" }).Run().Axes.Single().Error;
        }
    }

    [TestCase(1)]
    [TestCase(2)]
    public async Task Reduction_SamplesAsTruth_IsCloseToTheTrueReduction(int seed)
    {
        var recording = VirtualRecording.To(_path, seconds: 40, seed: seed, samplingMs: 20);

        var run = await Run("replay", _path, "--predictor", "quadratic", "--json");

        using var json = JsonDocument.Parse(run.Output);
        var truth = 1 - Math.Sqrt(recording.DisplayedSquares / recording.HeldSquares);
        Assert.That(json.RootElement.GetProperty("reduction").GetDouble(), Is.EqualTo(truth).Within(0.02), $"seed {seed}");
        Assert.That(truth, Is.GreaterThan(0.6));
    }

    [Test]
    public async Task Json_Session_HasTheKeysOfAMotionAndTotalsForEachUnit()
    {
        VirtualRecording.To(_path);

        var run = await Run("replay", _path, "--json", "--predictor", "hold");

        using var json = JsonDocument.Parse(run.Output);
        Assert.That(
            json.RootElement.EnumerateObject().Select(p => p.Name),
            Is.EqualTo(new[] { "file", "predictor", "frames", "axes", "rms_hold", "rms", "reduction", "conditions", "totals" }));
        Assert.That(json.RootElement.GetProperty("reduction").GetDouble(), Is.EqualTo(0));
        Assert.That(json.RootElement.GetProperty("frames").GetInt32(), Is.InRange(900, 1200));
        Assert.That(json.RootElement.GetProperty("axes")[0].GetProperty("name").GetString(), Is.EqualTo("arm_joint_1"));
    }

    [TestCase("--sampling-ms=50")]
    [TestCase("--latency-ms=100")]
    [TestCase("--fps=60")]
    [TestCase("--phases=2")]
    [TestCase("--jitter-ms=0")]
    [TestCase("--loss=0")]
    public async Task Option_FixedByTheRecording_IsRefused(string option)
    {
        VirtualRecording.To(_path, seconds: 8);

        var run = await Run("replay", _path, option);

        Assert.That(run.ExitStatus, Is.EqualTo(2));
        Assert.That(run.Errors, Does.StartWith(ConsoleMessages.Line(option.Split('=')[0] + ": " + ReplayMessages.InSession(_path))));
        Assert.That(run.Errors.Trim().Split('\n'), Has.Length.EqualTo(1));
    }

    [TestCase("--predictor=linear-h4")]
    [TestCase("--latency-error-ms=20")]
    [TestCase("--stamp-error-ms=10")]
    [TestCase("--blend-ms=40")]
    public async Task Option_NotFixedByTheRecording_ChangesTheResult(string option)
    {
        VirtualRecording.To(_path, seconds: 10);

        var plain = await Run("replay", _path, "--json");
        var changed = await Run("replay", _path, "--json", option);

        Assert.That(changed.ExitStatus, Is.EqualTo(0), changed.Errors);
        Assert.That(RmsOf(changed), Is.Not.EqualTo(RmsOf(plain)).Within(1e-6));
    }

    [Test]
    public async Task StampError_AnotherSeed_Differs()
    {
        VirtualRecording.To(_path, seconds: 10);

        var one = await Run("replay", _path, "--json", "--stamp-error-ms=5", "--seed=1");
        var again = await Run("replay", _path, "--json", "--stamp-error-ms=5", "--seed=1");
        var other = await Run("replay", _path, "--json", "--stamp-error-ms=5", "--seed=2");

        Assert.That(RmsOf(again), Is.EqualTo(RmsOf(one)));
        Assert.That(RmsOf(other), Is.Not.EqualTo(RmsOf(one)));
    }

    [Test]
    public async Task Replay_CompressedOrTruncated_ReadsUpToTheEnd()
    {
        VirtualRecording.To(_path, seconds: 10);
        var text = File.ReadAllText(_path);
        using var whole = new TemporaryFile(text, ".jsonl.gz");
        using var torn = new TemporaryFile(text[..(text.Length - 200)], ".jsonl");

        var plain = await Run("replay", _path, "--json");
        var compressed = await Run("replay", whole.Path, "--json");
        var cut = await Run("replay", torn.Path, "--json");

        Assert.That(RmsOf(compressed), Is.EqualTo(RmsOf(plain)));
        Assert.That(cut.ExitStatus, Is.EqualTo(0), cut.Errors);
        Assert.That(RmsOf(cut), Is.EqualTo(RmsOf(plain)).Within(0.01 * RmsOf(plain)));
    }

    [Test]
    public void Samples_WithVelocitiesAndAccelerations_AreRead()
    {
        VirtualRecording.To(_path, seconds: 1);
        var header = File.ReadLines(_path).First();
        File.WriteAllText(_path, header + "\n" + """
            {"kind":"sample","arrival_ns":200,"stamp_ns":100,"names":["arm_joint_2","nobody","arm_joint_1"],"position":[1,2,3],"velocity":[0.5,1,null],"acceleration":[4,null,-2]}
            """ + "\n");

        var session = RecordedSession.Read(_path);

        var values = session.ValuesOf(session.Events.Single()).ToArray();
        Assert.That(values, Is.EqualTo(new[] { new RecordedSession.Value(1, 1, 0.5, 4), new RecordedSession.Value(0, 3, double.NaN, -2) }));
    }

    [TestCase("--estimator=default")]
    [TestCase("--json")]
    public async Task Sync_Session_EqualsSyncOfItsExchanges(string option)
    {
        var recording = VirtualRecording.To(_path, stepAfter: 10);
        using var log = new TemporaryFile("t1_ns,t2_ns,t3_ns,t4_ns\n" + string.Join('\n', recording.Exchanges) + "\n");

        var ofSession = await Run("sync", _path, option);
        var ofLog = await Run("sync", log.Path, option);

        Assert.That(ofSession.ExitStatus, Is.EqualTo(0), ofSession.Errors);
        Assert.That(recording.Exchanges, Has.Count.GreaterThan(80));
        Assert.That(ofSession.Output, Is.EqualTo(ofLog.Output));
    }

    [Test]
    public async Task Sync_SessionWithMissingLines_ReportsThem()
    {
        VirtualRecording.To(_path);
        await File.AppendAllTextAsync(_path, "{\"kind\":\"lost\",\"count\":12}\n");

        var run = await Run("sync", _path);

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        Assert.That(run.Complaints, Has.One.EqualTo(ConsoleMessages.LostLines(_path, 12)));
    }

    [Test]
    public async Task SyncPage_Session_HasTheDataOfItsExchanges()
    {
        var recording = VirtualRecording.To(_path);
        using var log = new TemporaryFile("t1_ns,t2_ns,t3_ns,t4_ns\n" + string.Join('\n', recording.Exchanges) + "\n");
        string In(string name) => Path.Combine(_folder, name);

        var ofSession = await Run("sync", _path, "--estimator", "ransac", "--page", In("of-session.html"));
        var ofLog = await Run("sync", log.Path, "--estimator", "ransac", "--page", In("of-log.html"));

        Assert.That((ofSession.ExitStatus, ofLog.ExitStatus), Is.EqualTo((0, 0)), ofSession.Errors + ofLog.Errors);
        Assert.That(File.ReadAllText(In("of-session.html")), Does.Contain(Path.GetFileName(_path)));
        Assert.That(File.ReadAllText(In("of-session.csv")), Is.EqualTo(File.ReadAllText(In("of-log.csv"))));
        Assert.That(File.ReadLines(In("of-session.csv")).Count(), Is.EqualTo(recording.Exchanges.Count + 1));
    }

    static double RmsOf(CliRun run)
    {
        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        using var json = JsonDocument.Parse(run.Output);
        return json.RootElement.GetProperty("rms").GetDouble();
    }
}
