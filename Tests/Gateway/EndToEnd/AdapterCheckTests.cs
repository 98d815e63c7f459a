using NUnit.Framework;
using Nowpose.Gateway;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Options;
using Nowpose.Gateway.Plants;

namespace Nowpose.Headless.Tests.Gateway.EndToEnd;

public class AdapterCheckTests : PlantFileFixture
{
    /// <summary>Name of a variable for two plants. No other test has plants with their names.</summary>
    const string PasswordVariable = "NOWPOSE_PLANT_PASSWORD_CHECKED_PRESS_3";

    [TearDown]
    public void RemovePassword() => Environment.SetEnvironmentVariable(PasswordVariable, null);

    [Test]
    public void Check_FilesWithInvalidEntries_ReportsEachInvalidLine()
    {
        var first = Write(Good.Replace("kind: opcua", "kind: opcua\n  sampling_msec: 10"), "first.yaml");
        var second = Write(Good.Replace("node:", "nod:"), "second.yaml");

        var wrong = Assert.ThrowsAsync<WrongEntriesException>(() => AdapterProcesses.CheckAsync([first, second], default));

        Assert.That(wrong.Lines, Has.Some.Contains($"{first}, line 3").And.Some.Contains("sampling_ms"));
        Assert.That(wrong.Lines, Has.Some.Contains($"{second}, line 7"));
    }

    [Test]
    public void Check_TwoPlantsWithTheSameName_IsRefused()
    {
        var (first, second) = (Write(Good, "first.yaml"), Write(Good, "second.yaml"));

        var wrong = Assert.ThrowsAsync<WrongEntriesException>(() => AdapterProcesses.CheckAsync([first, second], default));

        Assert.That(wrong.Lines, Is.EqualTo(new[]
        {
            AdapterMessages.SameName(second, "absent", first),
        }));
    }

    [TestCase(true)]
    [TestCase(false)]
    public async Task Check_NamesThatDifferOnlyInPunctuation_AreRefusedIfBothHaveAPasswordVariable(bool isRefused)
    {
        Environment.SetEnvironmentVariable(PasswordVariable, "secret");
        string Plant(string name, bool hasUser) => Write(
            Good.Replace("name: absent", $"name: {name}{(hasUser ? "\n  user: { name: reader }" : "")}"), name + ".yaml");
        var (first, second) = (Plant("checked-press-3", hasUser: true), Plant("checked_press_3", isRefused));

        if (!isRefused)
        {
            Assert.That(await AdapterProcesses.CheckAsync([first, second], default), Has.Count.EqualTo(2));
            return;
        }

        var wrong = Assert.ThrowsAsync<WrongEntriesException>(() => AdapterProcesses.CheckAsync([first, second], default));
        Assert.That(wrong.Lines, Is.EqualTo(new[] { AdapterMessages.SamePassword(second, PasswordVariable, first) }));
    }

