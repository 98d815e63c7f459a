using Microsoft.MixedReality.OpenXR;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.OpenXR;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Unity;
using Nowpose.Unity.Status;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Devices;

public sealed class OpenXrDisplayTimeTests
{
    const string Gantry = """
        <robot name='gantry'><link name='base'/><link name='carriage'/><joint name='x' type='prismatic'><parent link='base'/>
        <child link='carriage'/><axis xyz='1 0 0'/><limit lower='-2' upper='2' velocity='2' effort='1'/></joint></robot>
        """;

    const double CalibratedMs = 40, VariationMs = 8, FrameMs = 1000 / 60.0;
    static readonly TimeSpan Late = TimeSpan.FromMilliseconds(80);

    PlayedCell _cell;
    PlayedRuntime _runtime;
    MrilSession _session;
    OpenXrDisplayTime _component;
    double _nextSample;

    [SetUp]
    public void SetUp()
    {
        _cell = new PlayedCell { IsPlantUp = false };
        _runtime = new PlayedRuntime(_cell.Clock);
        _nextSample = 0;
    }

    [TearDown]
    public void TearDown()
    {
        _cell.Dispose();
        _runtime.Dispose();
    }

    static SessionSettings Settings(bool isRewritten) => new(
        new ConnectionSettings("127.0.0.1", 1, 1), VisualisationLatency.FromMilliseconds(CalibratedMs), new PredictionSettings("quadratic"),
        rewriteBeforeRender: isRewritten);

    void Play(bool isRewritten = false)
    {
        _session = _cell.NewSession(robot: null, Settings(isRewritten));
        _session.RobotAsset = RobotDescriptionAsset.Create("gantry", Gantry);
        _component = _session.gameObject.AddComponent<OpenXrDisplayTime>();
        _runtime.Equip(_component);
        _session.gameObject.SetActive(true);
    }

    // Moves back and forth at up to half a metre per second.
    static double TruthAt(HeadsetTime at) => 0.5 * Math.Sin(at.SinceEpoch.TotalSeconds);

    // The display latency varies by half a refresh, alternating every half second.
    static TimeSpan TrueLatency(double seconds) =>
        TimeSpan.FromMilliseconds(CalibratedMs + ((int)(seconds * 2) % 2 == 0 ? VariationMs : -VariationMs));

    void Run(double seconds, Action seen = null)
    {
        for (var end = _cell.Now + seconds; _cell.Now < end;)
        {
            if (_cell.Now >= _nextSample && _session.Session != null)
            {
                _nextSample = _cell.Now + 0.02;
                var taken = _cell.Clock.Read - Late;
                _session.Session.Listener.Received(
                    new JointStateMessage(new ControlTime(taken.SinceEpoch + TimeSpan.FromSeconds(300)), ["x"], [TruthAt(taken)]), _cell.Clock.Read);
            }
            _cell.Frame(_session);
            seen?.Invoke();
        }
    }

    // RMS distance over 12 s between the drawn tool and its true position when the frame's light appears, mm.
    double ErrorMm()
    {
        double sum = 0;
        var frames = 0;
        Run(8);
        Run(12, () =>
        {
            var light = _session.Frame.Start + TrueLatency(_cell.Now);
            sum += Math.Pow(1000 * (_session.Frame.ToolPose.X - TruthAt(light)), 2);
            frames++;
        });
        return Math.Sqrt(sum / frames);
    }

    // In Update the runtime predicts for the previous frame, so it is one frame off here. Before rendering it predicts for this frame.
    HeadsetTime? Predicted(FrameTime tick, bool isRewritten)
    {
        var light = _cell.Clock.Read + TrueLatency(_cell.Now);
        return isRewritten && tick == FrameTime.OnUpdate ? light + TimeSpan.FromMilliseconds(FrameMs) : light;
    }

    [TestCase(false)]
    [TestCase(true)]
    public void DisplayTime_LatencyVariesByEightMilliseconds_IsCompensatedOnlyWithTheComponent(bool isRewritten)
    {
        Play(isRewritten);
        _runtime.LightOf = tick => Predicted(tick, isRewritten);

        var with = ErrorMm();
        _component.enabled = false;
        var without = ErrorMm();

        Assert.That(without, Is.InRange(2.3, 3.4), "8 ms at 0.35 m/s RMS: the effect");
        Assert.That(with, Is.LessThan(0.2 * without), "what is left is the prediction's");
    }

