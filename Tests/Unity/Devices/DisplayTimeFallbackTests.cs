using Microsoft.MixedReality.OpenXR;
using Nowpose.Latency;
using Nowpose.Messages;
using Nowpose.OpenXR;
using Nowpose.Session;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Status;
using NUnit.Framework;
using UnityEngine;
using static Nowpose.Unity.Tests.Devices.PlayedDisplayTime;

namespace Nowpose.Unity.Tests.Devices;

/// <summary>Tests that the calibration is used, and the reason reported, while the runtime's display time cannot be used.</summary>
public sealed class DisplayTimeFallbackTests
{
    PlayedDisplayTime _played;

    [SetUp]
    public void SetUp() => _played = new PlayedDisplayTime();

    [TearDown]
    public void TearDown() => _played.Dispose();

    [TestCase(0, null)]
    [TestCase(-1, null)]
    [TestCase(0, -5.0)]
    [TestCase(0, 501.0)]
    public void DisplayTime_NoOrInvalidRuntimeTime_UsesTheCalibration(long unknown, double? aheadMs)
    {
        _played.Play();
        _played.Runtime.Unknown = unknown;
        _played.Runtime.LightOf = _ => aheadMs is { } ms ? _played.Cell.Clock.Read + TimeSpan.FromMilliseconds(ms) : null;

        _played.Run(2);

        Assert.That(_played.Session.Statistics.VisualisationLatency.TotalMilliseconds, Is.EqualTo(CalibratedMs));
        Assert.That(_played.Session.Statistics.IsLightPredicted, Is.False);
        Assert.That(_played.Cell.Messages.Any(m => m.Contains("implausible")), Is.EqualTo(aheadMs.HasValue), "a missing answer is not a fault");
    }

    [Test]
    public void DisplayTime_InTheEditor_UsesTheCalibration()
    {
        _played.Play();
        _played.Runtime.Dispose();

        _played.Run(1);

        Assert.That(_played.Session.Statistics.IsLightPredicted, Is.False);
    }

    [Test]
    public void DisplayTime_PlatformWithoutKernel32_UsesTheCalibrationAndWarnsOnce()
    {
        _played.Play();
        _played.Component.OpenCounter = () => throw new DllNotFoundException("kernel32.dll");
        _played.Runtime.LightOf = _ => _played.Cell.Clock.Read + TimeSpan.FromMilliseconds(47);

        _played.Run(8);

        Assert.That(_played.Session.Statistics.IsLightPredicted, Is.False);
        Assert.That(_played.Session.Frame.State, Is.EqualTo(PoseState.Current));
        var warnings = _played.Cell.Messages.Where(
            m => m.Contains(DeviceMessages.NoDisplayTime(_played.Session.name, CounterMessages.Missing("kernel32.dll"))));
        Assert.That(warnings.Count(), Is.EqualTo(1));
    }

    [TestCase(0.9, false)]
    [TestCase(1.05, true)]
    public void DisplayTime_ImplausibleForASecond_LogsTheFaultAndTheRecoveryOnce(double seconds, bool isReported)
    {
        _played.Play();
        var texts = new StatusTexts();
        string Panel()
        {
            texts.Update(_played.Session.Statistics, _played.Session.Settings, null, null);
            return texts.ValueOf(StatusRow.VisualisationLatency) + "|" + texts.NoteOf(StatusRow.VisualisationLatency);
        }
        string Diagnostic() => _played.Session.Session.Listener.Diagnostics().Values.SingleOrDefault(v => v.Key == "display_time").Value;
        int Lines(string of) => _played.Cell.Messages.Count(m => m.Contains(of));
        HeadsetTime Right(FrameTime _) => _played.Cell.Clock.Read + TimeSpan.FromMilliseconds(40);
        // Simulates a fault that reads counts of 24 MHz as counts of 10 MHz. On a device that has run for some time, the result is far ahead.
        HeadsetTime Wrong(FrameTime _) => new(_played.Cell.Clock.Read.SinceEpoch * 2.4);

        _played.Runtime.LightOf = t => Right(t);
        _played.Run(2);
        _played.Runtime.LightOf = t => Wrong(t);
        _played.Run(seconds);
        var (panel, diagnostic) = (Panel(), Diagnostic());
        texts.Update(_played.Session.Statistics, _played.Session.Settings, null, null);
        var message = texts.ValueOf(StatusRow.Message).Replace('\n', ' ');
        var lines = Lines("implausible");
        _played.Run(isReported ? 3 : 0);
        _played.Runtime.LightOf = t => Right(t);
        _played.Run(3);

        Assert.That(panel, Is.EqualTo(isReported ? "! 40.0 ms|" + StatusMessages.LatencyImplausible : "40.0 ms|" + StatusMessages.LatencySet));
        Assert.That(message == "! " + DisplayMessages.ImplausibleTimes(null), Is.EqualTo(isReported));
        Assert.That(diagnostic, Is.EqualTo(isReported ? "implausible" : null));
        Assert.That(lines, Is.EqualTo(isReported ? 1 : 0));
        Assert.That(Lines("implausible"), Is.EqualTo(isReported ? 1 : 0), "once, however long it lasts");
        Assert.That(Lines("plausible again"), Is.EqualTo(isReported ? 1 : 0));
        Assert.That(Panel(), Is.EqualTo("40.0 ms|" + StatusMessages.LatencyPredicted));
        Assert.That(Diagnostic(), Is.EqualTo("predicted"));
    }

    [Test]
    public void DisplayTime_BuildWithoutThePluginsLibrary_UsesTheCalibrationAndLogsItOnce()
    {
        _played.Play();
        _played.Runtime.LightOf = _ => throw new DllNotFoundException("MicrosoftOpenXRPlugin");

        _played.Run(8);

        Assert.That(_played.Session.Statistics.IsLightPredicted, Is.False);
        Assert.That(_played.Session.Frame.State, Is.EqualTo(PoseState.Current));
        Assert.That(
            _played.Cell.Messages.Count(m => m.Contains(DeviceMessages.NoDisplayTime(_played.Session.name, "MicrosoftOpenXRPlugin"))), Is.EqualTo(1));
    }

    [Test]
    public void DisplayTime_ClockOtherThanTheCounter_UsesTheCalibrationAndLogsItOnce()
    {
        _played.Session = _played.Cell.NewSession(robot: null, Settings(isRewritten: false));
        var own = new OtherClock(_played.Cell.Clock);
        _played.Session.HeadsetClock = own;
        _played.Runtime.Equip(_played.Session.gameObject.AddComponent<OpenXrDisplayTime>());
        _played.Session.gameObject.SetActive(true);
        _played.Runtime.LightOf = _ => _played.Cell.Clock.Read + TimeSpan.FromMilliseconds(47);

        _played.Run(1);

        Assert.That(_played.Session.Statistics.IsLightPredicted, Is.False);
        Assert.That(_played.Cell.Messages.Count(m => m.Contains(DeviceMessages.OtherClock)), Is.EqualTo(1));
    }

    [Test]
    public void OnEnable_NoSessionAbove_Warns()
    {
        new GameObject("Alone").AddComponent<OpenXrDisplayTime>();

        Assert.That(_played.Cell.Messages, Has.Some.Contains(ComponentMessages.ComponentWithoutSession("display time", "Alone")));
    }

    sealed class OtherClock(SteppedClock clock) : IHeadsetClock
    {
        public HeadsetTime Now => clock.Now;
    }
}
