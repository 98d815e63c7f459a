using System.Text.Json;
using System.Text.Json.Nodes;
using Nowpose.Cli.Messages;
using Nowpose.Cli.Replay;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.SessionFiles;

public class ReplayedCellTests : SessionReplayFixture
{
    // The robot in the header can be in a namespace, and a further robot without one.
    [TestCase("arm2")]
    [TestCase("")]
    public void Replay_FurtherRobotWithTheSameSamples_HasTheSameErrors(string name)
    {
        VirtualRecording.To(_path, seconds: 8);
        var lines = new List<string>();
        foreach (var line in File.ReadLines(_path))
        {
            var fields = JsonNode.Parse(line);
            var kind = (string)fields["kind"];
            lines.Add(line);
            if (kind == "session") lines.Add(RobotLine(name, fields["robot"]));
            if (kind != "sample") continue;
            fields["names"] = new JsonArray([.. fields["names"].AsArray().Select(joint => (JsonNode)(name + "/" + joint))]);
            lines.Add(fields.ToJsonString());
        }
        File.WriteAllLines(_path, lines);

        var session = RecordedSession.Read(_path);
        var axes = new SessionReplay(_path, session, new SessionTruth(session), new ReplaySettings()).Run().Axes;

        var (own, further) = (axes.Take(axes.Count / 2).ToArray(), axes.Skip(axes.Count / 2).ToArray());
        Assert.That(further.Select(axis => axis.Name), Is.EqualTo(own.Select(axis => name + "/" + axis.Name)));
        Assert.That(further.Select(axis => axis.Error.Rms), Is.EqualTo(own.Select(axis => axis.Error.Rms)));
        Assert.That(own.Max(axis => axis.Error.Rms), Is.GreaterThan(0));
    }

    [Test]
    public void Read_FurtherRobotHasTheNameOfAJointInTheHeader_KeepsTheJointOfTheHeader()
    {
        File.WriteAllLines(_path,
        [
            JointFile.Header.Replace("elbow", "arm2/elbow"),
            """{"kind":"robot","namespace":"arm2","name":"r","joints":[{"name":"elbow","unit":"m","lower":0,"upper":1}]}""",
        ]);

        var joint = RecordedSession.Read(_path).Header.Joints.Single();

        Assert.That((joint.Unit, joint.Limits.Upper), Is.EqualTo(("rad", double.PositiveInfinity)));
    }

    static string RobotLine(string name, JsonNode robot)
    {
        var line = new JsonObject { ["kind"] = "robot", ["namespace"] = name };
        foreach (var (field, value) in robot.AsObject()) line[field] = value.DeepClone();
        return line.ToJsonString();
    }

    [Test]
    public async Task Replay_ObjectsAndSignals_ReportsErrorsOfObjectsAndChangesOfSignals()
    {
        VirtualRecording.To(_path, predictor: "adaptive", jitterMs: 20, loss: 0.02, hasWork: true);

        var run = await Run("replay", _path, "--json");
        var hold = await Run("replay", _path, "--json", "--predictor", "hold");

        Assert.That(run.ExitStatus, Is.Zero, run.Errors);
        var result = JsonDocument.Parse(run.Output).RootElement;
        var bodies = result.GetProperty("bodies").EnumerateArray().ToList();
        Assert.That(bodies.Select(body => body.GetProperty("name").GetString()), Is.EqualTo(new[] { "workpiece_1", "workpiece_2", "workpiece_3" }));
        foreach (var body in bodies)
        {
            Assert.That(body.GetProperty("frames").GetInt32(), Is.GreaterThan(50));
            var error = body.GetProperty("error_mm");
            Assert.That(error.GetProperty("rms").GetDouble(), Is.LessThan(0.3 * error.GetProperty("rms_hold").GetDouble()));
        }

        var held = JsonDocument.Parse(hold.Output).RootElement.GetProperty("bodies")[0].GetProperty("error_mm");
        Assert.That(held.GetProperty("rms").GetDouble(), Is.EqualTo(held.GetProperty("rms_hold").GetDouble()).Within(1e-9));
        var signals = result.GetProperty("signals").EnumerateArray().ToDictionary(one => one.GetProperty("name").GetString(), one => one.GetProperty("changes").GetInt32());
        Assert.That(signals.Keys, Is.EquivalentTo(new[] { "gripper_closed", "belt_running", "part_present" }));
        Assert.That(signals["gripper_closed"], Is.GreaterThan(2));
        var table = await Run("replay", _path);
        Assert.That(table.Output, Does.Contain("workpiece_1").And.Contain("signals: ").And.Contain("gripper_closed ("));
    }

