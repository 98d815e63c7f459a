using Nowpose.Session;
using Nowpose.Simulation;
using Nowpose.Unity;
using UnityEngine;

namespace Nowpose.Unity.Tests.Calibration;

/// <summary>A sweep in a running scene, with a simulated GPU whose time increases with the number of vertices.</summary>
sealed class PlayedSweep : IAsyncDisposable
{
    readonly DisplayPipeline _gpu;

    public PlayedSweep()
    {
        Folder = Path.Combine(Path.GetTempPath(), "nowpose-" + Guid.NewGuid().ToString("N"));
        Cell = new PlayedCell();
        _gpu = new DisplayPipeline(1);
    }

    public PlayedCell Cell { get; }
    public MrilSession Session { get; private set; }
    public LoadGenerator Load { get; private set; }
    public LoadSweep Sweep { get; private set; }
    public TimestampDisplay Display { get; private set; }
    public string Folder { get; }

    public void Play(bool rewrites = false, int vertices = 100_000, float seconds = 0.5f, bool isPainted = true)
    {
        Session = Cell.NewSession(settings: new SessionSettings(
            PlayedCell.Offline.Connection, PlayedCell.Offline.Visualisation, rewriteBeforeRender: rewrites));
        Session.gameObject.AddComponent<RenderTimeSource>();
        var material = new Material((Shader)null);
        var wall = new GameObject("Load");
        wall.transform.SetParent(Session.transform, worldPositionStays: false);
        // With this clock step, only a few building steps fit into a frame, so building a load takes several frames.
        Cell.Clock.Step = TimeSpan.FromMicroseconds(5);
        Load = wall.AddComponent<LoadGenerator>().With("_material", isPainted ? material : null).With("_vertices", 7777).With("_msPerFrame", 0.1f);
        Display = Session.gameObject.AddComponent<TimestampDisplay>().With("_light", material);
        Sweep = Session.gameObject.AddComponent<LoadSweep>()
            .With("_folder", Folder).With("_maxVertices", vertices).With("_steps", 2).With("_secondsPerLoad", seconds).With("_settleSeconds", 0.1f);
        Cell.Player.World.Gpu.ConnectDisplay();
        Cell.Player.World.Gpu.DisplayHz = 60;
        Session.gameObject.SetActive(true);
    }

    public void Run(double seconds, bool gpuSeesLoad = true, Action seen = null)
    {
        for (var end = Cell.Now + seconds; Cell.Now < end; seen?.Invoke())
        {
            // Exaggerates the effect of the vertices, so that the verdict is clear.
            var vertices = gpuSeesLoad ? 10.0 * Load.VerticesShown : 0;
            Cell.Player.World.Gpu.DisplayGpuTime = (float)_gpu.Next(vertices).RenderTime.TotalSeconds;
            Cell.Frame(Session);
        }
    }

    public Task Judged() => Soon.BecomesAsync(
        () =>
        {
            Cell.Frame(Session);
            return Sweep.Verdict != null || Sweep.Problem != null;
        },
        "the sweep is evaluated");

    public async ValueTask DisposeAsync()
    {
        Cell.Dispose();
        // Waits for the background thread that writes the log.
        if (Sweep is not null) await Sweep.Closed.Bounded();
        if (Directory.Exists(Folder)) Directory.Delete(Folder, recursive: true);
        else File.Delete(Folder);
    }
}
