using System.Text.Json;
using Nowpose.Gateway;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Plants;
using Nowpose.Gateway.Recording;
using Nowpose.Gateway.Status;
using Nowpose.Gateway.Status.Cell;
using Nowpose.Gateway.Status.Events;
using Nowpose.Protocol;
using NUnit.Framework;
using static Nowpose.Headless.Tests.Gateway.Recording.RecorderCell;

namespace Nowpose.Headless.Tests.Gateway.Recording;

/// <summary>Tests recordings to a disk that is full, slow or missing. The time stands still, so that the recorder adds no periodic lines.</summary>
public class RecorderDiskTests
{
    /// <summary>Number of lines about the clock at the start of a file.</summary>
    const int LinesAtStart = 2;

    RecorderCell _cell;

    [SetUp]
    public void SetUp() => _cell = new RecorderCell();

    [TearDown]
    public void TearDown() => _cell.Dispose();

    [Test]
    public async Task Record_DiskFull_ReportsTheLossAndContinuesOnceThereIsSpace()
    {
        const int Published = 500;
        var disks = new Queue<SmallDisk>([new SmallDisk(20_000), new SmallDisk(10_000_000)]);
        var first = disks.Peek();
        await using var recorder = _cell.Open(_ => new LineFile(disks.Dequeue()), new SteppedTimers());
        recorder.SwitchOn();
        _cell.Publish(Published, "a");
        await Soon.BecomesAsync(() => recorder.Status.Problem != null, "the failure");
        _cell.Publish(10, "a");
        await Soon.BecomesAsync(() => _cell.CountLogged("No space left") > 0, "the line in the log");

        var status = recorder.Status;
        Assert.That(status.On, Is.False);
        Assert.That(status.Problem, Does.Contain("No space left"));
        var kept = first.Text.Split('\n', StringSplitOptions.RemoveEmptyEntries);
        Assert.That(kept.Select(line => JsonDocument.Parse(line)), Is.All.Not.Null, "all lines are complete");
        Assert.That(status.Lines, Is.EqualTo(kept.Length - 1));
        Assert.That(status.Bytes, Is.EqualTo(first.Text.Length));
        Assert.That(status.Lines + status.Lost, Is.EqualTo(Published + 10 + LinesAtStart));

        recorder.SwitchOn();
        _cell.Publish(10, "a");
        await recorder.SwitchOffAsync().Bounded();
        Assert.That(_cell.CountLogged("No space left"), Is.EqualTo(1), "logged once");
        Assert.That(recorder.Status.Problem, Is.Null);
        Assert.That(recorder.Status.Lost, Is.Zero);
        Assert.That(recorder.Status.Lines, Is.GreaterThanOrEqualTo(10));
    }

    [Test]
    public async Task Record_FolderMissing_IsReportedAndContinuesOnceRestored()
    {
        await using var recorder = _cell.Open();
        Directory.Delete(_cell.Folder);
        recorder.SwitchOn();
        await Soon.BecomesAsync(() => recorder.Status.Problem != null, "the failure");
        _cell.Publish(5, "a");
        Assert.That(recorder.Status.Lost, Is.GreaterThanOrEqualTo(5));

        Directory.CreateDirectory(_cell.Folder);
        recorder.SwitchOn();
        _cell.Publish(5, "a");
        await recorder.SwitchOffAsync().Bounded();

        Assert.That(Count(Lines(_cell.Files().Single()), "sample"), Is.EqualTo(5));
    }