    [Test]
    public void Replay_ObjectsOnStationaryFrames_ReportsTheErrorsOfTheDisplayedPoses()
    {
        VirtualRecording.To(_path, predictor: "adaptive", hasWork: true);

        var bodies = new SessionBodies(RecordedSession.Read(_path), new ReplaySettings { Predictor = "hold" }).Run();

        Assert.That(bodies, Is.Not.Empty);
        foreach (var body in bodies)
        {
            var (position, rotation) = body.Displayed.Value;
            Assert.That(position.Rms, Is.InRange(0.001, 0.4 * body.Position.Rms), body.File);
            Assert.That(position.RmsHold, Is.GreaterThan(2 * position.Rms), body.File);
            Assert.That(rotation.Rms, Is.LessThan(1), body.File);
        }
    }

    [Test]
    public void Replay_DisplayedPoseMovedByTenCentimetres_ReportsThisError()
    {
        VirtualRecording.To(_path, predictor: "adaptive", hasWork: true);
        var before = Displayed();
        File.WriteAllLines(_path, [.. File.ReadLines(_path).Select(line =>
        {
            var fields = JsonNode.Parse(line);
            if ((string)fields["kind"] != "object") return line;
            fields["position"][2] = (double)fields["position"][2] + 0.1;
            return fields.ToJsonString();
        })]);

        Assert.That(Displayed(), Is.EqualTo(before.Select(rms => Math.Sqrt(rms * rms + 1e4))).Within(2.0));

        double[] Displayed() => [.. new SessionBodies(RecordedSession.Read(_path), new ReplaySettings()).Run().Select(body => body.Displayed.Value.Position.Rms)];
    }

    [Test]
    public async Task Replay_RecordingWithoutDisplayedObjects_StatesNoDisplayedError()
    {
        VirtualRecording.To(_path, hasWork: true);
        File.WriteAllLines(_path, File.ReadLines(_path).Where(line => !line.Contains("\"kind\":\"object\"")).ToArray());

        var run = await Run("replay", _path, "--json");

        var bodies = JsonDocument.Parse(run.Output).RootElement.GetProperty("bodies");
        Assert.That(bodies.GetArrayLength(), Is.EqualTo(3));
        Assert.That(bodies.EnumerateArray().Select(body => body.GetProperty("displayed_error_mm").ValueKind), Is.All.EqualTo(JsonValueKind.Null));
    }

    [TestCase(0)]
    [TestCase(3)]
    public async Task Replay_TooFewSamplesOfJoints_ReportsErrorsOfObjects(int samples)
    {
        VirtualRecording.To(_path, hasWork: true);
        var read = 0;
        File.WriteAllLines(_path, File.ReadAllLines(_path).Where(line => !line.Contains("\"kind\":\"sample\"") || read++ < samples));

        var run = await Run("replay", _path, "--json");
        var table = await Run("replay", _path);

        Assert.That(run.ExitStatus, Is.Zero, run.Errors);
        var result = JsonDocument.Parse(run.Output).RootElement;
        Assert.That(run.Errors.Contains(SessionReplay.NothingScored), Is.EqualTo(samples > 0), run.Errors);
        Assert.That(result.GetProperty("axes").GetArrayLength(), Is.Zero);
        Assert.That(result.GetProperty("reduction").ValueKind, Is.EqualTo(JsonValueKind.Null));
        Assert.That(result.GetProperty("bodies").GetArrayLength(), Is.EqualTo(3));
        Assert.That(table.Output, Does.Contain("workpiece_1").And.Not.Contain("axis"));
    }

