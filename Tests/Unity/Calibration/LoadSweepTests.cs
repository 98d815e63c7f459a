using Nowpose.Latency;
using Nowpose.Latency.Conditions;
using Nowpose.Latency.Sweep;
using Nowpose.Session;
using Nowpose.Simulation;
using Nowpose.Unity;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Calibration;

/// <summary>A sweep in a running scene whose display has a GPU that takes longer for more vertices.</summary>
public sealed class LoadSweepTests
{
    PlayedCell _cell;
    MrilSession _session;
    LoadGenerator _load;
    LoadSweep _sweep;
    TimestampDisplay _display;
    DisplayPipeline _gpu;
    string _folder;

    [SetUp]
    public void Begin()
    {
        _folder = Path.Combine(Path.GetTempPath(), "nowpose-" + Guid.NewGuid().ToString("N"));
        _cell = new PlayedCell();
        _gpu = new DisplayPipeline(1);
    }

    [TearDown]
    public async Task End()
    {
        _cell.Dispose();
        // A background thread, which no frame waits for, still writes the rows logged so far.
        if (_sweep is not null) await _sweep.Closed.Bounded();
        if (Directory.Exists(_folder)) Directory.Delete(_folder, recursive: true);
        else File.Delete(_folder);
    }

    void Play(bool rewrites = false, int vertices = 100_000, float seconds = 0.5f, bool isPainted = true)
    {
        _session = _cell.NewSession(settings: new SessionSettings(
            PlayedCell.Offline.Connection, PlayedCell.Offline.Visualisation, rewriteBeforeRender: rewrites));
        _session.gameObject.AddComponent<RenderTimeSource>();
        var material = new Material((Shader)null);
        var wall = new GameObject("Load");
        wall.transform.SetParent(_session.transform, worldPositionStays: false);
        // Limits building to a few steps per frame, so that a load takes some time.
        _cell.Clock.Step = TimeSpan.FromMicroseconds(5);
        _load = wall.AddComponent<LoadGenerator>().With("_material", isPainted ? material : null).With("_vertices", 7777).With("_msPerFrame", 0.1f);
        _display = _session.gameObject.AddComponent<TimestampDisplay>().With("_light", material);
        _sweep = _session.gameObject.AddComponent<LoadSweep>()
            .With("_folder", _folder).With("_mostVertices", vertices).With("_steps", 2).With("_secondsPerLoad", seconds).With("_settleSeconds", 0.1f);
        _cell.Player.World.Gpu.ConnectDisplay();
        _cell.Player.World.Gpu.DisplayHz = 60;
        _session.gameObject.SetActive(true);
    }

    void Run(double seconds, bool gpuSeesLoad = true, Action seen = null)
    {
        for (var end = _cell.Now + seconds; _cell.Now < end; seen?.Invoke())
        {
            // A much larger effect than this number of vertices has, because the test is about the verdict.
            var vertices = gpuSeesLoad ? 10.0 * _load.VerticesShown : 0;
            _cell.Player.World.Gpu.DisplayGpuTime = (float)_gpu.Next(vertices).RenderTime.TotalSeconds;
            _cell.Frame(_session);
        }
    }

    Task Judged() => Soon.BecomesAsync(
        () =>
        {
            _cell.Frame(_session);
            return _sweep.Verdict != null || _sweep.Problem != null;
        },
        "the sweep is judged");

    [TestCase(false)]
    [TestCase(true)]
    public async Task Log_OfASweep_HasARowForEachCodeWithItsLoad(bool rewrites)
    {
        Play(rewrites);
        Run(5);
        _sweep.StartSweep();
        var seen = new Dictionary<int, int>();

        Run(5, seen: () =>
        {
            if (_display.FrameStart is ControlTime start) seen[TimestampCode.ValueOf(start)] = _load.VerticesShown;
        });
        await Judged();

        var rows = SweepLogReader.Read(_sweep.Path);
        Assert.That(rows.Select(row => row.Vertices).Distinct(), Is.EquivalentTo(new[] { 0, 25_000, 50_000, 75_000, 100_000 }), "building, too");
        foreach (var load in new[] { 0, 50_000 })
            Assert.That(rows.Count(row => row.Vertices == load), Is.InRange(2 * 36, 2 * 39), "0.6 s at 60 Hz, up and down");
        Assert.That(Gaps(rows), Is.Empty, "not a frame is missing");
        foreach (var row in rows)
            Assert.That(seen.GetValueOrDefault(TimestampCode.ValueOf(row.FrameStart), -1), Is.EqualTo(row.Vertices), "by the code of " + row.FrameStart);
        Assert.That(rows, Has.All.Matches<SweepRow>(row => row.Source == RenderTimeSourceKind.DisplayGpuTime && row.RenderMs > 2));
        Assert.That(rows, Has.All.Matches<SweepRow>(row => row.Device == SystemInfo.deviceModel && row.DisplayHz == 60));
    }

