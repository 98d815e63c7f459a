using System.Diagnostics;
using System.Text.Json;
using Nowpose.Gateway;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Plants;
using Nowpose.Gateway.Recording;
using Nowpose.Headless.Tests.Cli;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Recording;

/// <summary>The gateway's recording of the messages that it forwards, and its use by other programs.</summary>
public class RecorderTests
{
    const double StepSeconds = 0.05;

    readonly List<string> _log = [];
    MessageHub _hub;
    DropCounters _drops;
    string _folder;
    PlantClocks _plant;
    ServedClock _clock;
    HubSource _source;

    [SetUp]
    public void SetUp()
    {
        _folder = Directory.CreateTempSubdirectory("nowpose-recordings-").FullName;
        _hub = new MessageHub();
        _drops = new DropCounters();
        _plant = new PlantClocks(null, new StopwatchHeadsetClock());
        _clock = new ServedClock(new StopwatchControlClock(Gateways.Start), _plant);
        _source = _hub.OpenSource();
        _log.Clear();
    }

    [TearDown]
    public void TearDown()
    {
        _source.Dispose();
        Directory.Delete(_folder, true);
    }

    Recorder Open(Func<string, LineFile> open = null, TimeProvider time = null, long maxBytes = RecordedFile.MaxBytes) => new(
        new GatewayOptions { Recordings = _folder, Cell = "press 1", Time = time ?? TimeProvider.System }, _hub, _clock, _plant, _drops,
        line => { lock (_log) _log.Add(line); }, open, maxBytes);

    /// <summary>Publishes samples as if they came in over the last seconds, each 80 ms old when received.</summary>
    void Publish(int count, params string[] names)
    {
        for (var i = 0; i < count; i++)
        {
            var ago = TimeSpan.FromSeconds((count - i) * StepSeconds);
            var received = Stopwatch.GetTimestamp() - (long)(ago.TotalSeconds * Stopwatch.Frequency);
            var position = 1.5 + 0.5 * Math.Sin(2 * Math.PI * 0.4 * i * StepSeconds);
            var stamp = _clock.Now - ago - TimeSpan.FromMilliseconds(80);
            Assert.That(_source.TryPublish(new JointStateMessage(stamp, names, [.. names.Select(_ => position)]), received), Is.Null);
        }
    }

    static JsonElement[] Lines(string path) => [.. File.ReadAllLines(path).Select(line => JsonDocument.Parse(line).RootElement)];

    static int Count(IEnumerable<JsonElement> lines, string kind) => lines.Count(line => line.GetProperty("kind").GetString() == kind);

    string[] Files() => [.. Directory.GetFiles(_folder).Order(StringComparer.Ordinal)];

