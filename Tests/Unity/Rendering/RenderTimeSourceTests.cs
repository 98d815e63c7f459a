using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Session;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Rendering;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace Nowpose.Unity.Tests.Rendering;

public class RenderTimeSourceTests
{
    const double FrameMs = 1000 / 60.0;

    PlayedCell _cell;
    MrilSession _session;
    RenderTimeSource _source;

    Gpu Gpu => _cell.Player.World.Gpu;

    [SetUp]
    public void Begin()
    {
        _cell = new PlayedCell();
        _session = _cell.NewSession(settings: new SessionSettings(
            new ConnectionSettings("127.0.0.1"), VisualisationLatency.FromMilliseconds(40),
            range: new ConstantLatencyRange(15, RenderTimeSourceKind.DisplayGpuTime)));
        _source = _session.gameObject.AddComponent<RenderTimeSource>();
        new GameObject("Camera").AddComponent<Camera>();
    }

    [TearDown]
    public void End() => _cell.Dispose();

    void Play(double seconds)
    {
        _session.gameObject.SetActive(true);
        Run(seconds);
    }

    void Run(double seconds) => _cell.Run(seconds, _session);

    void DisplayTakes(float? seconds)
    {
        Gpu.ConnectDisplay();
        Gpu.DisplayGpuTime = seconds;
    }

    void EngineTakes(double ms)
    {
        Gpu.FrameTimings.Clear();
        Gpu.FrameTimings.Add(new FrameTiming { gpuFrameTime = ms });
    }

    IEnumerable<string> Logged() => _cell.Player.Logs.Select(l => l.Message).Where(m => m.StartsWith("[Nowpose] render time: ")).Select(m => m[23..]);

    // Versions of com.unity.xr.openxr before 1.18 report milliseconds.
    [TestCase(0.009f)]
    [TestCase(9)]
    public void LateUpdate_AllSourcesAvailable_UsesTheHeadsetsGpuTime(float reported)
    {
        DisplayTakes(reported);
        EngineTakes(11);
        Gpu.ReadbackFrames = 1;

        Play(2);

        Assert.That(_source.Source, Is.EqualTo(RenderTimeSourceKind.DisplayGpuTime));
        Assert.That(_source.RenderTime.Value.TotalMilliseconds, Is.EqualTo(9).Within(1e-3));
        Assert.That(_session.Statistics.RenderTime.Value.TotalMilliseconds, Is.EqualTo(9).Within(1e-3));
        Assert.That(_session.Statistics.Range, Is.EqualTo(RangeState.Inside));
        Assert.That(Logged(), Is.EqualTo(new[] { RenderTimeNames.NameOf(RenderTimeSourceKind.DisplayGpuTime) }), "once");
        Assert.That(Gpu.PendingReadbacks, Is.EqualTo(0), "no readback is requested");
    }

    [TestCase(null)]
    [TestCase(0f)]
    [TestCase(float.NaN)]
    [TestCase(12_000f)]
    public void LateUpdate_HeadsetTimeInvalid_UsesTheEnginesGpuTime(float? seconds)
    {
        DisplayTakes(seconds);
        EngineTakes(11);

        Play(2);

        Assert.That(_source.Source, Is.EqualTo(RenderTimeSourceKind.EngineGpuTime));
        Assert.That(_source.RenderTime.Value.TotalMilliseconds, Is.EqualTo(11).Within(1e-3));
        Assert.That(_session.Statistics.RangeUnknownReason, Is.EqualTo(RangeUnknownReason.OtherSource), "the limit was found with the headset's");
        Assert.That(Logged(), Is.EqualTo(new[] { RenderTimeNames.NameOf(RenderTimeSourceKind.EngineGpuTime) }));
    }