    [Test]
    public async Task DisplayRate_ReportedDuringTheSweep_IsInTheRowsOfLaterLoads()
    {
        Play();
        Run(5);
        _cell.Player.World.Gpu.DisplayHz = null;
        _sweep.StartSweep();
        Run(0.1);
        _cell.Player.World.Gpu.DisplayHz = 72;

        Run(5);
        await Judged();

        var rows = SweepLogReader.Read(_sweep.Path);
        Assert.That(rows[0].DisplayHz, Is.NaN);
        Assert.That(rows.Where(row => row.Vertices > 0).Select(row => row.DisplayHz).Distinct(), Is.EqualTo(new[] { 72.0 }));
    }

    [Test]
    public async Task Log_OfASweep_StartsWithTheConditions()
    {
        Play(rewrites: true);
        _session.Reprojection = ReprojectionMode.Depth;
        Run(5);
        _sweep.StartSweep();
        Run(5);
        await Judged();

        using var text = new StreamReader(_sweep.Path);
        SweepLogReader.Read(text, "sweep.csv", out var conditions);

        Assert.That(conditions, Is.EqualTo(new DisplayConditions(
            graphicsApi: "Direct3D11", graphicsJobs: "MultiThreaded", renderPipeline: "built-in", rewritesBeforeRender: true,
            reprojection: ReprojectionMode.Depth)));
    }

    [Test]
    public void Reprojection_ChangesDuringTheSweep_EndsIt()
    {
        Play();
        _session.Reprojection = ReprojectionMode.Depth;
        Run(5);
        _sweep.StartSweep();
        Run(0.5);

        _session.Reprojection = ReprojectionMode.None;
        Run(5);

        Assert.That(_sweep.IsRunning, Is.False);
        Assert.That(_sweep.Problem, Is.EqualTo(
            "load sweep stopped: reprojection mode changed from 'depth' to 'none' during the sweep; do not change it and sweep again"));
    }

    static IEnumerable<TimeSpan> Gaps(IReadOnlyList<SweepRow> rows) =>
        rows.Skip(1).Zip(rows, (b, a) => b.FrameStart - a.FrameStart).Where(gap => gap.TotalMilliseconds is < 10 or > 25);

    [Test]
    public async Task Sweep_GpuSource_ReportsTheResponseToLoadAndTheLog()
    {
        Play();
        var words = new List<string>();
        _sweep.Progressed += () => words.Add(_sweep.Words);
        _sweep.StartSweep();
        Assert.That(_sweep.IsRunning);

        Run(12);
        await Judged();

        Assert.That(_sweep.Verdict.Sight, Is.EqualTo(LoadSight.Seen));
        Assert.That(_sweep.IsRunning, Is.False);
        Assert.That(_load.Vertices, Is.EqualTo(7777), "as before");
        Assert.That(words[0], Is.EqualTo("waiting for the clock"));
        Assert.That(words, Has.Some.EqualTo("building 50000 vertices").And.Some.EqualTo("load 2 of 5: 50000 vertices"));
        Assert.That(words[^1], Does.StartWith("this source responds to load: "));
        Assert.That(_cell.Messages, Has.Some.EqualTo("[Nowpose] load sweep done: " + _sweep.Verdict.Words + "; log: " + _sweep.Path));
    }

    [Test]
    public async Task Sweep_ConstantSource_ReportsNoResponseToLoad()
    {
        Play();
        _sweep.StartSweep();

        Run(12, gpuSeesLoad: false);
        await Judged();

        Assert.That(_sweep.Verdict.Words, Does.StartWith("this source does not respond to load: "));
        Assert.That(_cell.Messages, Has.Some.StartWith("[Nowpose] load sweep done: this source does not respond to load: "));
    }

    [Test]
    public void Clock_NotSynchronised_DelaysTheStart()
    {
        Play();
        _cell.IsSyncUp = false;
        _sweep.StartSweep();

        Run(20);

        Assert.That(_sweep.Words, Is.EqualTo("waiting for the clock"));
        Assert.That(_load.Vertices, Is.Zero);
    }

