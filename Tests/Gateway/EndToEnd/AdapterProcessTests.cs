using System.Diagnostics;
using NUnit.Framework;
using Nowpose.Gateway;
using Nowpose.Gateway.Options;
using Nowpose.Gateway.Plants;
using Nowpose.Gateway.Status.Events;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Gateway.EndToEnd;

/// <summary>Tests how a gateway manages the adapters that it starts. The plant does not exist; its port is closed.</summary>
public class AdapterProcessTests
{
    const string Good = """
        plant:
          kind: opcua
          name: absent
          endpoint: opc.tcp://127.0.0.1:9
        joints:
          - joint: a
            node: "ns=1;s=a"
        """;

    TemporaryFolder _folder;

    [SetUp]
    public void MakeFolder()
    {
        if (!Directory.Exists(Path.Combine(RepositoryFiles.Root, "Gateway", "Adapters", "node_modules")))
            Assert.Ignore("Node.js was missing when this was built");
        _folder = new TemporaryFolder();
    }

    [TearDown]
    public void RemoveFolder() => _folder?.Dispose();

    [TestCase(false)]
    [TestCase(true)]
    public async Task Start_PlantNotConnected_AdapterConnectsAsASourceAndReportsItsState(bool hasTokens)
    {
        await using var gateway = await Gateways.StartAsync(
            Gateways.Options() with { Tokens = hasTokens ? Gateways.Tokens : Nowpose.Gateway.Security.TokenList.None });
        var received = new TaskCompletionSource<DiagnosticsMessage>();
        using var listening = ListenTo(gateway, received);

        await using var adapters = AdapterProcesses.Start([Plant(Write(Good))], gateway);

        var diagnostics = await received.Task.Bounded();
        Assert.That(diagnostics.HardwareId, Is.EqualTo("plant/absent"));
        Assert.That(diagnostics.Values.Single(value => value.Key == "state").Value, Is.Not.EqualTo("connected"));
    }

    [Test]
    public async Task Run_AdapterKilled_IsRestartedWithAnEvent()
    {
        await using var gateway = await Gateways.StartAsync();
        var lines = new System.Collections.Concurrent.ConcurrentQueue<string>();
        await using var adapter = new AdapterProcess(Plant(Write(Good)), AdapterAccess.To(gateway), TimeProvider.System, lines.Enqueue);
        gateway.Expect([() => adapter.State]);
        await Soon.BecomesAsync(() => adapter.ProcessId != null && gateway.WebSocketConnections.Open == 1, "it is connected");

        using (var process = Process.GetProcessById(adapter.ProcessId.Value)) process.Kill();

        var recovery = await Soon.BecomesAsync(() => adapter.Starts == 2 && gateway.WebSocketConnections.Accepted == 2, "the adapter is connected again");
        TestContext.Out.WriteLine($"there again after {recovery.TotalSeconds:0.0} s");
        Assert.That(lines, Has.Some.Contains("its adapter ended (status 137) and starts again in 0.5 s"));
        await Soon.BecomesAsync(() => EventOf(gateway) is { Until: not null }, "it reports again");
        var ended = EventOf(gateway).Condition;
        Assert.That(ended.Text, Is.EqualTo(
            "adapter absent does not report: its program ended with status 137 and is started again. Read the adapter's lines in the gateway's log."));
        Assert.That((ended.Level, ended.Blocks), Is.EqualTo((Level.Error, true)));
    }

    [Test]
    public async Task Run_AdapterCannotStart_RaisesOneEventForAllAttempts()
    {
        await using var gateway = await Gateways.StartAsync();
        var lines = new System.Collections.Concurrent.ConcurrentQueue<string>();

        await using var adapter = new AdapterProcess(Plant(_folder.Path), AdapterAccess.To(gateway), TimeProvider.System, lines.Enqueue);
        gateway.Expect([() => adapter.State]);

        await Soon.BecomesAsync(() => lines.Count(line => line.Contains("its adapter ended", StringComparison.Ordinal)) >= 2, "it ended twice");
        await Soon.BecomesAsync(() => EventOf(gateway) != null, "the event has begun");
        Assert.That(EventOf(gateway).Until, Is.Null);
    }

