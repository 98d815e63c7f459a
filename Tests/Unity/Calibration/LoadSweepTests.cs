using Nowpose.Cli.Calibrate.Vlc;
using Nowpose.Latency;
using Nowpose.Latency.Conditions;
using Nowpose.Latency.Sweep;
using Nowpose.Messages;
using Nowpose.Unity.Messages;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Events;

namespace Nowpose.Unity.Tests.Calibration;

/// <summary>Tests the log and the verdict of a complete sweep.</summary>
public sealed class LoadSweepTests
{
    PlayedSweep _played;

    [SetUp]
    public void Begin() => _played = new PlayedSweep();

    [TearDown]
    public async Task End() => await _played.DisposeAsync();

    [TestCase(false)]
    [TestCase(true)]
    public async Task Log_SweepComplete_HasARowForEachCodeWithItsLoad(bool rewrites)
    {
        _played.Play(rewrites);
        var (onDone, done) = (new UnityEvent(), new List<LoadSensitivity>());
        onDone.AddListener(() => done.Add(_played.Sweep.Verdict));
        _played.Sweep.With("_onDone", onDone);
        _played.Run(5);
        _played.Sweep.StartSweep();
        var seen = new Dictionary<int, int>();

        _played.Run(5, seen: () =>
        {
            if (_played.Display.FrameStart is ControlTime start) seen[TimestampCode.ValueOf(start)] = _played.Load.VerticesShown;
        });
        await _played.Judged();

        var rows = SweepTable.Read(_played.Sweep.Path, out _);
        Assert.That(rows.Select(row => row.Vertices).Distinct(), Is.EquivalentTo(new[] { 0, 25_000, 50_000, 75_000, 100_000 }), "the frames in which a load is built are logged");
        foreach (var load in new[] { 0, 50_000 })
            Assert.That(rows.Count(row => row.Vertices == load), Is.InRange(2 * 36, 2 * 39), "0.6 s at 60 Hz, up and down");
        Assert.That(Gaps(rows), Is.Empty, "no frame is missing");
        foreach (var row in rows)
            Assert.That(seen.GetValueOrDefault(TimestampCode.ValueOf(row.FrameStart), -1), Is.EqualTo(row.Vertices), "by the code of " + row.FrameStart);
        Assert.That(rows, Has.All.Matches<SweepRow>(row => row.Source == RenderTimeSourceKind.DisplayGpuTime && row.RenderMs > 2));
        Assert.That(rows, Has.All.Matches<SweepRow>(row => row.Device == SystemInfo.deviceModel && row.DisplayHz == 60));
        Assert.That(done, Is.EqualTo(new[] { _played.Sweep.Verdict }).And.None.Null);
    }

    [Test]
    public async Task DisplayRate_ReportedDuringTheSweep_IsInTheRowsOfLaterLoads()
    {
        _played.Play();
        _played.Run(5);
        _played.Cell.Player.World.Gpu.DisplayHz = null;
        _played.Sweep.StartSweep();
        _played.Run(0.1);
        _played.Cell.Player.World.Gpu.DisplayHz = 72;

        _played.Run(5);
        await _played.Judged();

        var rows = SweepTable.Read(_played.Sweep.Path, out _);
        Assert.That(rows[0].DisplayHz, Is.NaN);
        Assert.That(rows.Where(row => row.Vertices > 0).Select(row => row.DisplayHz).Distinct(), Is.EqualTo(new[] { 72.0 }));
    }

    [Test]
    public async Task Log_SweepComplete_StartsWithTheConditions()
    {
        _played.Play(rewrites: true);
        _played.Session.Reprojection = ReprojectionMode.Depth;
        _played.Run(5);
        _played.Sweep.StartSweep();
        _played.Run(5);
        await _played.Judged();

        using var text = new StreamReader(_played.Sweep.Path);
        SweepLogReader.Read(text, "sweep.csv", out var conditions);

        Assert.That(conditions, Is.EqualTo(new DisplayConditions(
            graphicsApi: "Direct3D11", graphicsJobs: "MultiThreaded", renderPipeline: "built-in", rewritesBeforeRender: true,
            reprojection: ReprojectionMode.Depth)));
    }

    static IEnumerable<TimeSpan> Gaps(IReadOnlyList<SweepRow> rows) =>
        rows.Skip(1).Zip(rows, (b, a) => b.FrameStart - a.FrameStart).Where(gap => gap.TotalMilliseconds is < 10 or > 25);

    [Test]
    public async Task Sweep_GpuSource_ReportsTheResponseToLoadAndTheLog()
    {
        _played.Play();
        var words = new List<string>();
        _played.Sweep.Progressed += () => words.Add(_played.Sweep.Words);
        _played.Sweep.StartSweep();
        Assert.That(_played.Sweep.IsRunning);

        _played.Run(12);
        await _played.Judged();

        Assert.That(_played.Sweep.Verdict.Sight, Is.EqualTo(LoadSight.Seen));
        Assert.That(_played.Sweep.IsRunning, Is.False);
        Assert.That(_played.Load.Vertices, Is.EqualTo(7777), "as before");
        Assert.That(words[0], Is.EqualTo(LoadSweepMessages.WaitingForClock));
        Assert.That(words, Has.Some.EqualTo(LoadSweepMessages.Building(50000)).And.Some.EqualTo("load 2 of 5: 50000 vertices"));
        Assert.That(words[^1], Does.StartWith(SweepMessages.Responds("")));
        Assert.That(
            _played.Cell.Messages, Has.Some.EqualTo("[Nowpose] " + LoadSweepMessages.Done(_played.Sweep.Verdict.Words, _played.Sweep.Path)));
    }

    [Test]
    public void Progressed_ListenerThrows_CallsTheLaterOnes()
    {
        _played.Play();
        var words = new List<string>();
        _played.Sweep.Progressed += () => throw new InvalidOperationException();
        _played.Sweep.Progressed += () => words.Add(_played.Sweep.Words);

        _played.Sweep.StartSweep();
        _played.Run(0.1);

        Assert.That(words, Has.Member(LoadSweepMessages.WaitingForClock));
    }

    [Test]
    public async Task Sweep_ConstantSource_ReportsNoResponseToLoad()
    {
        _played.Play();
        _played.Sweep.StartSweep();

        _played.Run(12, gpuSeesLoad: false);
        await _played.Judged();

        Assert.That(_played.Sweep.Verdict.Sight, Is.EqualTo(LoadSight.Unseen));
        Assert.That(
            _played.Cell.Messages, Has.Some.EqualTo("[Nowpose] " + LoadSweepMessages.Done(_played.Sweep.Verdict.Words, _played.Sweep.Path)));
    }

    [Test]
    public void Clock_NotSynchronised_DelaysTheStart()
    {
        _played.Play();
        _played.Cell.IsSyncUp = false;
        _played.Sweep.StartSweep();

        _played.Run(20);

        Assert.That(_played.Sweep.Words, Is.EqualTo(LoadSweepMessages.WaitingForClock));
        Assert.That(_played.Load.Vertices, Is.Zero);
    }

    [Test]
    public void Frames_WhileTheLoadIsConstant_AllocateNothing()
    {
        _played.Play(seconds: 60);
        _played.Run(10);
        var without = _played.Cell.AllocatedIn(() => _played.Run(2));
        _played.Sweep.StartSweep();
        _played.Run(1);

        var allocated = _played.Cell.AllocatedIn(() => _played.Run(2));

        Assert.That(_played.Sweep.Words, Does.StartWith("load 1 of 5"));
        Assert.That(allocated, Is.EqualTo(without));
    }
}
