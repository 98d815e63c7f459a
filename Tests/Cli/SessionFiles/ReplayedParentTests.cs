using System.Text.Json.Nodes;
using Nowpose.Cli.Replay;
using Nowpose.Frames;
using Nowpose.Gateway.Plants;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Protocol.Cell;
using Nowpose.Recording;
using Nowpose.Session;
using Nowpose.Sync;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.SessionFiles;

/// <summary>Tests the replay of objects below frames that move.</summary>
public class ReplayedParentTests : SessionReplayFixture
{
    const double Sampling = 0.05, Latency = 0.08;

    // A part rests on a fixture that is fixed to a shuttle. The shuttle moves and turns, and a lid turns on the part.
    [Test]
    public void Replay_ObjectsBelowAMovingParent_ComparesTheComposedPosesInTheWorld()
    {
        Record();

        var bodies = Replay();

        Assert.That(bodies.Select(body => body.File), Is.EqualTo(new[] { "lid", "part", "shuttle" }));
        foreach (var body in bodies)
        {
            var (position, rotation) = body.Displayed.Value;
            Assert.That(body.Frames, Is.GreaterThan(400), body.File);
            Assert.That(position.RmsHold, Is.GreaterThan(10), body.File);
            Assert.That(position.Rms, Is.InRange(1e-3, 0.3 * position.RmsHold), body.File);
            Assert.That(position.Rms, Is.EqualTo(body.Position.Rms).Within(0.05 * position.Rms), body.File + ": the session used the same predictor");
            Assert.That(rotation.Rms, Is.EqualTo(body.Rotation.Rms).Within(0.05 * rotation.Rms), body.File);
        }
    }

    [Test]
    public void Replay_DisplayedPoseBelowAMovingParentMovedByTenCentimetres_ReportsThisError()
    {
        Record();
        var before = Replay().Single(body => body.File == "part").Displayed.Value.Position.Rms;
        File.WriteAllLines(_path, [.. File.ReadLines(_path).Select(line =>
        {
            var fields = JsonNode.Parse(line);
            if ((string)fields["kind"] != "object" || (string)fields["frame"] != "part") return line;
            fields["position"][2] = (double)fields["position"][2] + 0.1;
            return fields.ToJsonString();
        })]);

        var moved = Replay().Single(body => body.File == "part").Displayed.Value.Position.Rms;

        Assert.That(moved, Is.EqualTo(Math.Sqrt(before * before + 1e4)).Within(0.1));
    }

    // The recording does not have the poses of links.
    [Test]
    public void Replay_ObjectBelowALink_ComparesOnlyThePredictionInThisParent()
    {
        Record(shuttleParent: "arm_link_5");

        var bodies = Replay();

        Assert.That(bodies.Select(body => body.File), Is.EqualTo(new[] { "lid", "part", "shuttle" }));
        Assert.That(bodies.Select(body => body.Displayed), Is.All.Null);
        Assert.That(bodies.Select(body => body.Position.Rms), Is.All.GreaterThan(0));
    }

    [TestCase(FrameParents.World)]
    [TestCase("arm_link_5")]
    public void Scored_MovingParent_NamesTheFrameOfThePoses(string parent)
    {
        Record(shuttleParent: parent);
        var frames = new HashSet<string>();

        new SessionBodies(RecordedSession.Read(_path), new ReplaySettings()) { Scored = (_, frame, _) => frames.Add(frame) }.Run();

        Assert.That(frames, Is.EqualTo(new[] { parent }));
    }

    [Test]
    public void Replay_MovingParentWithoutData_IsNotCompared()
    {
        Record(shuttleUntil: 6);

        // The lid turns by itself until the end, so it would be compared alone.
        var (whole, ended) = (Frames("shuttle"), Frames("lid"));

        Assert.That(ended, Is.EqualTo(whole).Within(2));

        int Frames(string name) => Replay().Single(body => body.File == name).Frames;
    }

    IReadOnlyList<BodyReplayResult> Replay() => new SessionBodies(RecordedSession.Read(_path), new ReplaySettings { Predictor = "quadratic" }).Run();

    /// <param name="shuttleUntil">Time after which the shuttle sends no poses, s.</param>
    void Record(string shuttleParent = FrameParents.World, double shuttleUntil = double.PositiveInfinity)
    {
        using var session = new CompensationSession(
            new SessionSettings(new ConnectionSettings("127.0.0.1"), VisualisationLatency.FromMilliseconds(40), new PredictionSettings("quadratic")),
            RobotFiles.Load("youbot"), new StopwatchHeadsetClock());
        foreach (var name in new[] { "shuttle", "part", "lid" }) session.Frames.Need(name);
        using var recorder = new SessionRecorder(session, new RecordingSettings(_path));
        session.Listener.FramesReceived(
            new TransformsMessage(RigidTransform.FromXyzRpy(0.2, 0, 0.1, 0, 0, 1).ToTransform(default, "shuttle", "fixture")), true, HeadsetTime.FromSeconds(10));
        var next = 10.0;
        for (var i = 0; i < 720; i++)
        {
            var now = 10 + i / 60.0;
            var control = ControlTime.FromSeconds(now);
            var half = TimeSpan.FromMilliseconds(1);
            if (i % 12 == 0) session.Clock.Add(new SyncExchange(HeadsetTime.FromSeconds(now) - half, control, control, HeadsetTime.FromSeconds(now) + half), out _);
            for (; next + Latency <= now; next += Sampling) Send(session, next, shuttleParent, hasShuttle: next < 10 + shuttleUntil);
            session.Tick(HeadsetTime.FromSeconds(now));
            if (i % 120 == 0) recorder.FlushAsync().Wait();
        }
        recorder.Dispose();
        recorder.Ended.Wait();
    }

    static void Send(CompensationSession session, double t, string shuttleParent, bool hasShuttle)
    {
        var stamp = ControlTime.FromSeconds(t);
        var poses = new List<FrameTransform>
        {
            RigidTransform.FromXyzRpy(0, 0, 0.05, 0, 0, 0).ToTransform(stamp, "fixture", "part"),
            RigidTransform.FromXyzRpy(0, 0, 0.03, 0, 0, 0.5 * Math.Sin(t)).ToTransform(stamp, "part", "lid"),
        };
        if (hasShuttle) poses.Insert(0, RigidTransform.FromXyzRpy(Math.Sin(t), Math.Cos(t), 0, 0, 0, 0.4 * Math.Sin(1.3 * t)).ToTransform(stamp, shuttleParent, "shuttle"));
        session.Listener.FramesReceived(new TransformsMessage([.. poses]), false, HeadsetTime.FromSeconds(t + Latency));
    }
}