    [Test]
    public async Task Start_AdapterEndsWhileTheLogIsRateLimited_GatewayLogsTheEnd()
    {
        var lines = new System.Collections.Concurrent.ConcurrentQueue<string>();
        await using var gateway = await GatewayServer.StartAsync(
            Gateways.Options(), new Nowpose.Gateway.Clock.StopwatchControlClock(Gateways.Start), lines.Enqueue).Bounded();
        for (var i = 0; i < 2 * RateLimitedLog.MaxKinds; i++) gateway.Log($"line {i}");

        await using var adapters = AdapterProcesses.Start([Plant(_folder.Path)], gateway);

        await Soon.BecomesAsync(() => lines.Any(line => line.Contains("its adapter ended", StringComparison.Ordinal)), "its end is logged");
        Assert.That(lines.Count(line => line.StartsWith("line ", StringComparison.Ordinal)), Is.EqualTo(RateLimitedLog.MaxKinds + RateLimitedLog.LinesAMinute));
    }

    [Test]
    public async Task Dispose_RunningAdapter_LeavesNoProcess()
    {
        await using var gateway = await Gateways.StartAsync();
        var adapter = new AdapterProcess(Plant(Write(Good)), AdapterAccess.To(gateway), TimeProvider.System, _ => { });
        await Soon.BecomesAsync(() => adapter.ProcessId != null, "it runs");
        using var process = Process.GetProcessById(adapter.ProcessId.Value);

        await adapter.DisposeAsync().AsTask().Bounded();

        Assert.That(process.HasExited, Is.True);
    }

    [Test]
    public async Task Serve_GatewayKilled_EndsItsAdapter()
    {
        var gateway = new PeerProcess("Nowpose.Gateway.dll", "serve", "--plant", Write(Good), "--sync-port", "0", "--ws-port", "0");
        await gateway.PrintsAsync("state serving");
        await Soon.BecomesAsync(() => ChildOf(gateway.Id) != null, "its adapter runs");
        using var child = Process.GetProcessById(ChildOf(gateway.Id).Value);

        // Kills only the gateway's process and not its child, like a crash.
        using (var itself = Process.GetProcessById(gateway.Id)) itself.Kill();

        Assert.That(child.WaitForExit(Soon.Limit), Is.True);
        gateway.Dispose();
    }

    [Test]
    public void Check_FilesWithInvalidEntries_ReportsEachInvalidLine()
    {
        var first = Write(Good.Replace("kind: opcua", "kind: opcua\n  sampling_msec: 10"), "first.yaml");
        var second = Write(Good.Replace("node:", "nod:"), "second.yaml");

        var wrong = Assert.ThrowsAsync<WrongEntriesException>(() => AdapterProcesses.CheckAsync([first, second], Gateways.Options(), default));

        Assert.That(wrong.Lines, Has.Some.Contains($"{first}, line 3").And.Some.Contains("sampling_ms"));
        Assert.That(wrong.Lines, Has.Some.Contains($"{second}, line 7"));
    }

    [Test]
    public void Check_TwoPlantsWithTheSameName_IsRefused()
    {
        var (first, second) = (Write(Good, "first.yaml"), Write(Good, "second.yaml"));

        var wrong = Assert.ThrowsAsync<WrongEntriesException>(() => AdapterProcesses.CheckAsync([first, second], Gateways.Options(), default));

        Assert.That(wrong.Lines, Is.EqualTo(new[]
        {
            $"{second}: its plant has the same name 'absent' as the one in {first}; set another plant.name in one of the two files",
        }));
    }

    [TestCase("kind: opcua\n  endpoint: opc.tcp://127.0.0.1:9", true, true)]
    [TestCase("kind: opcua\n  endpoint: opc.tcp://127.0.0.1:9", false, true)]
    [TestCase("kind: ros\n  endpoint: ws://127.0.0.1:9", true, true)]
    [TestCase("kind: ros\n  endpoint: ws://127.0.0.1:9", false, false)]
    public async Task Check_RobotJointsConfiguredInNoPlant_ListsThemUnlessAPlantAcceptsAnyJoint(string plant, bool hasJoints, bool isNamed)
    {
        var node = plant.Contains("opcua", StringComparison.Ordinal) ? "\n    node: ns=1;s=a" : "";
        var path = Write($"plant:\n  {plant}\n" + (hasJoints ? $"joints:\n  - joint: arm_joint_2{node}\n" : ""), "some.yaml");
        var other = Write(Good.Replace("joint: a", "joint: arm_joint_1"), "other.yaml");

        var (status, output, errors) = await CapturedConsole.OfAsync(() => Nowpose.Gateway.CommandLine.RunAsync(
            ["serve", "--check", "--robot", "youbot", "--plant", path, "--plant", other, "--ws-port", "0", "--sync-port", "0"]).Bounded());

        Assert.That(status, Is.Zero, errors);
        var line = CapturedConsole.Lines(output).SingleOrDefault(one => one.StartsWith("missing_joints ", StringComparison.Ordinal));
        var missing = hasJoints ? "arm_joint_3, arm_joint_4, arm_joint_5" : "arm_joint_2, arm_joint_3, arm_joint_4, arm_joint_5";
        Assert.That(line, isNamed ? Does.StartWith($"missing_joints {missing}; no plant configures them") : Is.Null);
    }