    [TestCase(1)]
    [TestCase(3)]
    public void LateUpdate_NoGpuTimes_MeasuresFromTriggerToCompletion(int framesUntilDone)
    {
        EngineTakes(0);
        Gpu.ReadbackFrames = framesUntilDone;

        Play(2);

        Assert.That(_source.Source, Is.EqualTo(RenderTimeSourceKind.GpuCompletion));
        Assert.That(_session.Statistics.RenderTime.Value.TotalMilliseconds, Is.EqualTo(FrameMs * framesUntilDone).Within(0.01));
        Assert.That(_session.Statistics.RangeUnknownReason, Is.EqualTo(RangeUnknownReason.OtherSource), "the limit was found with the GPU's time");
        Assert.That(Logged(), Is.EqualTo(new[] { RenderTimeNames.NameOf(RenderTimeSourceKind.GpuCompletion) }));
    }

    [Test]
    public void LateUpdate_SlowGpu_HasFewReadbacksInFlight()
    {
        Gpu.ReadbackFrames = 20;

        Play(4);

        Assert.That(Gpu.PendingReadbacks, Is.LessThanOrEqualTo(4));
        Assert.That(_source.Source, Is.EqualTo(RenderTimeSourceKind.GpuCompletion));
        Assert.That(_session.Statistics.RenderTime.Value.TotalMilliseconds, Is.EqualTo(FrameMs * 20).Within(0.01));
    }

    [TestCase(-1, false)]
    [TestCase(1, true)]
    public void LateUpdate_NoGpuTimesOrReadbacks_UsesTheCpuTimeMarkedAsUnverified(int readbackFrames, bool fail)
    {
        Gpu.ReadbackFrames = readbackFrames;
        Gpu.ReadbacksFail = fail;
        _cell.Clock.Step = TimeSpan.FromMilliseconds(2);

        Play(2);

        Assert.That(_source.Source, Is.EqualTo(RenderTimeSourceKind.CameraCpu));
        Assert.That(_source.RenderTime.Value.TotalMilliseconds, Is.EqualTo(2).Within(1e-3), "the time spans from before to after the camera's rendering");
        Assert.That(Logged(), Is.EqualTo(new[] { RenderTimeNames.NameOf(RenderTimeSourceKind.CameraCpu) }));
    }

    [Test]
    public void LateUpdate_SeveralCameras_MeasuresFromTheFirstToTheLast()
    {
        _cell.Clock.Step = TimeSpan.FromMilliseconds(1);
        new GameObject("second").AddComponent<Camera>();
        new GameObject("third").AddComponent<Camera>();

        Play(2);

        Assert.That(_source.RenderTime.Value.TotalMilliseconds, Is.EqualTo(5).Within(1e-3));
    }

    [Test]
    public void Source_NothingMeasurable_IsNone()
    {
        _cell.Clock.Step = TimeSpan.Zero;

        Play(2);

        Assert.That(_source.Source, Is.EqualTo(RenderTimeSourceKind.None), "the clock does not advance while the camera renders");
        Assert.That(_source.RenderTime, Is.Null);
        Assert.That(Logged(), Is.Empty);
    }

    [Test]
    public void LateUpdate_GpuTimesStop_UsesTheNextBestSourceAndLogsItOnce()
    {
        DisplayTakes(0.02f);
        Gpu.ReadbackFrames = 1;
        _cell.Clock.Step = TimeSpan.FromMilliseconds(1);
        Play(10);
        var before = _session.Statistics.Range;

        Gpu.DisplayGpuTime = null;
        Run(0.4);
        var soon = _source.Source;
        Run(2);

        Assert.That(before, Is.EqualTo(RangeState.Outside));
        Assert.That(soon, Is.EqualTo(RenderTimeSourceKind.DisplayGpuTime), "a few frames without values do not end the use of a source");
        Assert.That(_session.Statistics.Range, Is.EqualTo(RangeState.Unknown));
        Assert.That(Logged().First(), Is.EqualTo(RenderTimeNames.NameOf(RenderTimeSourceKind.DisplayGpuTime)));
        Assert.That(Logged().Last(), Is.EqualTo(RenderTimeNames.NameOf(RenderTimeSourceKind.GpuCompletion)));
        Assert.That(Logged(), Has.None.EqualTo(RenderTimeNames.NameOf(RenderTimeSourceKind.CameraCpu)), "a source that is about to be replaced is not logged");
        Assert.That(Logged().Count(), Is.LessThanOrEqualTo(3));
    }