    [TestCase(0.5)]
    [TestCase(1)]
    public void RunSession_CancelledBeforeAJointIsScored_KeepsTheObjects(double share)
    {
        VirtualRecording.To(_path, hasWork: true);
        var session = RecordedSession.Read(_path);
        using var end = new CancellationTokenSource();

        var result = ReplayVerb.RunSession(_path, session, new ReplaySettings(), Stop, end.Token);

        Assert.That(result.Bodies, Is.Not.Empty);
        Assert.That(result.Axes, Is.Empty);

        void Stop(int done)
        {
            if (done >= share * session.Events.Count) end.Cancel();
        }
    }

    [Test]
    public async Task Replay_SessionWithoutObjects_ResultContainsNoObjects()
    {
        VirtualRecording.To(_path, seconds: 6, predictor: "adaptive");

        var run = await Run("replay", _path, "--json");

        var names = JsonDocument.Parse(run.Output).RootElement.EnumerateObject().Select(one => one.Name);
        Assert.That(names, Is.EqualTo(new[] { "file", "predictor", "frames", "axes", "rms_hold", "rms", "reduction", "conditions", "totals" }));
    }

    static readonly string[][] DamagedPoses =
    [
        ["[0,0,0]", "[0,0,0,2]", "world", "rotation", SessionFileMessages.NotARotation],
        ["[0,0,0]", "[0,0,1]", "world", "rotation", SessionFileMessages.Count(3, 4)],
        ["[0,0,0]", "\"none\"", "world", "rotation", SessionFileMessages.NotAnArray],
        ["[0,2e6,0]", "[0,0,0,1]", "world", "position", SessionFileMessages.TooFar(2e6, 1e6)],
        ["[0,0,0]", "[0,0,0,1]", "part", "parent", SessionFileMessages.OwnParent],
        ["[0,0,0]", "[0,0,0,1]", "", "parent", SessionFileMessages.Name("", 128)],
        ["[0,0,0]", "[0,0,0,1]", "map", "frame", SessionFileMessages.WorldAsFrame],
    ];

    [TestCaseSource(nameof(DamagedPoses))]
    public async Task Replay_DamagedPose_NamesItsLineAndField(string position, string rotation, string parent, string field, string message)
    {
        VirtualRecording.To(_path, seconds: 6);
        var lines = File.ReadAllLines(_path).ToList();
        var frame = field == "frame" ? "world" : "part";
        lines.Insert(5, $"{{\"kind\":\"pose\",\"arrival_ns\":1,\"stamp_ns\":1,\"frame\":\"{frame}\",\"parent\":\"{parent}\",\"position\":{position},\"rotation\":{rotation}}}");
        File.WriteAllLines(_path, lines);

        var run = await Run("replay", _path);

        Assert.That(run.ExitStatus, Is.EqualTo(2));
        Assert.That(run.Errors, Does.Contain($"{_path}:6: field '{field}' {message}"));
    }

    [Test]
    public async Task Replay_FrameWithAnotherNumberOfJoints_NamesItsLineAndField()
    {
        VirtualRecording.To(_path, seconds: 6);
        var lines = File.ReadAllLines(_path).ToList();
        lines.Insert(5, "{\"kind\":\"frame\",\"start_ns\":1,\"joints\":[0]}");
        File.WriteAllLines(_path, lines);

        var run = await Run("replay", _path);

        Assert.That(run.ExitStatus, Is.EqualTo(2));
        Assert.That(run.Errors, Does.Contain($"{_path}:6: field 'joints' has 1 numbers"));
    }
}