    [Test]
    public async Task Record_TrafficOfADescribedRobot_IsReplayedRecommendedAndSynchronised()
    {
        _source.TryDescribe(RobotFiles.LoadText("youbot"));
        await using var recorder = Open();
        recorder.SwitchOn();
        Publish(400, "arm_joint_1", "arm_joint_2");
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
    public async Task Describe_WhileAFileIsCreated_DoesNotWait()
    {
        using var isBeginning = new ManualResetEventSlim();
        using var mayGoOn = new ManualResetEventSlim();
        await using var recorder = new Recorder(new GatewayOptions { Recordings = _folder }, _hub, _clock, _plant, _drops, line =>
        {
            // Simulates a slow log or disk, during which its lock is held.
            if (isBeginning.IsSet) return;
            isBeginning.Set();
            mayGoOn.Wait(Soon.Limit);
        });
        var switching = Task.Run(recorder.SwitchOn);
        Assert.That(isBeginning.Wait(Soon.Limit), Is.True);

        var describing = Task.Run(() => _source.TryDescribe(RobotFiles.LoadText("youbot")));

        var first = await Task.WhenAny(describing, Task.Delay(Soon.Limit / 2));
        mayGoOn.Set();
        await Task.WhenAll(describing, switching).Bounded();
        Assert.That(first, Is.SameAs(describing), "the hub's lock is held as long");
        await Soon.BecomesAsync(() => Files().Length == 2, "the robot came too late for the first file");
        await recorder.SwitchOffAsync().Bounded();
        Assert.That(File.ReadAllText(recorder.Path), Does.Contain("arm_joint_1"));
    }

    [Test]
    public async Task Record_WithoutADescription_IsReplayedWithTheReceivedJoints()
    {
        await using var recorder = Open();
        recorder.SwitchOn();
        Publish(100, "a", "b");
        await recorder.SwitchOffAsync().Bounded();

        var replay = await CliRun.OfAsync("replay", recorder.Path, "--json").Bounded();

        Assert.That(replay.ExitStatus, Is.EqualTo(0), replay.Errors);
        var axes = JsonDocument.Parse(replay.Output).RootElement.GetProperty("axes").EnumerateArray().Select(axis => axis.GetProperty("name").GetString());
        Assert.That(axes, Is.EqualTo(new[] { "a", "b" }));
    }

    [Test]
    public async Task Record_AllMessages_AreInTheFileInOrder()
    {
        await using var recorder = Open();
        recorder.SwitchOn();
        for (var i = 0; i < 3000; i++)
        {
            _source.TryPublish(new JointStateMessage(Gateways.Start, ["a"], [i]));
            if (i % 1000 == 0) await Task.Yield();
        }
        _source.TryPublish(new JointTrajectoryMessage(Gateways.Start, ["a"], [new JointTrajectoryPoint(TimeSpan.Zero, [0.25])]));
        _source.Publish(new DiagnosticsMessage(Gateways.Start, "goggles", [KeyValuePair.Create("rtt_ms", "3"), KeyValuePair.Create("say \"so\"", "\n")]));
        _drops.Count(DropReason.NotJson);
        await Soon.BecomesAsync(() => HasDrops(recorder.Path), "the drops of this second");
        await recorder.SwitchOffAsync().Bounded();

        var lines = Lines(recorder.Path);
        var samples = lines.Where(line => line.GetProperty("kind").GetString() == "sample").ToArray();
        Assert.That(samples.Select(line => line.GetProperty("position")[0].GetDouble()), Is.EqualTo(Enumerable.Range(0, 3000)));
        Assert.That(lines[0].GetProperty("recorded_by").GetString(), Is.EqualTo("gateway"));
        Assert.That(Count(lines, "plan"), Is.EqualTo(1));
        var said = lines.Single(line => line.GetProperty("kind").GetString() == "diagnostics");
        Assert.That(said.GetProperty("name").GetString(), Is.EqualTo("goggles"));
        Assert.That(said.GetProperty("values").GetProperty("say \"so\"").GetString(), Is.EqualTo("\n"));
        Assert.That(lines[^1].GetProperty("reason").GetString(), Is.EqualTo("closed"));
        Assert.That(recorder.Status.Lost, Is.Zero);
        Assert.That(recorder.Status.Lines, Is.EqualTo(lines.Length - 2), "all but the header and the end");
    }

    int CountLogged(string text)
    {
        lock (_log) return _log.Count(line => line.Contains(text));
    }

    static bool HasDrops(string path)
    {
        // The recorder's own thread creates the file.
        if (!File.Exists(path)) return false;
        using var reader = new StreamReader(new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite));
        return reader.ReadToEnd().Contains("\"drops\"");
    }

    [Test]
    public async Task Record_AnotherRobot_StartsAnotherFileWithoutLoss()
    {
        _source.TryDescribe(RobotFiles.LoadText("youbot"));
        await using var recorder = Open();
        recorder.SwitchOn();
        Publish(50, "a");
        _source.TryDescribe(RobotFiles.LoadText("ur5"));
        await Soon.BecomesAsync(() => Files().Length == 2, "the second file");
        Publish(50, "a");
        await recorder.SwitchOffAsync().Bounded();

        var files = Files().Select(Lines).ToArray();
        Assert.That(files.Sum(lines => Count(lines, "sample")), Is.EqualTo(100));
        Assert.That(files.Select(lines => lines[0].GetProperty("robot").GetProperty("description_sha256").GetString()), Is.Unique);
        Assert.That(files.Select(lines => lines[^1].GetProperty("kind").GetString()), Is.All.EqualTo("end"));
        Assert.That(recorder.Status.Lines, Is.EqualTo(files.Sum(lines => lines.Length - 2)));
        Assert.That(recorder.Status.Lost, Is.Zero);
    }