    [Test]
    public async Task Stop_DuringTheSweep_KeepsTheLoggedRows()
    {
        Play();
        _sweep.StartSweep();
        Run(6.5);
        var path = _sweep.Path;

        _sweep.StopSweep();
        Run(0.1);

        Assert.That(_sweep.IsRunning, Is.False);
        Assert.That(_sweep.Words, Is.EqualTo("sweep stopped"));
        Assert.That(_load.Vertices, Is.EqualTo(7777));
        await Soon.BecomesAsync(() => File.Exists(path) && SweepLogReader.Read(path).Count > 30, "the log is written");
        Run(1);
        Assert.That(_sweep.Verdict, Is.Null);
    }

    [Test]
    public void Disable_DuringTheSweep_StopsAndUnsubscribes()
    {
        Play();
        _sweep.StartSweep();
        Run(5);

        _sweep.enabled = false;
        Run(1);

        Assert.That(_sweep.IsRunning, Is.False);
        Assert.That(_cell.Messages.Where(m => m.Contains("Exception", StringComparison.Ordinal)), Is.Empty);
    }

    [Test]
    public void Frames_OfOneLoad_AllocateNothing()
    {
        Play(seconds: 60);
        Run(10);
        var without = _cell.AllocatedIn(() => Run(2));
        _sweep.StartSweep();
        Run(1);

        var allocated = _cell.AllocatedIn(() => Run(2));

        Assert.That(_sweep.Words, Does.StartWith("load 1 of 5"));
        Assert.That(allocated, Is.EqualTo(without));
    }

    [Test]
    public async Task Folder_CannotBeCreated_IsLoggedOnceAndEndsTheSweep()
    {
        File.WriteAllText(_folder, "a file where the folder should be");
        Play();
        _sweep.StartSweep();
        Run(12);
        await Judged();

        Assert.That(_sweep.Problem, Does.StartWith("sweep log " + _sweep.Path + " cannot be written: "));
        Assert.That(_cell.Messages.Count(m => m.Contains("cannot be written", StringComparison.Ordinal)), Is.EqualTo(1));
        Assert.That(_load.Vertices, Is.EqualTo(7777));
    }

    [Test]
    public void Load_CannotBeDrawn_EndsTheSweepWithItsProblem()
    {
        Play(isPainted: false);
        _sweep.StartSweep();

        Run(5);

        Assert.That(_sweep.IsRunning, Is.False);
        Assert.That(_sweep.Problem, Is.EqualTo("load generator 'Load' has no material; assign one"));
        Assert.That(_sweep.Words, Is.EqualTo("sweep stopped"));
    }

    [Test]
    public async Task Load_DisabledDuringTheSweep_EndsItAndKeepsTheLoggedRows()
    {
        Play();
        _sweep.StartSweep();
        Run(6.5);

        _load.enabled = false;
        Run(1);

        Assert.That(_sweep.IsRunning, Is.False);
        Assert.That(_sweep.Problem, Is.EqualTo("load generator 'Load' is switched off; the sweep needs it"));
        Assert.That(_cell.Messages.Count(m => m.Contains("switched off", StringComparison.Ordinal)), Is.EqualTo(1));
        Assert.That(_load.Vertices, Is.EqualTo(7777), "as before");
        await Soon.BecomesAsync(() => File.Exists(_sweep.Path) && SweepLogReader.Read(_sweep.Path).Count > 30, "the log is written");
    }

    [Test]
    public void Load_DestroyedDuringTheSweep_EndsIt()
    {
        Play();
        _sweep.StartSweep();
        Run(5);

        UnityEngine.Object.Destroy(_load.gameObject);
        Run(1, gpuSeesLoad: false);

        Assert.That(_sweep.IsRunning, Is.False);
        Assert.That(_sweep.Problem, Does.EndWith("has lost its load generator; its log is kept"));
        Assert.That(_cell.Messages.Where(m => m.Contains("Exception", StringComparison.Ordinal)), Is.Empty);
    }

    [Test]
    public void Parts_Missing_AreReported()
    {
        var sweep = new GameObject("Alone").AddComponent<LoadSweep>();

        sweep.StartSweep();

        Assert.That(sweep.Problem, Is.EqualTo("load sweep 'Alone' has no session on its object or a parent; assign one"));
        Assert.That(sweep.IsRunning, Is.False);
    }

    [Test]
    public void Plan_OutOfRange_IsReported()
    {
        Play();
        _sweep.With("_steps", 1);

        _sweep.StartSweep();

        Assert.That(_sweep.Problem, Does.Contain("steps of the sweep: 1 is out of range"));
    }
}