    [Test]
    public void LateUpdate_LoadBeyondTheLimit_PoseIsNotCurrent()
    {
        DisplayTakes(0.01f);
        Play(10);
        var before = _session.Frame.State;

        DisplayTakes(0.02f);
        Run(0.2);

        Assert.That(before, Is.EqualTo(Nowpose.Session.PoseState.Current));
        Assert.That(_session.Frame.State, Is.EqualTo(Nowpose.Session.PoseState.OutsideRange));
    }

    [Test]
    public void OnDisable_WhileMeasuring_SetsTheSessionsSourceToNone()
    {
        DisplayTakes(0.02f);
        Play(2);
        var before = _session.Statistics.Range;

        _source.enabled = false;
        Run(0.1);

        Assert.That(before, Is.EqualTo(RangeState.Outside));
        Assert.That(_session.Statistics.Range, Is.EqualTo(RangeState.Unknown));
        Assert.That(_session.Statistics.RenderTime, Is.Null);
        Assert.That(_source.Source, Is.EqualTo(RenderTimeSourceKind.None));
    }

    [Test]
    public void OnEnable_EnabledAgain_MeasuresAgain()
    {
        Gpu.ReadbackFrames = 2;
        Play(2);

        for (var i = 0; i < 5; i++)
        {
            _source.enabled = false;
            _cell.Frame(_session);
            _source.enabled = true;
            _cell.Frame(_session);
        }
        Run(2);

        Assert.That(_source.Source, Is.EqualTo(RenderTimeSourceKind.GpuCompletion));
        Assert.That(_session.Statistics.RenderTime.Value.TotalMilliseconds, Is.EqualTo(FrameMs * 2).Within(0.01));
    }

    [Test]
    public void OnDestroy_AtAnyFrame_LeaksNothing([Values] bool byObject, [Values(0, 1, 7, 45)] int frames)
    {
        Gpu.ReadbackFrames = 3;
        _cell.Clock.Step = TimeSpan.FromMilliseconds(1);
        var objects = _cell.Player.ObjectCount;
        var other = new GameObject("Other");
        other.AddComponent<RenderTimeSource>();
        for (var i = 0; i < frames; i++) _cell.Frame(_session);

        UnityEngine.Object.Destroy(byObject ? other : other.GetComponent<RenderTimeSource>());
        Run(0.2);
        if (!byObject) UnityEngine.Object.Destroy(other);
        Run(0.2);

        Assert.That(_cell.Player.SubscriberCount, Is.EqualTo(0));
        Assert.That(_cell.Player.ObjectCount, Is.EqualTo(objects));
        Assert.That(_cell.Player.Logs.Where(l => l.Exception != null), Is.Empty);
    }

    [Test]
    public void Session_Missing_IsLogged()
    {
        new GameObject("Alone").AddComponent<RenderTimeSource>();

        Assert.That(_cell.Messages, Has.Exactly(1).EndsWith(ComponentMessages.ComponentWithoutSession("render time source", "Alone")));
    }

    [Test]
    public void Report_SessionRestartsAfterAPause_ReceivesRenderTimesAgain()
    {
        DisplayTakes(0.02f);
        Play(2);

        _cell.Player.Pause(true);
        Run(0.1);
        var whilePaused = _session.Session;
        _cell.Player.Pause(false);
        Run(0.5);

        Assert.That(whilePaused, Is.Null);
        Assert.That(_session.Statistics.Range, Is.EqualTo(RangeState.Outside));
    }
}