    [Test]
    public async Task SwitchOn_Twice_CreatesTwoFiles()
    {
        await using var recorder = Open();
        for (var i = 0; i < 2; i++)
        {
            recorder.SwitchOn();
            recorder.SwitchOn();
            Publish(3, "a");
            await recorder.SwitchOffAsync().Bounded();
        }

        Assert.That(Files().Select(file => Count(Lines(file), "sample")), Is.EqualTo(new[] { 3, 3 }));
    }

    [Test]
    public async Task Record_DiskFull_ReportsTheLossAndContinuesOnceThereIsSpace()
    {
        const int Published = 500;
        var disks = new Queue<SmallDisk>([new SmallDisk(20_000), new SmallDisk(10_000_000)]);
        var first = disks.Peek();
        await using var recorder = Open(_ => new LineFile(disks.Dequeue()));
        recorder.SwitchOn();
        Publish(Published, "a");
        await Soon.BecomesAsync(() => recorder.Status.Problem != null, "the failure");
        Publish(10, "a");
        await Soon.BecomesAsync(() => CountLogged("No space left") > 0, "the line in the log");

        var status = recorder.Status;
        Assert.That(status.On, Is.False);
        Assert.That(status.Problem, Does.Contain("No space left"));
        var kept = first.Text.Split('\n', StringSplitOptions.RemoveEmptyEntries);
        Assert.That(kept.Select(line => JsonDocument.Parse(line)), Is.All.Not.Null, "no torn line");
        Assert.That(status.Lines, Is.EqualTo(kept.Length - 1));
        Assert.That(status.Lines + status.Lost, Is.InRange(Published + 10, Published + 40), "samples, and a few lines a second of the clock");

        recorder.SwitchOn();
        Publish(10, "a");
        await recorder.SwitchOffAsync().Bounded();
        Assert.That(CountLogged("No space left"), Is.EqualTo(1), "said once");
        Assert.That(recorder.Status.Problem, Is.Null);
        Assert.That(recorder.Status.Lost, Is.Zero);
        Assert.That(recorder.Status.Lines, Is.GreaterThanOrEqualTo(10));
    }

    [Test]
    public async Task Record_FolderMissing_IsReportedAndContinuesOnceRestored()
    {
        await using var recorder = Open();
        Directory.Delete(_folder);
        recorder.SwitchOn();
        await Soon.BecomesAsync(() => recorder.Status.Problem != null, "the failure");
        Publish(5, "a");
        Assert.That(recorder.Status.Lost, Is.GreaterThanOrEqualTo(5));

        Directory.CreateDirectory(_folder);
        recorder.SwitchOn();
        Publish(5, "a");
        await recorder.SwitchOffAsync().Bounded();

        Assert.That(Count(Lines(Files().Single()), "sample"), Is.EqualTo(5));
    }

    [Test]
    public async Task Record_DiskHangs_DelaysNoMessagesAndCountsTheLoss()
    {
        using var goOn = new ManualResetEventSlim();
        await using var recorder = Open(path =>
        {
            goOn.Wait();
            return LineFile.Create(path);
        });
        recorder.SwitchOn();

        var since = Stopwatch.GetTimestamp();
        for (var i = 0; i < 20_000; i++) _source.TryPublish(new JointStateMessage(Gateways.Start, ["a"], [i]));
        var took = Stopwatch.GetElapsedTime(since);
        var lost = recorder.Status.Lost;
        goOn.Set();
        await recorder.SwitchOffAsync().Bounded();

        Assert.That(lost, Is.GreaterThan(10_000));
        Assert.That(took, Is.LessThan(TimeSpan.FromSeconds(5)), "writers are not blocked");
        var lines = Lines(recorder.Path);
        Assert.That(Count(lines, "sample") + lines.Where(line => line.GetProperty("kind").GetString() == "lost").Sum(line => line.GetProperty("count").GetInt64()),
            Is.InRange(20_000, 20_100));
        Assert.That(recorder.Status.Lost, Is.EqualTo(lost).Within(50));
    }

