using Nowpose.Latency;
using Nowpose.Session;
using Nowpose.Unity;
using Nowpose.Unity.Rendering;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace Nowpose.Unity.Tests;

/// <summary>
/// Tests that, after a warm-up, a frame of the package's cells with all their components does not allocate. The messages are created outside of
/// the measurement.
/// </summary>
public class FrameAllocationTests
{
    const double WarmSeconds = 20;
    const double MeasuredSeconds = 17;
    const double MeasuredFrames = MeasuredSeconds * 60;

    PlayedCell _cell;
    Transform _head;
    MrilSession _session;
    int _frames, _shown;

    public enum Means
    {
        DisplayGpu, EngineGpu, Readback, Camera,
    }

    Gpu Gpu => _cell.Player.World.Gpu;

    [SetUp]
    public void Begin()
    {
        _cell = new PlayedCell();
        _head = new GameObject("Camera") { tag = "MainCamera" }.AddComponent<Camera>().transform;
        (_frames, _shown) = (0, 0);
    }

    [TearDown]
    public void End() => _cell.Dispose();

    [Test]
    [Pairwise]
    public void Frame_AfterWarmUp_AllocatesNothing(
        [Values("Nowpose Robot Cell", "Nowpose Robot Cell (Any Robot)")] string prefab, [Values] Means means,
        [Values] bool ghost, [Values] bool rewrites)
    {
        _session = _cell.NewSessionOf(prefab);
        _session.Settings = new SessionSettings(
            PlayedCell.Offline.Connection, PlayedCell.Offline.Visualisation, rewriteBeforeRender: rewrites);
        _session.Shown += _ => _shown++;
        _session.GetComponentInChildren<Ghost>(true).Visible = ghost;
        _session.gameObject.SetActive(true);
        Run(WarmSeconds, means);
        _cell.IsPlantUp = false;
        Run(3, means);
        _cell.IsPlantUp = true;
        Run(5, means);
        var panel = _session.GetComponentInChildren<StatusPanel>();
        var texts = panel.GetComponentsInChildren<TextMesh>();
        var (before, changes, from) = (_session.Statistics.Samples, texts.Sum(t => t.TextChanges), panel.transform.position);

        var withSamples = Measure(means);

        Assert.That(withSamples, Is.EqualTo(0), "bytes in frames with samples");
        Assert.That(_session.Frame.State, Is.EqualTo(PoseState.Current));
        Assert.That(_session.Statistics.Samples - before, Is.GreaterThan(300));
        Assert.That(_session.Statistics.RenderTimeSource, Is.EqualTo(KindOf(means)));
        Assert.That(_session.Statistics.RenderTime, Is.Not.Null, "the measured time reaches the session");
        Assert.That(_shown, Is.EqualTo(MeasuredFrames * (rewrites ? 2 : 1)).Within(4));
        Assert.That(_session.GetComponentInChildren<Ghost>(true).GapMetres, ghost ? Is.GreaterThan(0) : Is.Null);
        Assert.That(texts.Sum(t => t.TextChanges) - changes, Is.GreaterThan(30), "the panel's numbers change");
        Assert.That(panel.transform.position, Is.Not.EqualTo(from), "the panel follows");

        _cell.IsPlantUp = false;
        Run(3, means);

        Assert.That(Measure(means), Is.EqualTo(0), "bytes in frames without samples");
        Assert.That(_session.Frame.State, Is.EqualTo(PoseState.Held));
        Assert.That(WordsOf(_session), Is.EqualTo("held"));
    }

    static RenderTimeSourceKind KindOf(Means means) => means switch
    {
        Means.Readback => RenderTimeSourceKind.GpuCompletion,
        Means.Camera => RenderTimeSourceKind.CameraCpu,
        Means.EngineGpu => RenderTimeSourceKind.EngineGpuTime,
        _ => RenderTimeSourceKind.DisplayGpuTime,
    };

    static string WordsOf(MrilSession session) => session.GetComponentInChildren<PoseAppearance>()
        .GetComponentsInChildren<TextMesh>().Single(text => text.name == "Words").text;

    long Measure(Means means) => _cell.AllocatedIn(() =>
    {
        _shown = 0;
        Run(MeasuredSeconds, means);
    });

    void Run(double seconds, Means means) => _cell.Run(seconds, _session, () => Next(means));

    /// <summary>Prepares the next frame with another render time and another rotation of the head.</summary>
    void Next(Means means)
    {
        var ms = 6 + _frames++ % 37 * 0.2;
        if (means == Means.DisplayGpu) Gpu.ConnectDisplay();
        Gpu.DisplayGpuTime = means == Means.DisplayGpu ? (float)ms / 1000 : null;
        Gpu.FrameTimings.Clear();
        if (means == Means.EngineGpu) Gpu.FrameTimings.Add(new FrameTiming { gpuFrameTime = ms });
        Gpu.ReadbackFrames = means == Means.Readback ? 2 : -1;
        _cell.Clock.Step = TimeSpan.FromMilliseconds(means == Means.Camera ? ms / 10 : 0.001);
        _head.rotation = Quaternion.Euler(0, _frames * 0.3f, 0);
    }
}