    [TestCase(0, null)]
    [TestCase(-1, null)]
    [TestCase(0, -5.0)]
    [TestCase(0, 501.0)]
    public void DisplayTime_NoOrInvalidRuntimeTime_UsesTheCalibration(long unknown, double? aheadMs)
    {
        Play();
        _runtime.Unknown = unknown;
        _runtime.LightOf = _ => aheadMs is { } ms ? _cell.Clock.Read + TimeSpan.FromMilliseconds(ms) : null;

        Run(2);

        Assert.That(_session.Statistics.VisualisationLatency.TotalMilliseconds, Is.EqualTo(CalibratedMs));
        Assert.That(_session.Statistics.IsLightPredicted, Is.False);
        Assert.That(_cell.Messages.Any(m => m.Contains("implausible")), Is.EqualTo(aheadMs.HasValue), "a missing answer is not a fault");
    }

    [Test]
    public void DisplayTime_InTheEditor_UsesTheCalibration()
    {
        Play();
        _runtime.Dispose();

        Run(1);

        Assert.That(_session.Statistics.IsLightPredicted, Is.False);
    }

    [TestCase(10_000_000)]
    [TestCase(19_200_000)]
    [TestCase(24_000_000)]
    [TestCase(1_015_592)]
    public void DisplayTime_CounterOfAnyFrequency_IsExactToOneCount(long countsPerSecond)
    {
        _runtime.Dispose();
        _runtime = new PlayedRuntime(_cell.Clock, countsPerSecond);
        Play();
        _runtime.LightOf = _ => _session.Session == null ? null : _cell.Clock.Read + TimeSpan.FromMilliseconds(47);

        Run(2);

        Assert.That(_session.Statistics.IsLightPredicted);
        Assert.That(_session.Statistics.VisualisationLatency.TotalMilliseconds, Is.EqualTo(47).Within(2 * (1000.0 / countsPerSecond + 1e-4)));
        Assert.That(_session.Statistics.IsDisplayTimeImplausible, Is.False);
        Assert.That(_cell.Messages.Count(m => m.Contains($"performance counter {countsPerSecond} Hz, stopwatch 10000000 Hz")), Is.EqualTo(1));
    }

    [Test]
    public void DisplayTime_PlatformWithoutKernel32_UsesTheCalibrationAndWarnsOnce()
    {
        Play();
        _component.OpenCounter = () => throw new DllNotFoundException("kernel32.dll");
        _runtime.LightOf = _ => _cell.Clock.Read + TimeSpan.FromMilliseconds(47);

        Run(8);

        Assert.That(_session.Statistics.IsLightPredicted, Is.False);
        Assert.That(_session.Frame.State, Is.EqualTo(PoseState.Current));
        var warnings = _cell.Messages.Where(m => m.Contains("has no performance counter of Windows (kernel32.dll); the calibrated L_visu is used"));
        Assert.That(warnings.Count(), Is.EqualTo(1));
    }

    [TestCase(0.9, false)]
    [TestCase(1.05, true)]
    public void DisplayTime_ImplausibleForASecond_IsReportedOnceInPanelLogAndDiagnosticsLikeItsRecovery(double seconds, bool isReported)
    {
        Play();
        var texts = new StatusTexts();
        string Panel()
        {
            texts.Update(_session.Statistics, _session.Settings, null, null);
            return texts.ValueOf(StatusRow.VisualisationLatency) + "|" + texts.NoteOf(StatusRow.VisualisationLatency);
        }
        string Diagnostic() => _session.Session.Listener.Diagnostics().Values.SingleOrDefault(v => v.Key == "display_time").Value;
        int Lines(string of) => _cell.Messages.Count(m => m.Contains(of));
        HeadsetTime Right(FrameTime _) => _cell.Clock.Read + TimeSpan.FromMilliseconds(40);
        // Counts of 24 MHz read as counts of 10 MHz: on a device that has run for a while the result is far ahead.
        HeadsetTime Wrong(FrameTime _) => new(_cell.Clock.Read.SinceEpoch * 2.4);

        _runtime.LightOf = t => Right(t);
        Run(2);
        _runtime.LightOf = t => Wrong(t);
        Run(seconds);
        var (panel, diagnostic) = (Panel(), Diagnostic());
        texts.Update(_session.Statistics, _session.Settings, null, null);
        var message = texts.ValueOf(StatusRow.Message).Replace('\n', ' ');
        var lines = Lines("implausible");
        Run(isReported ? 3 : 0);
        _runtime.LightOf = t => Right(t);
        Run(3);

        Assert.That(panel, Is.EqualTo(isReported ? "! 40.0 ms|runtime's are implausible" : "40.0 ms|as set"));
        Assert.That(message.Contains("display times of the runtime are implausible"), Is.EqualTo(isReported));
        Assert.That(diagnostic, Is.EqualTo(isReported ? "implausible" : null));
        Assert.That(lines, Is.EqualTo(isReported ? 1 : 0));
        Assert.That(Lines("implausible"), Is.EqualTo(isReported ? 1 : 0), "once, however long it lasts");
        Assert.That(Lines("plausible again"), Is.EqualTo(isReported ? 1 : 0));
        Assert.That(Panel(), Is.EqualTo("40.0 ms|predicted by the runtime"));
        Assert.That(Diagnostic(), Is.EqualTo("predicted"));
    }

