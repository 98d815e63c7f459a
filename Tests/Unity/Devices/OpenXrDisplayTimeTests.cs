using Nowpose.Latency;
using Nowpose.Latency.Profile;
using Nowpose.Unity.Messages;
using NUnit.Framework;
using UnityEngine;
using static Nowpose.Unity.Tests.Devices.PlayedDisplayTime;

namespace Nowpose.Unity.Tests.Devices;

/// <summary>Tests that the session uses the display time that the OpenXR runtime predicts.</summary>
public sealed class OpenXrDisplayTimeTests
{
    static readonly LatencyProfile Profile = new(CalibratedMs, 1, "", 0, DateTime.UnixEpoch, CalibrationMethod.Nudge, 3);

    PlayedDisplayTime _played;

    [SetUp]
    public void SetUp() => _played = new PlayedDisplayTime();

    [TearDown]
    public void TearDown() => _played.Dispose();

    [TestCase(false)]
    [TestCase(true)]
    public void DisplayTime_LatencyVariesByEightMilliseconds_IsCompensatedOnlyWithTheComponent(bool isRewritten)
    {
        _played.Play(isRewritten);
        _played.Runtime.LightOf = tick => _played.Predicted(tick, isRewritten);

        var with = _played.ErrorMm();
        _played.Component.enabled = false;
        var without = _played.ErrorMm();

        Assert.That(without, Is.InRange(2.3, 3.4), "8 ms at 0.35 m/s RMS: the effect");
        Assert.That(with, Is.LessThan(0.2 * without), "only the error of the prediction remains");
    }

    [TestCase(10_000_000)]
    [TestCase(19_200_000)]
    [TestCase(24_000_000)]
    [TestCase(1_015_592)]
    public void DisplayTime_CounterOfAnyFrequency_IsExactToOneCount(long countsPerSecond)
    {
        _played.Runtime.Dispose();
        _played.Runtime = new PlayedRuntime(_played.Cell.Clock, countsPerSecond);
        _played.Play();
        _played.Runtime.LightOf = _ => _played.Session.Session == null ? null : _played.Cell.Clock.Read + TimeSpan.FromMilliseconds(47);

        _played.Run(2);

        Assert.That(_played.Session.Statistics.IsLightPredicted);
        Assert.That(_played.Session.Statistics.VisualisationLatency.TotalMilliseconds, Is.EqualTo(47).Within(2 * (1000.0 / countsPerSecond + 1e-4)));
        Assert.That(_played.Session.Statistics.IsDisplayTimeImplausible, Is.False);
        Assert.That(_played.Cell.Messages.Count(m => m.Contains($"performance counter {countsPerSecond} Hz, stopwatch 10000000 Hz")), Is.EqualTo(1));
    }

    [Test]
    public void DisplayTime_SessionRestarted_IsUsedAgain()
    {
        _played.Play();
        _played.Runtime.LightOf = _ => _played.Cell.Clock.Read + TimeSpan.FromMilliseconds(47);
        _played.Run(1);

        _played.Session.Settings = Settings(isRewritten: true);
        _played.Run(1);

        Assert.That(_played.Session.Statistics.IsLightPredicted);
    }

    [TestCase(false)]
    [TestCase(true)]
    public void DisplayTime_DiffersFromTheSetValue_UsesTheRuntimeAndReportsTheDifference(bool isCalibrated)
    {
        _played.Play();
        if (isCalibrated) _played.Session.Session.Calibrate(Profile);
        _played.Runtime.LightOf = _ => _played.Cell.Clock.Read + TimeSpan.FromMilliseconds(47);

        _played.Run(4);

        Assert.That(_played.Session.Statistics.IsDisplayTimeInconsistent);
        Assert.That(_played.Session.Statistics.DisplayTimeDifference.Value.TotalMilliseconds, Is.EqualTo(7).Within(0.01));
        Assert.That(_played.Session.Statistics.VisualisationLatency.TotalMilliseconds, Is.EqualTo(47).Within(0.01));
        Assert.That(_played.Cell.Messages.Count(m => m.Contains(SessionMessages.LatenciesDiffer)), Is.EqualTo(isCalibrated ? 1 : 0));
        Assert.That(
            _played.Cell.Messages.Count(m => m.Contains(SessionMessages.LatencyNotVerified(47, CalibratedMs))), Is.EqualTo(isCalibrated ? 0 : 1));
    }

    [TestCase(false, 1)]
    [TestCase(true, 0)]
    public void DisplayTime_RewriteBeforeRenderOff_IsReportedOnce(bool isRewritten, int reports)
    {
        _played.Play(isRewritten);

        _played.Run(2);

        Assert.That(_played.Cell.Messages.Count(m => m.Contains(DeviceMessages.NotRewritten(_played.Component.name))), Is.EqualTo(reports));
    }

    [Test]
    public void OnDisable_AnotherSourceAssigned_KeepsThatSource()
    {
        _played.Play();
        var other = new OtherSource();
        _played.Session.DisplayTimeSource = other;

        _played.Component.enabled = false;

        Assert.That(_played.Session.DisplayTimeSource, Is.SameAs(other));
    }

    [Test]
    public void DisplayTime_AfterWarmUp_AllocatesNothing()
    {
        _played.Play();
        _played.Runtime.LightOf = _ => _played.Cell.Clock.Read + TimeSpan.FromMilliseconds(47);
        _played.Run(3);
        var start = _played.Cell.Clock.Read;

        var before = GC.GetAllocatedBytesForCurrentThread();
        for (var i = 0; i < 100; i++) _played.Component.LightOf(start);

        Assert.That(GC.GetAllocatedBytesForCurrentThread() - before, Is.Zero);
    }

    sealed class OtherSource : IDisplayTimeSource
    {
        public HeadsetTime? LightOf(HeadsetTime frameStart) => null;
    }
}
