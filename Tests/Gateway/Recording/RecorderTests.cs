using System.Text.Json;
using Nowpose.Gateway;
using Nowpose.Gateway.Plants;
using Nowpose.Gateway.Recording;
using Nowpose.Protocol;
using NUnit.Framework;
using static Nowpose.Headless.Tests.Gateway.Recording.RecorderCell;

namespace Nowpose.Headless.Tests.Gateway.Recording;

/// <summary>Tests the content of the gateway's recordings, and that other programs can use them.</summary>
public class RecorderTests
{
    RecorderCell _cell;

    [SetUp]
    public void SetUp() => _cell = new RecorderCell();

    [TearDown]
    public void TearDown() => _cell.Dispose();

    [Test]
    public async Task Record_DescribedRobot_CanBeReplayedAndAnalysed()
    {
        _cell.Source.Describe(RobotFiles.LoadText("youbot"));
        await using var recorder = _cell.Open();
        recorder.SwitchOn();
        _cell.Publish(400, "arm_joint_1", "arm_joint_2");
        await recorder.SwitchOffAsync().Bounded();

        var path = recorder.Path;
        Assert.That(Path.GetFileName(path), Does.StartWith("press_1-").And.EndsWith(".jsonl"));
        var replay = await CliRun.OfAsync("replay", path, "--json").Bounded();
        Assert.That(replay.ExitStatus, Is.EqualTo(0), replay.Errors);
        var result = JsonDocument.Parse(replay.Output).RootElement;
        Assert.That(result.GetProperty("frames").GetInt32(), Is.GreaterThan(800), "20 s at 60 frames a second");
        Assert.That(result.GetProperty("rms_hold").GetDouble(), Is.InRange(0.02, 0.5), "80 ms of a sine of 1.3 rad/s");
        Assert.That(result.GetProperty("reduction").GetDouble(), Is.GreaterThan(0.5));
        var recommend = await CliRun.OfAsync("recommend", path, "--json").Bounded();
        Assert.That(recommend.ExitStatus, Is.EqualTo(0), recommend.Errors);
        var sync = await CliRun.OfAsync("sync", path).Bounded();
        Assert.That(sync.ExitStatus, Is.EqualTo(0), sync.Errors);
    }

    [Test]
    public async Task Record_RobotWithoutDescription_CanBeReplayedWithTheReceivedJoints()
    {
        await using var recorder = _cell.Open();
        recorder.SwitchOn();
        _cell.Publish(100, "a", "b");
        await recorder.SwitchOffAsync().Bounded();

        var replay = await CliRun.OfAsync("replay", recorder.Path, "--json").Bounded();

        Assert.That(replay.ExitStatus, Is.EqualTo(0), replay.Errors);
        var axes = JsonDocument.Parse(replay.Output).RootElement.GetProperty("axes").EnumerateArray()
            .Select(axis => axis.GetProperty("name").GetString());
        Assert.That(axes, Is.EqualTo(new[] { "a", "b" }));
    }

    [Test]
    public async Task Record_AllKindsOfMessages_WritesThemInOrder()
    {
        await using var recorder = _cell.Open();
        recorder.SwitchOn();
        for (var i = 0; i < 3000; i++)
        {
            _cell.Source.Publish(new JointStateMessage(Gateways.Start, ["a"], [i]));
            if (i % 1000 == 0) await Task.Yield();
        }
        _cell.Source.Publish(new JointTrajectoryMessage(Gateways.Start, ["a"], [new JointTrajectoryPoint(TimeSpan.Zero, [0.25])]));
        _cell.Source.Publish(RosTopics.Diagnostics, new DiagnosticsMessage(
            Gateways.Start, "goggles", [KeyValuePair.Create("rtt_ms", "3"), KeyValuePair.Create("say \"so\"", "\n")]));
        _cell.Drops.Count(DropReason.NotJson);
        await Soon.BecomesAsync(() => HasDrops(recorder.Path), "the drops of this second");
        await recorder.SwitchOffAsync().Bounded();

        var lines = Lines(recorder.Path);
        var samples = lines.Where(line => line.GetProperty("kind").GetString() == "sample").ToArray();
        Assert.That(samples.Select(line => line.GetProperty("position")[0].GetDouble()), Is.EqualTo(Enumerable.Range(0, 3000)));
        Assert.That(lines[0].GetProperty("recorded_by").GetString(), Is.EqualTo("gateway"));
        Assert.That(Count(lines, "plan"), Is.EqualTo(1));
        var diagnostics = lines.Single(line => line.GetProperty("kind").GetString() == "diagnostics");
        Assert.That(diagnostics.GetProperty("name").GetString(), Is.EqualTo("goggles"));
        Assert.That(diagnostics.GetProperty("values").GetProperty("say \"so\"").GetString(), Is.EqualTo("\n"));
        Assert.That(lines[^1].GetProperty("reason").GetString(), Is.EqualTo("closed"));
        Assert.That(recorder.Status.Lost, Is.Zero);
        Assert.That(recorder.Status.Lines, Is.EqualTo(lines.Length - 2), "the count includes all lines except the header and the end");
    }

    static bool HasDrops(string path)
    {
        // The recorder creates the file on its own thread, so the file may not exist yet.
        if (!File.Exists(path)) return false;
        using var reader = new StreamReader(new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite));
        return reader.ReadToEnd().Contains("\"drops\"");
    }

    [Test]
    public void SwitchOn_WithoutAFolder_NamesTheOption()
    {
        var recorder = new Recorder(new GatewayOptions(), _cell.Hub, _cell.Clock, _cell.Plant, _cell.Drops, _ => { });

        Assert.That(recorder.SwitchOn, Throws.InstanceOf<InputException>().With.Message.Contains("--recordings"));
        Assert.That(recorder.Status.Can, Is.False);
    }
}