    [Test]
    public void DisplayTime_BuildWithoutThePluginsLibrary_UsesTheCalibrationAndLogsItOnce()
    {
        Play();
        _runtime.LightOf = _ => throw new DllNotFoundException("MicrosoftOpenXRPlugin");

        Run(8);

        Assert.That(_session.Statistics.IsLightPredicted, Is.False);
        Assert.That(_session.Frame.State, Is.EqualTo(PoseState.Current));
        Assert.That(_cell.Messages.Count(m => m.Contains("MicrosoftOpenXRPlugin; the calibrated L_visu is used")), Is.EqualTo(1));
    }

    [Test]
    public void DisplayTime_SessionRestarted_Continues()
    {
        Play();
        _runtime.LightOf = _ => _cell.Clock.Read + TimeSpan.FromMilliseconds(47);
        Run(1);

        _session.Settings = Settings(isRewritten: true);
        Run(1);

        Assert.That(_session.Statistics.IsLightPredicted);
    }

    [Test]
    public void DisplayTime_ClockOtherThanTheCounter_UsesTheCalibrationAndLogsItOnce()
    {
        _session = _cell.NewSession(robot: null, Settings(isRewritten: false));
        var own = new OtherClock(_cell.Clock);
        _session.HeadsetClock = own;
        _runtime.Equip(_session.gameObject.AddComponent<OpenXrDisplayTime>());
        _session.gameObject.SetActive(true);
        _runtime.LightOf = _ => _cell.Clock.Read + TimeSpan.FromMilliseconds(47);

        Run(1);

        Assert.That(_session.Statistics.IsLightPredicted, Is.False);
        Assert.That(_cell.Messages.Count(m => m.Contains("is not the performance counter")), Is.EqualTo(1));
    }

    [Test]
    public void DisplayTime_LastingDifferenceFromTheCalibration_UsesTheRuntimeAndReportsIt()
    {
        Play();
        _runtime.LightOf = _ => _cell.Clock.Read + TimeSpan.FromMilliseconds(47);

        Run(4);

        Assert.That(_session.Statistics.IsDisplayTimeInconsistent);
        Assert.That(_session.Statistics.DisplayTimeDifference.Value.TotalMilliseconds, Is.EqualTo(7).Within(0.01));
        Assert.That(_session.Statistics.VisualisationLatency.TotalMilliseconds, Is.EqualTo(47).Within(0.01));
        Assert.That(_cell.Messages.Count(m => m.Contains("differ by more than 5 ms")), Is.EqualTo(1));
    }

    [Test]
    public void OnEnable_NoSessionAbove_Warns()
    {
        new GameObject("Alone").AddComponent<OpenXrDisplayTime>();

        Assert.That(_cell.Messages, Has.Some.Contains("display time 'Alone' has no session on its object or a parent"));
    }

    [Test]
    public void OnDisable_AnotherSourceAssigned_KeepsThatSource()
    {
        Play();
        var other = new OtherSource();
        _session.DisplayTimeSource = other;

        _component.enabled = false;

        Assert.That(_session.DisplayTimeSource, Is.SameAs(other));
    }

    [Test]
    public void DisplayTime_OnceWarm_AllocatesNothing()
    {
        Play();
        _runtime.LightOf = _ => _cell.Clock.Read + TimeSpan.FromMilliseconds(47);
        Run(3);
        var start = _cell.Clock.Read;

        var before = GC.GetAllocatedBytesForCurrentThread();
        for (var i = 0; i < 100; i++) _component.LightOf(start);

        Assert.That(GC.GetAllocatedBytesForCurrentThread() - before, Is.Zero);
    }

    sealed class OtherClock(SteppedClock clock) : IHeadsetClock
    {
        public HeadsetTime Now => clock.Now;
    }

    sealed class OtherSource : IDisplayTimeSource
    {
        public HeadsetTime? LightOf(HeadsetTime frameStart) => null;
    }
}
