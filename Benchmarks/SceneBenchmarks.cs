using BenchmarkDotNet.Attributes;

namespace Nowpose.Benchmarks;

/// <summary>
/// Measures a frame of a scene with 50 robots and all components of the prefab. The scene runs on the stand-in engine, so Unity's own work
/// is not included. Each robot receives a sample every 50 ms. The simulated plants that send the samples are also measured separately.
/// </summary>
public class SceneBenchmarks : IDisposable
{
    /// <summary>Number of robots in the scene.</summary>
    public const int Robots = 50;

    CellScene _scene;

    [GlobalSetup(Targets = [nameof(Play), nameof(Receive)])]
    public void Prepare() => _scene = new CellScene(Robots, showGhost: false);

    [GlobalSetup(Target = nameof(PlayWithGhosts))]
    public void PrepareGhosts() => _scene = new CellScene(Robots, showGhost: true);

    [GlobalCleanup]
    public void Dispose()
    {
        _scene?.Dispose();
        GC.SuppressFinalize(this);
    }

    [Benchmark(Description = "Scene frame: 50 robot cells, the whole player loop, and the plants' samples")]
    public void Play() => _scene.Play();

    [Benchmark(Description = "– the same with all ghosts shown")]
    public void PlayWithGhosts() => _scene.Play();

    [Benchmark(Description = "– share of the simulated plants")]
    public void Receive() => _scene.Receive();
}
