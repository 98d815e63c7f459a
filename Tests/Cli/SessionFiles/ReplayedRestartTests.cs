using System.Text.Json.Nodes;
using Nowpose.Cli.Replay;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.SessionFiles;

/// <summary>Tests the replay of a source that restarts with its clock behind, so that its time stamps repeat.</summary>
public class ReplayedRestartTests : SessionReplayFixture
{
    // The clock of the restarted source is behind, so the session shows no object as current after the restart.
    [Test]
    public void Run_SourceOfPosesRestartsWithItsClockBehind_DoesNotMixTheTwoRuns()
    {
        VirtualRecording.To(_path, hasWork: true);
        var (restarted, ended) = Restart(fields => (string)fields["kind"] == "pose" && fields["stationary"] == null);

        var (withRestart, withoutRestart) = (Bodies(restarted), Bodies(ended));

        Assert.That(withoutRestart, Is.Not.Empty);
        Assert.That(withRestart, Is.EqualTo(withoutRestart));

        (string, int, double)[] Bodies(List<string> of) =>
            [.. new SessionBodies(Read(of), new ReplaySettings()).Run().Select(body => (body.File, body.Frames, body.Position.Rms))];
    }

    [Test]
    public void Run_SourceOfJointsRestartsWithItsClockBehind_DoesNotMixTheTwoRuns()
    {
        VirtualRecording.To(_path, jitterMs: 20);
        var (restarted, ended) = Restart(fields => (string)fields["kind"] == "sample");

        var (withRestart, withoutRestart) = (Joints(Read(restarted)), Joints(Read(ended)));

        Assert.That(withoutRestart.Frames, Is.GreaterThan(400));
        Assert.That(withRestart.Frames, Is.EqualTo(withoutRestart.Frames));
        Assert.That(withRestart.Axes, Is.EqualTo(withoutRestart.Axes));
    }

    // The delay is less than the maximum gap of the header, so the second run is shown as current, too.
    [Test]
    public void Run_ClockGoesBackByLessThanTheMaximumGap_ScoresBothRuns()
    {
        var before = Enumerable.Range(0, 200).Select(i => JointFile.Sample(stamp: 0.05 * i, arrival: 0.05 * i + 0.1, position: 0.5 * 0.05 * i));
        var after = Enumerable.Range(200, 200).Select(i => JointFile.Sample(stamp: 0.05 * i - 0.32, arrival: 0.05 * i + 0.1, position: 0.5 * 0.05 * i + 2));

        var result = Joints(Read([JointFile.Header, .. before, .. after]));

        Assert.That(result.Frames, Is.GreaterThan(1100));
        Assert.That(result.Axes.Single().Error.Max, Is.LessThan(1e-6));
        Assert.That(result.Axes.Single().Error.RmsHold, Is.InRange(0.07, 0.2));
    }

    /// <summary>Lets the source of the given lines restart after half of them, 2 s behind and elsewhere, or end there.</summary>
    (List<string> Restarted, List<string> Ended) Restart(Func<JsonNode, bool> isOfSource)
    {
        var lines = File.ReadLines(_path).Select(line => (Text: line, Fields: JsonNode.Parse(line))).ToList();
        var arrivals = lines.Where(line => isOfSource(line.Fields)).Select(line => (long)line.Fields["arrival_ns"]).ToList();
        var restart = arrivals[arrivals.Count / 2];
        var (restarted, ended) = (new List<string>(), new List<string>());
        foreach (var (text, fields) in lines)
        {
            var isLater = isOfSource(fields) && (long)fields["arrival_ns"] >= restart;
            if (isLater)
            {
                fields["stamp_ns"] = (long)fields["stamp_ns"] - 2_000_000_000;
                fields["position"] = new JsonArray([.. fields["position"].AsArray().Select(value => (JsonNode)((double)value + 0.5))]);
            }

            restarted.Add(isLater ? fields.ToJsonString() : text);
            if (!isLater) ended.Add(text);
        }

        return (restarted, ended);
    }

    RecordedSession Read(List<string> lines)
    {
        File.WriteAllLines(_path, lines);
        return RecordedSession.Read(_path);
    }

    ReplayResult Joints(RecordedSession session) => new SessionReplay(_path, session, new SessionTruth(session), new ReplaySettings { Predictor = "linear" }).Run();
}