    [Test]
    public async Task Record_DiskHangs_DelaysNoMessagesAndCountsTheLoss()
    {
        using var goOn = new ManualResetEventSlim();
        await using var recorder = _cell.Open(path =>
        {
            goOn.Wait();
            return LineFile.Create(path);
        }, new SteppedTimers());
        recorder.SwitchOn();

        // A blocked publisher would never return, because the file opens only afterwards.
        await Task.Run(() =>
        {
            for (var i = 0; i < 20_000; i++) _cell.Source.Publish(new JointStateMessage(Gateways.Start, ["a"], [i]));
        }).Bounded();
        var lost = recorder.Status.Lost;
        goOn.Set();
        await recorder.SwitchOffAsync().Bounded();

        Assert.That(lost, Is.GreaterThan(10_000));
        var lines = Lines(recorder.Path);
        var noted = lines.Where(line => line.GetProperty("kind").GetString() == "lost").Sum(line => line.GetProperty("count").GetInt64());
        // The line about the clock at the end is lost too if the queue is still full.
        Assert.That(Count(lines, "sample") + noted, Is.InRange(20_000, 20_001));
        Assert.That(recorder.Status.Lost - lost, Is.InRange(0, 1));
    }

    [Test]
    public async Task Record_LinesAreMissing_IsAConditionWhileTheRecordingContinues()
    {
        using var goOn = new ManualResetEventSlim();
        await using var recorder = _cell.Open(path =>
        {
            goOn.Wait();
            return LineFile.Create(path);
        });
        var limits = new LimitAlarm(_cell.Hub, _ => { });
        var (time, reports) = (TimeProvider.System, new CellReports(TimeProvider.System));
        var refusals = new RefusalConditions(_cell.Hub, time);
        var conditions = new Conditions(
            new GatewayOptions(), _cell.Clock, new DiagnosticsBoard(time), refusals, new ConnectionLimits([], 1, time),
            reports, new CellBoard(time, reports), limits, recorder);
        Condition[] Present() => [.. conditions.Read([]).Where(one => one.Kind == "recording")];
        recorder.SwitchOn();
        var before = Present();

        for (var i = 0; i < 20_000; i++) _cell.Source.Publish(new JointStateMessage(Gateways.Start, ["a"], [i]));
        var during = Present();
        goOn.Set();
        await recorder.SwitchOffAsync().Bounded();

        Assert.That(before, Is.Empty);
        Assert.That(during.Select(one => (one.What, one.Level)), Is.EqualTo(new[] { (EventTexts.IsIncomplete, Level.Warning) }));
        Assert.That(Present(), Is.Empty);
    }

    [Test]
    public async Task Record_DiskFailsAfterTheFileExceededTheMaximumSize_RequestsOnlyOneFurtherFile()
    {
        var time = new CountedTime();
        using var goOn = new ManualResetEventSlim();
        await using var recorder = _cell.Open(_ =>
        {
            goOn.Wait();
            return new LineFile(new SmallDisk(100_000));
        }, time, maxBytes: 80_000);
        recorder.SwitchOn();
        // The recorder requests the next file when it receives a message. It receives all these messages before it starts to write the file, so it
        // receives none between exceeding the maximum size and the failure of the disk.
        _cell.Publish(2000, "a");
        goOn.Set();
        await Soon.BecomesAsync(() => recorder.Status.Problem != null, "the disk is full");
        _cell.Publish(1, "a");
        await Soon.BecomesAsync(() => time.Asked == 2, "the first file and a file after the maximum size");

        _cell.Publish(2000, "a");
        // Waits until the thread pool has executed all work items that were queued because of these messages.
        var isQueueDone = new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
        ThreadPool.UnsafeQueueUserWorkItem(_ => isQueueDone.SetResult(), null);
        await isQueueDone.Task.Bounded();

        Assert.That(time.Asked, Is.EqualTo(2));
    }

    [Test]
    public async Task SwitchOn_AfterADiskFailure_EndsThePreviousFile()
    {
        var first = new SmallDisk(10_000_000);
        var files = 0;
        await using var recorder = _cell.Open(_ => Interlocked.Increment(ref files) switch
        {
            1 => new LineFile(first),
            2 => throw new IOException("No space left on device"),
            _ => new LineFile(new SmallDisk(10_000_000)),
        });
        recorder.SwitchOn();
        // A separate thread opens each file. Waits for the first file, so that the second one is not opened before it.
        await Soon.BecomesAsync(() => Volatile.Read(ref files) == 1, "the first file is opened");
        _cell.Publish(5, "a");
        _cell.Source.Describe(RobotFiles.LoadText("youbot"));
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
}