    [Test]
    public async Task Check_PlantWithRobot_ListsTheMissingJointsOfThatRobot()
    {
        var path = Write(Good.Replace("joint: a", "joint: shoulder_pan_joint") + "\nrobot: ur5\n");

        var plants = await AdapterProcesses.CheckAsync([path], Gateways.Options(), default);

        Assert.That(PlantFile.MissingJoints(plants, null), Is.EquivalentTo(
            new[] { "shoulder_lift_joint", "elbow_joint", "wrist_1_joint", "wrist_2_joint", "wrist_3_joint" }));
    }

    [Test]
    public async Task Check_RobotsInNamespaces_ListsTheMissingJointsOfRobotsWithConfiguredJoints()
    {
        var path = Write(Good.Replace("joint: a", "joint: arm1/shoulder_pan_joint") + "\nrobots: { arm1: ur5e, arm2: ur5e }\n");

        var plants = await AdapterProcesses.CheckAsync([path], Gateways.Options(), default);

        Assert.That(plants.Single().Robots.Keys, Is.EquivalentTo(new[] { "arm1", "arm2" }));
        Assert.That(PlantFile.MissingJoints(plants, null), Is.EquivalentTo(
            new[] { "arm1/shoulder_lift_joint", "arm1/elbow_joint", "arm1/wrist_1_joint", "arm1/wrist_2_joint", "arm1/wrist_3_joint" }));
    }

    [Test]
    public async Task Check_ParentInAnotherNodeThanThePose_PrintsAWarning()
    {
        const string Part = """

            frames:
              - frame: part
                parent: { of: [world, tool0], node: i=1 }
                position: { unit: m, x: { node: i=2 }, y: 0, z: 0 }
            """;
        var path = Write(Good + Part);

        var (status, output, errors) = await CapturedConsole.OfAsync(() => Nowpose.Gateway.CommandLine.RunAsync(
            ["serve", "--check", "--plant", path, "--ws-port", "0", "--sync-port", "0"]).Bounded());

        Assert.That(status, Is.Zero, errors);
        Assert.That(CapturedConsole.Lines(output), Has.One.StartsWith($"warning {path}, line 10: frames[0].parent: "));
    }

    [TestCase("convyor", true)]
    [TestCase("world", false)]
    [TestCase("conveyor", false)]
    [TestCase("fixture", false)]
    [TestCase("tool0", false)]
    [TestCase("arm2/tool0", false)]
    [TestCase("arm3/tool0", true)]
    [TestCase("tool9", true)]
    public async Task Check_ParentOfAFrame_IsListedUnlessTheFilesHaveIt(string parent, bool isNamed)
    {
        const string Objects = """
            plant: { kind: mqtt, endpoint: mqtt://127.0.0.1 }
            robots: { arm2: ur5e }
            frames:
              - { frame: conveyor, position: { unit: m, x: { topic: x }, y: 0, z: 0 } }

            """;
        var plant = Write(Good.Replace("joint: a", "joint: shoulder_pan_joint") + "\nrobot: ur5\nframes:\n"
            + $"  - {{ frame: part, parent: {parent}, position: {{ unit: m, x: {{ node: i=1 }}, y: 0, z: 0 }} }}\n");
        var objects = Write(Objects, "objects.yaml");
        var stationary = Write(
            """
            {"transforms": [{"header": {"stamp": {"sec": 0, "nanosec": 0}, "frame_id": "world"}, "child_frame_id": "fixture",
            "transform": {"translation": {"x": 0, "y": 0, "z": 0}, "rotation": {"x": 0, "y": 0, "z": 0, "w": 1}}}]}
            """, "stationary.json");

        var (status, output, errors) = await CapturedConsole.OfAsync(() => Nowpose.Gateway.CommandLine.RunAsync(
            ["serve", "--check", "--plant", plant, "--plant", objects, "--stationary", stationary, "--ws-port", "0", "--sync-port", "0"]).Bounded());

        Assert.That(status, Is.Zero, errors);
        var line = CapturedConsole.Lines(output).SingleOrDefault(one => one.StartsWith("missing_parents ", StringComparison.Ordinal));
        Assert.That(line, isNamed ? Does.StartWith($"missing_parents {parent} of part; ") : Is.Null);
    }

