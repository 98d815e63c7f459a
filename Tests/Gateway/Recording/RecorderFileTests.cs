using System.Diagnostics;
using Nowpose.Cli.Replay;
using Nowpose.Gateway;
using Nowpose.Gateway.Plants;
using Nowpose.Gateway.Recording;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using NUnit.Framework;
using static Nowpose.Headless.Tests.Gateway.Recording.RecorderCell;

namespace Nowpose.Headless.Tests.Gateway.Recording;

/// <summary>Tests how a recording is divided into files.</summary>
public class RecorderFileTests
{
    RecorderCell _cell;

    [SetUp]
    public void SetUp() => _cell = new RecorderCell();

    [TearDown]
    public void TearDown() => _cell.Dispose();

    [Test]
    public async Task Describe_WhileAFileIsCreated_DoesNotWait()
    {
        using var isBeginning = new ManualResetEventSlim();
        using var mayGoOn = new ManualResetEventSlim();
        var options = new GatewayOptions { Recordings = _cell.Folder };
        await using var recorder = new Recorder(options, _cell.Hub, _cell.Clock, _cell.Plant, _cell.Drops, line =>
        {
            // Simulates a slow log or disk while the recorder holds its lock.
            if (isBeginning.IsSet) return;
            isBeginning.Set();
            mayGoOn.Wait(Soon.Limit);
        });
        var switching = Task.Run(recorder.SwitchOn);
        Assert.That(isBeginning.Wait(Soon.Limit), Is.True);

        var describing = Task.Run(() => _cell.Source.Describe(RobotFiles.LoadText("youbot")));

        var first = await Task.WhenAny(describing, Task.Delay(Soon.Limit / 2));
        mayGoOn.Set();
        await Task.WhenAll(describing, switching).Bounded();
        Assert.That(first, Is.SameAs(describing), "the hub holds its lock during the description, so this must not wait");
        await Soon.BecomesAsync(() => _cell.Files().Length == 2, "the robot came too late for the first file");
        await recorder.SwitchOffAsync().Bounded();
        Assert.That(File.ReadAllText(recorder.Path), Does.Contain("arm_joint_1"));
    }

    [Test]
    public async Task Record_AnotherRobot_StartsAnotherFileWithoutLoss()
    {
        _cell.Source.Describe(RobotFiles.LoadText("youbot"));
        await using var recorder = _cell.Open();
        recorder.SwitchOn();
        _cell.Publish(50, "a");
        _cell.Source.Describe(RobotFiles.LoadText("ur5"));
        await Soon.BecomesAsync(() => _cell.Files().Length == 2, "the second file");
        _cell.Publish(50, "a");
        await recorder.SwitchOffAsync().Bounded();

        var files = _cell.Files().Select(Lines).ToArray();
        Assert.That(files.Sum(lines => Count(lines, "sample")), Is.EqualTo(100));
        Assert.That(files.Select(lines => lines[0].GetProperty("robot").GetProperty("description_sha256").GetString()), Is.Unique);
        Assert.That(files.Select(lines => lines[^1].GetProperty("kind").GetString()), Is.All.EqualTo("end"));
        Assert.That(recorder.Status.Lines, Is.EqualTo(files.Sum(lines => lines.Length - 2)));
        Assert.That(recorder.Status.Lost, Is.Zero);
    }

    [Test]
    public async Task Record_RobotsInNamespaces_AreDescribedInTheHeader()
    {
        _cell.Source.Describe(RobotFiles.LoadText("youbot"));
        _cell.Source.Describe(RobotFiles.LoadText("ur5"), "arm1");
        await using var recorder = _cell.Open();
        recorder.SwitchOn();
        _cell.Source.Describe(RobotFiles.LoadText("ur5"), "arm1");
        _cell.Source.Publish(new JointStateMessage(_cell.Clock.Now, ["elbow_joint"], [1]), null, "arm1");
        await recorder.SwitchOffAsync().Bounded();

        var file = _cell.Files().Single();
        var other = Lines(file)[0].GetProperty("robots").EnumerateArray().Single();
        Assert.That(other.GetProperty("namespace").GetString(), Is.EqualTo("arm1"));
        Assert.That(other.GetProperty("joints").EnumerateArray().Select(joint => joint.GetProperty("name").GetString()), Does.Contain("elbow_joint"));
        var session = RecordedSession.Read(file);
        var joints = session.Header.Joints;
        Assert.That(joints.Select(joint => joint.Name), Does.Contain("arm_joint_1").And.Contain("arm1/elbow_joint"));
        Assert.That(joints.Single(joint => joint.Name == "arm1/elbow_joint").Limits.Velocity, Is.EqualTo(Math.PI).Within(0.01));
        Assert.That(session.ValuesOf(session.Events.Single(one => one.Kind == RecordedSession.EventKind.Sample)).Length, Is.EqualTo(1));
    }

    [Test]
    public async Task Record_DescriptionOfARobotInANamespaceChanges_StartsAnotherFile()
    {
        await using var recorder = _cell.Open();
        recorder.SwitchOn();
        _cell.Source.Describe(RobotFiles.LoadText("ur5"), "arm1");
        await Soon.BecomesAsync(() => _cell.Files().Length == 2, "the second file");
        await recorder.SwitchOffAsync().Bounded();

        Assert.That(_cell.Files().Select(file => Lines(file)[0].GetProperty("robots").GetArrayLength()).Order(), Is.EqualTo(new[] { 0, 1 }));
    }