    [Test]
    public async Task Record_ThreeFilesWithinASecondOnASlowDisk_HaveUniqueNames()
    {
        using var goOn = new ManualResetEventSlim();
        await using var recorder = Open(path =>
        {
            goOn.Wait();
            return LineFile.Create(path);
        }, new SteppedTime());
        recorder.SwitchOn();
        foreach (var robot in new[] { "youbot", "ur5" })
        {
            var former = recorder.Path;
            _source.TryDescribe(RobotFiles.LoadText(robot));
            await Soon.BecomesAsync(() => recorder.Path != former, "the next file");
        }

        goOn.Set();
        Publish(3, "a");
        await recorder.SwitchOffAsync().Bounded();

        Assert.That(recorder.Status.Problem, Is.Null);
        Assert.That(Files(), Has.Length.EqualTo(3));
        Assert.That(Files().Select(file => Lines(file)[^1].GetProperty("kind").GetString()), Is.All.EqualTo("end"));
    }

    [Test]
    public async Task Record_BeyondTheMaximumSize_StartsAnotherFileWithoutLoss()
    {
        await using var recorder = Open(maxBytes: 20_000);
        recorder.SwitchOn();
        var published = 0;
        await Soon.BecomesAsync(() =>
        {
            Publish(10, "a");
            published += 10;
            return Files().Length >= 3;
        }, "the third file");
        await recorder.SwitchOffAsync().Bounded();

        Assert.That(Files().Sum(file => Count(Lines(file), "sample")), Is.EqualTo(published));
        Assert.That(recorder.Status.Lost, Is.Zero);
    }

    [Test]
    public async Task Record_DiskFailsBeyondTheMaximumSize_RequestsNoFurtherFile()
    {
        var time = new CountedTime();
        using var goOn = new ManualResetEventSlim();
        await using var recorder = Open(_ =>
        {
            goOn.Wait();
            return new LineFile(new SmallDisk(100_000));
        }, time, maxBytes: 80_000);
        recorder.SwitchOn();
        // More data than fits already waits, so that its maximum size is not reached before the disk fails.
        Publish(2000, "a");
        goOn.Set();
        await Soon.BecomesAsync(() => recorder.Status.Problem != null, "the disk is full");
        Publish(1, "a");
        await Soon.BecomesAsync(() => time.Asked == 2, "for the first file, and for one beyond the greatest size");

        Publish(2000, "a");
        // Waits behind all work items that these messages put into the pool's queue.
        var isTheirTurnOver = new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
        ThreadPool.UnsafeQueueUserWorkItem(_ => isTheirTurnOver.SetResult(), null);
        await isTheirTurnOver.Task.Bounded();

        Assert.That(time.Asked, Is.EqualTo(2));
    }

    [Test]
    public async Task SwitchOn_AfterADiskFailure_EndsTheFormerFile()
    {
        var first = new SmallDisk(10_000_000);
        var files = 0;
        await using var recorder = Open(_ => Interlocked.Increment(ref files) switch
        {
            1 => new LineFile(first),
            2 => throw new IOException("No space left on device"),
            _ => new LineFile(new SmallDisk(10_000_000)),
        });
        recorder.SwitchOn();
        // Each file is opened by its own thread. The second file must not be opened before the first.
        await Soon.BecomesAsync(() => Volatile.Read(ref files) == 1, "the first file is opened");
        Publish(5, "a");
        _source.TryDescribe(RobotFiles.LoadText("youbot"));
        await Soon.BecomesAsync(() => recorder.Status.Problem != null, "the second file fails");

        recorder.SwitchOn();

        await Soon.BecomesAsync(() => first.IsDisposed, "the first file ends");
        var lines = first.Text.Split('\n', StringSplitOptions.RemoveEmptyEntries);
        Assert.That(lines[^1], Does.Contain("\"end\""));
        Assert.That(lines.Count(line => line.Contains("\"sample\"")), Is.EqualTo(5));
        await recorder.SwitchOffAsync().Bounded();
        Assert.That(recorder.Status.Problem, Is.Null);
    }

    sealed class CountedTime : TimeProvider
    {
        int _asked;

        public int Asked => Volatile.Read(ref _asked);

        public override DateTimeOffset GetUtcNow()
        {
            Interlocked.Increment(ref _asked);
            return base.GetUtcNow();
        }
    }

    [Test]
    public void SwitchOn_WithoutAFolder_NamesTheOption()
    {
        var recorder = new Recorder(new GatewayOptions(), _hub, _clock, _plant, _drops, _ => { });

        Assert.That(recorder.SwitchOn, Throws.InstanceOf<InputException>().With.Message.Contains("--recordings"));
        Assert.That(recorder.Status.Can, Is.False);
    }
}