    /// <summary>The description is longer than the buffer of a pipe, so it could be truncated when the adapter's process exits.</summary>
    [Test]
    public async Task Check_LongRobotDescription_ArrivesCompletely()
    {
        var urdf = RobotFiles.LoadText("youbot").Replace("</robot>", $"<!-- {new string('x', 800_000)} --></robot>");
        Write(urdf, "long.urdf");
        var path = Write(Good.Replace("joint: a", "joint: arm_joint_1") + "\nrobot: long.urdf\n");

        var plants = await AdapterProcesses.CheckAsync([path], Gateways.Options(), default);

        Assert.That(plants.Single().Robot, Has.Length.EqualTo(urdf.Length));
    }

    [TestCase("frames: [{ frame: part, position: { unit: m, x: { topic: part }, y: 0, z: 0 } }]", false)]
    [TestCase("signals: [{ signal: closed, topic: gripper }]", false)]
    [TestCase("joints: [{ joint: a, topic: a }]\nsignals: [{ signal: closed, topic: gripper }]", true)]
    public async Task Check_PlantWithObjectsOrSignals_ExpectsJointsOnlyIfConfigured(string entries, bool expectsJoints)
    {
        var path = Write($"plant: {{ kind: mqtt, endpoint: mqtt://127.0.0.1 }}\n{entries}\n");

        var plants = await AdapterProcesses.CheckAsync([path], Gateways.Options(), default);

        Assert.That(plants.Single().HasObjects);
        Assert.That(PlantFile.ExpectsJoints(plants, null), Is.EqualTo(expectsJoints));
    }

    [TestCase("")]
    [TestCase("name cell")]
    [TestCase("{}")]
    [TestCase("null")]
    [TestCase("{\"name\":\"cell\"}")]
    public void Check_ResultInUnknownFormat_IsRefused(string line) => Assert.That(
        () => AdapterProgram.PlantContent.Read("press.yaml", line),
        Throws.TypeOf<InputException>().With.Message.StartsWith("press.yaml: the adapter's result for this file cannot be read"));

    [Test]
    public void Check_UnencryptedGatewayOnALanAddress_IsRefused()
    {
        var options = Gateways.Options() with { Bind = System.Net.IPAddress.Parse("192.168.1.5"), AllowInsecureLan = true };

        var wrong = Assert.ThrowsAsync<InputException>(() => AdapterProcesses.CheckAsync([Write(Good)], options, default));

        Assert.That(wrong.Message, Does.StartWith("--plant with --bind 192.168.1.5 and no --tls"));
    }

    string Write(string text, string name = "plant.yaml")
    {
        var path = Path.Combine(_folder.Path, name);
        File.WriteAllText(path, text);
        return path;
    }

    static PlantFile Plant(string path) => new(path, "absent", "");

    static StatusEvent EventOf(GatewayServer gateway) =>
        gateway.Events.Read().SingleOrDefault(one => one.Condition is { Kind: "adapter", What: "does not report" });

    static IDisposable ListenTo(GatewayServer gateway, TaskCompletionSource<DiagnosticsMessage> received) =>
        gateway.Hub.Subscribe(RosTopics.Diagnostics, message =>
        {
            var text = System.Text.Encoding.UTF8.GetString(message.Utf8(RosTimeForm.Sec).Span);
            if (RosbridgeReader.TryRead(text, out var read, out _)) received.TrySetResult(read.Diagnostics);
        });

    // Returns the id of the first node process with this parent.
    static int? ChildOf(int parent) => Process.GetProcessesByName("node").FirstOrDefault(process => ParentOf(process.Id) == parent)?.Id;

    static int? ParentOf(int id)
    {
        try
        {
            // In this file, the state and the parent's id follow the name in brackets.
            var stat = File.ReadAllText($"/proc/{id}/stat");
            return int.Parse(stat[(stat.LastIndexOf(')') + 2)..].Split(' ')[1]);
        }
        catch (IOException)
        {
            return null;
        }
    }
}