    [Test]
    public async Task SwitchOn_Twice_CreatesTwoFiles()
    {
        await using var recorder = _cell.Open();
        for (var i = 0; i < 2; i++)
        {
            recorder.SwitchOn();
            recorder.SwitchOn();
            _cell.Publish(3, "a");
            await recorder.SwitchOffAsync().Bounded();
        }

        Assert.That(_cell.Files().Select(file => Count(Lines(file), "sample")), Is.EqualTo(new[] { 3, 3 }));
    }

    [Test]
    public async Task Record_ThreeFilesWithinASecondOnASlowDisk_HaveUniqueNames()
    {
        using var goOn = new ManualResetEventSlim();
        await using var recorder = _cell.Open(path =>
        {
            goOn.Wait();
            return LineFile.Create(path);
        }, new SteppedTime());
        recorder.SwitchOn();
        foreach (var robot in new[] { "youbot", "ur5" })
        {
            var former = recorder.Path;
            _cell.Source.Describe(RobotFiles.LoadText(robot));
            await Soon.BecomesAsync(() => recorder.Path != former, "the next file");
        }

        goOn.Set();
        _cell.Publish(3, "a");
        await recorder.SwitchOffAsync().Bounded();

        Assert.That(recorder.Status.Problem, Is.Null);
        Assert.That(_cell.Files(), Has.Length.EqualTo(3));
        Assert.That(_cell.Files().Select(file => Lines(file)[^1].GetProperty("kind").GetString()), Is.All.EqualTo("end"));
    }

    [Test]
    public async Task Record_MaximumSizeReached_StartsAnotherFileWithoutLoss()
    {
        await using var recorder = _cell.Open(maxBytes: 20_000);
        recorder.SwitchOn();
        var published = 0;
        await Soon.BecomesAsync(() =>
        {
            _cell.Publish(10, "a");
            published += 10;
            return _cell.Files().Length >= 3;
        }, "the third file");
        await recorder.SwitchOffAsync().Bounded();

        Assert.That(_cell.Files().Sum(file => Count(Lines(file), "sample")), Is.EqualTo(published));
        Assert.That(recorder.Status.Lost, Is.Zero);
        Assert.That(recorder.Status.Files, Is.EqualTo(_cell.Files().Length));
        Assert.That(recorder.Status.Bytes, Is.EqualTo(_cell.Files().Sum(file => new FileInfo(file).Length)));
    }

    [Test]
    public async Task Record_ObjectsSignalsAndRobots_WritesThemToTheFile()
    {
        var stamp = _cell.Clock.Now;
        var received = Stopwatch.GetTimestamp();
        _cell.Source.Publish(new TransformsMessage(new FrameTransform(default, "world", "table", 1, 2, 3, 0, 0, 0, 1)), true, [], received);
        await using var recorder = _cell.Open();
        recorder.SwitchOn();
        _cell.Source.Publish(new TransformsMessage(new FrameTransform(stamp, "table", "part", 0.1, 0.2, 0.3, 0, 0.6, 0, 0.8)), false, [], received);
        _cell.Source.Publish(new SignalsMessage(stamp, new SignalValue("closed", 1)), [], received);
        _cell.Source.Publish(new JointStateMessage(stamp, ["a"], [1]), received, "arm1");
        await recorder.SwitchOffAsync().Bounded();

        var lines = Lines(recorder.Path);
        var poses = lines.Where(line => line.GetProperty("kind").GetString() == "pose").ToArray();
        Assert.That(poses.Select(pose => pose.GetProperty("frame").GetString()), Is.EqualTo(new[] { "table", "part" }), "the file contains the poses published before and after its start");
        Assert.That(poses[0].GetProperty("stationary").GetBoolean(), Is.True);
        Assert.That(poses[1].GetProperty("stamp_ns").GetInt64(), Is.EqualTo(stamp.Nanoseconds));
        Assert.That(poses[1].GetProperty("control_arrival_ns").GetInt64(), Is.GreaterThanOrEqualTo(stamp.Nanoseconds));
        var signal = lines.Single(line => line.GetProperty("kind").GetString() == "signal");
        Assert.That((signal.GetProperty("name").GetString(), signal.GetProperty("value").GetDouble()), Is.EqualTo(("closed", 1.0)));
        var sample = lines.Single(line => line.GetProperty("kind").GetString() == "sample");
        Assert.That(sample.GetProperty("names")[0].GetString(), Is.EqualTo("arm1/a"));
    }

    [TestCase("", "a")]
    [TestCase("arm1", "arm1/a")]
    public async Task Record_SetPointsSentBeforeTheStart_WritesTheNewestOfEachFile(string robot, string joint)
    {
        foreach (var position in new[] { 0.25, 0.5 })
            _cell.Source.Publish(new JointTrajectoryMessage(_cell.Clock.Now, ["a"], [new JointTrajectoryPoint(TimeSpan.Zero, [position])]), null, robot);
        await using var recorder = _cell.Open();
        for (var i = 0; i < 2; i++)
        {
            recorder.SwitchOn();
            await recorder.SwitchOffAsync().Bounded();

            var plan = Lines(recorder.Path).Single(line => line.GetProperty("kind").GetString() == "plan");
            Assert.That((plan.GetProperty("names")[0].GetString(), plan.GetProperty("points")[0].GetProperty("position")[0].GetDouble()), Is.EqualTo((joint, 0.5)));
        }
    }
}