    [TestCase("ads://PLC/1.2.3.4.1.1:852", true, true)]
    [TestCase("ads://plc-2/1.2.3.4.1.1:851", true, false)]
    [TestCase("ads://127.0.0.1/1.2.3.4.1.1:851", false, false)]
    public async Task Check_SecondConnectionToAPlc_IsRefused(string endpoint, bool isDirect, bool isRefused)
    {
        string Ads(string name, string endpoint, bool isDirect) => Write(
            $"plant:\n  kind: ads\n  name: {name}\n  endpoint: {endpoint}\n  plain: true\n{(isDirect ? "  local_net_id: 1.2.3.5.1.1\n" : "")}"
                + "joints: [{ joint: a, symbol: a }]\n", name + ".yaml");
        var (first, second) = (Ads("first", "ads://plc/1.2.3.4.1.1:851", true), Ads("second", endpoint, isDirect));

        if (!isRefused)
        {
            Assert.That(await AdapterProcesses.CheckAsync([first, second], default), Has.Count.EqualTo(2));
            return;
        }

        var wrong = Assert.ThrowsAsync<WrongEntriesException>(() => AdapterProcesses.CheckAsync([first, second], default));
        Assert.That(wrong.Lines, Is.EqualTo(new[] { AdapterMessages.SecondConnection(second, "plc", first) }));
    }

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
        string[] missing = ["arm_joint_2", "arm_joint_3", "arm_joint_4", "arm_joint_5"];
        var named = "missing_joints " + DryRunMessages.MissingJoints(hasJoints ? missing[1..] : missing);
        Assert.That(line, Is.EqualTo(isNamed ? named : null));
    }

    [Test]
    public void Check_InvalidRobotDescriptions_NamesTheEntryAndTheFaultOfEach()
    {
        const string Xacro = "<robot name=\"r\"><link name=\"a\"/><link name=\"b\"/>\n<joint name=\"j\" type=\"fixed\"><parent link=\"a\"/><child link=\"b\"/>"
            + "<origin rpy=\"0 0 ${pi/2}\"/></joint></robot>";
        Write(Xacro, "xacro.urdf");
        Write(RobotFiles.LoadText("ur5") + "<", "damaged.urdf");
        var path = Write(Good.Replace("joint: a", "joint: arm2/elbow_joint") + "\nrobot: xacro.urdf\nrobots: { arm1: damaged.urdf, arm2: ur5 }\n");

        var wrong = Assert.ThrowsAsync<WrongEntriesException>(() => AdapterProcesses.CheckAsync([path], default));

        Assert.That(wrong.Lines, Has.Count.EqualTo(2));
        Assert.That(wrong.Lines, Has.One.Matches($"^{path}, line 8: robot: xacro.urdf:2: .*rpy").And.One.Matches($"^{path}, line 9: robots.arm1: damaged.urdf:[0-9]+: "));
    }

    [Test]
    public async Task Check_PlantWithRobot_ListsTheMissingJointsOfThatRobot()
    {
        var path = Write(Good.Replace("joint: a", "joint: shoulder_pan_joint") + "\nrobot: ur5\n");

        var plants = await AdapterProcesses.CheckAsync([path], default);

        Assert.That(PlantFile.MissingJoints(plants, null), Is.EquivalentTo(
            new[] { "shoulder_lift_joint", "elbow_joint", "wrist_1_joint", "wrist_2_joint", "wrist_3_joint" }));
    }

    [Test]
    public async Task Check_RobotsInNamespaces_ListsTheMissingJointsOfRobotsWithConfiguredJoints()
    {
        var path = Write(Good.Replace("joint: a", "joint: arm1/shoulder_pan_joint") + "\nrobots: { arm1: ur5e, arm2: ur5e }\n");

        var plants = await AdapterProcesses.CheckAsync([path], default);

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

    [Test]
    public async Task Check_NamesInTwoFiles_PrintsAWarningForEach()
    {
        const string Cell = """
            plant: { name: NAME, kind: mqtt, endpoint: mqtt://127.0.0.1 }
            joints: [{ joint: a, topic: a }, { joint: NAME_only, topic: b }]
            frames: [{ frame: part, position: { unit: m, x: { topic: part }, y: 0, z: 0 } }]
            signals: [{ signal: closed, topic: gripper }]

            """;
        var (first, second) = (Write(Cell.Replace("NAME", "one"), "first.yaml"), Write(Cell.Replace("NAME", "two"), "second.yaml"));

        var (status, output, errors) = await CapturedConsole.OfAsync(() => Nowpose.Gateway.CommandLine.RunAsync(
            ["serve", "--check", "--plant", first, "--plant", second, "--ws-port", "0", "--sync-port", "0"]).Bounded());

        Assert.That(status, Is.Zero, errors);
        Assert.That(
            CapturedConsole.Lines(output).Where(line => line.StartsWith("warning ", StringComparison.Ordinal)),
            Is.EqualTo(new[] { ("joint", "a"), ("frame", "part"), ("signal", "closed") }
                .Select(one => "warning " + DryRunMessages.PublishedTwice(second, one.Item1, one.Item2, first))));
    }

    [Test]
    public async Task Check_ClockThatNoPlantOffers_PrintsAWarning()
    {
        var opcua = Write(Good, "opcua.yaml");
        var mqtt = Write("plant: { name: cell, kind: mqtt, endpoint: mqtt://127.0.0.1 }\njoints: [{ joint: b, topic: b }]\n", "mqtt.yaml");

        var (status, output, errors) = await CapturedConsole.OfAsync(() => Nowpose.Gateway.CommandLine.RunAsync(
            ["serve", "--check", "--clock", "cell", "--plant", opcua, "--plant", mqtt, "--ws-port", "0", "--sync-port", "0"]).Bounded());

        Assert.That(status, Is.Zero, errors);
        Assert.That(CapturedConsole.Lines(output), Has.One.EqualTo("warning " + DryRunMessages.ClockNotOffered("cell", ["absent"])));
    }

    [TestCase(null, 1, 0)]
    [TestCase(null, 2, 1)]
    [TestCase("plc-0", 2, 0)]
    [TestCase("own", 2, 0)]
    [TestCase("plc", 2, 1)]
    [TestCase("plc", 0, 0)]
    public void Warnings_SelectedClock_AreGivenIfItIsNotOfferedOrIfSeveralAre(string clock, int plants, int expected)
    {
        PlantFile[] all = [.. Enumerable.Range(0, plants).Select(i => new PlantFile($"{i}.yaml", $"plc-{i}", ""))];

        Assert.That(PlantFile.WarningsOf(all, clock).Count(), Is.EqualTo(expected));
    }

    [TestCase(256, 256, 16, new string[0])]
    [TestCase(257, 257, 17, new[] { "frames", "signals", "namespaces" })]
    public void Conflicts_FilesTogetherBeyondTheLimits_AreListed(int frames, int signals, int robots, string[] expected)
    {
        PlantFile Half(string name, int part) => new($"{name}.yaml", name, "")
        {
            Joints = [.. Names("arm", robots, part).Select(robot => robot + "/a")],
            Frames = Names("frame", frames, part).ToDictionary(frame => frame, _ => Array.Empty<string>()),
            Signals = [.. Names("signal", signals, part)],
        };

        var count = new Dictionary<string, (int, int)> { ["frames"] = (frames, 256), ["signals"] = (signals, 256), ["namespaces"] = (robots, 16) };
        Assert.That(
            PlantConflicts.Of([Half("one", 0), Half("two", 1)]),
            Is.EqualTo(expected.Select(what => DryRunMessages.TooMany(what, count[what].Item1, count[what].Item2))));
    }

    static IEnumerable<string> Names(string kind, int count, int part) => Enumerable.Range(0, count).Where(i => i % 2 == part).Select(i => $"{kind}{i}");

    [Test]
    public async Task Check_ParentsOfFrames_ListsThoseThatTheFilesDoNotHave()
    {
        string[] parents = ["convyor", "world", "conveyor", "fixture", "tool0", "arm2/tool0", "arm3/tool0", "tool9"];
        const string Objects = """
            plant: { kind: mqtt, endpoint: mqtt://127.0.0.1 }
            robots: { arm2: ur5e }
            frames:
              - { frame: conveyor, position: { unit: m, x: { topic: x }, y: 0, z: 0 } }

            """;
        var plant = Write(Good.Replace("joint: a", "joint: shoulder_pan_joint") + "\nrobot: ur5\nframes:\n" + string.Concat(parents.Select((parent, i) =>
            $"  - {{ frame: part{i}, parent: {parent}, position: {{ unit: m, x: {{ node: i=1 }}, y: 0, z: 0 }} }}\n")));
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
        Assert.That(line, Is.EqualTo(
            "missing_parents " + DryRunMessages.MissingParents([("convyor", "part0"), ("arm3/tool0", "part6"), ("tool9", "part7")])));
    }

    /// <summary>The description is longer than the buffer of a pipe, so it could be truncated when the adapter's process exits.</summary>
    [Test]
    public async Task Check_LongRobotDescription_ArrivesCompletely()
    {
        var urdf = RobotFiles.LoadText("youbot").Replace("</robot>", $"<!-- {new string('x', 800_000)} --></robot>");
        Write(urdf, "long.urdf");
        var path = Write(Good.Replace("joint: a", "joint: arm_joint_1") + "\nrobot: long.urdf\n");

        var plants = await AdapterProcesses.CheckAsync([path], default);

        Assert.That(plants.Single().Robot, Has.Length.EqualTo(urdf.Length));
    }

    [TestCase("frames: [{ frame: part, position: { unit: m, x: { topic: part }, y: 0, z: 0 } }]", false)]
    [TestCase("signals: [{ signal: closed, topic: gripper }]", false)]
    [TestCase("joints: [{ joint: a, topic: a }]\nsignals: [{ signal: closed, topic: gripper }]", true)]
    public async Task Check_PlantWithObjectsOrSignals_ExpectsJointsOnlyIfConfigured(string entries, bool expectsJoints)
    {
        var path = Write($"plant: {{ kind: mqtt, endpoint: mqtt://127.0.0.1 }}\n{entries}\n");

        var plants = await AdapterProcesses.CheckAsync([path], default);

        Assert.That(plants.Single().HasObjects);
        Assert.That(PlantFile.ExpectsJoints(plants, null), Is.EqualTo(expectsJoints));
    }

    [TestCase("")]
    [TestCase("name cell")]
    [TestCase("{}")]
    [TestCase("null")]
    [TestCase("{\"name\":\"cell\"}")]
    public void Check_ResultInUnknownFormat_IsRefused(string line) => Assert.That(
        () => AdapterProgram.Read("press.yaml", "", line),
        Throws.TypeOf<InputException>().With.Message.EqualTo(AdapterMessages.CheckUnreadable("press.yaml")));

    [Test]
    public void Check_UnencryptedGatewayOnALanAddress_IsRefused()
    {
        var options = Gateways.Options() with { Bind = System.Net.IPAddress.Parse("192.168.1.5"), AllowInsecureLan = true };

        var wrong = Assert.Throws<InputException>(() => AdapterProcesses.CheckAddress([Write(Good)], options, encrypts: false));

        Assert.That(wrong.Message, Is.EqualTo(AdapterMessages.NoTls(options.Bind)));
    }
}
