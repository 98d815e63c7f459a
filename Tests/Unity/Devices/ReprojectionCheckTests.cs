using Nowpose.Latency;
using Nowpose.Messages;
using Nowpose.OpenXR;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Status;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.XR.OpenXR;
using DisplayMode = UnityEngine.XR.XRDisplaySubsystem.ReprojectionMode;
using PluginMode = Microsoft.MixedReality.OpenXR.ReprojectionMode;
using ReprojectionMode = Nowpose.Latency.ReprojectionMode;

namespace Nowpose.Unity.Tests.Devices;

public sealed class ReprojectionCheckTests
{
    PlayedCell _cell;
    PlayedDisplay _display;
    MrilSession _session;
    ReprojectionCheck _check;

    [SetUp]
    public void SetUp()
    {
        _cell = new PlayedCell();
        _display = new PlayedDisplay(_cell.Player);
    }

    [TearDown]
    public void TearDown()
    {
        _display.Dispose();
        _cell.Dispose();
    }

    void Play(double seconds)
    {
        _session = _cell.NewSession();
        _check = _session.gameObject.AddComponent<ReprojectionCheck>();
        _session.gameObject.SetActive(true);
        _cell.Run(seconds, _session);
    }

    // Removes the one requirement of depth submission whose absence causes the given state.
    void Break(DepthSubmission how)
    {
        switch (how)
        {
            case DepthSubmission.TurnedOff:
                OpenXRSettings.Instance.depthSubmissionMode = OpenXRSettings.DepthSubmissionMode.None;
                break;
            case DepthSubmission.NotSupported:
                OpenXRRuntime.Extensions.Clear();
                break;
            case DepthSubmission.NoMainCamera:
                _display.Camera.enabled = false;
                break;
            case DepthSubmission.NotRequested:
                _display.Display.AsksForDepth = false;
                break;
        }
    }

    string Panel()
    {
        var texts = new StatusTexts();
        texts.Update(_session.Statistics, _session.Settings, null, null);
        return texts.ValueOf(StatusRow.Message).Replace('\n', ' ');
    }

    string Diagnostic(string key) => _session.Session.Listener.Diagnostics().Values.SingleOrDefault(v => v.Key == key).Value;

    int Lines(string of) => _cell.Messages.Count(m => m.Contains(of));

    [Test]
    public void Update_AllConditionsMet_DepthIsActiveAndModeIsDepth()
    {
        Play(2);

        Assert.That(_session.Statistics.DepthSubmission, Is.EqualTo(DepthSubmission.Active));
        Assert.That(_session.Statistics.Reprojection, Is.EqualTo(ReprojectionMode.Depth));
        Assert.That(Diagnostic("depth_submission"), Is.EqualTo("active"));
        Assert.That(Diagnostic("reprojection"), Is.EqualTo("depth"));
        Assert.That(Lines("depth is submitted"), Is.EqualTo(1));
        Assert.That(Panel(), Does.Not.Contain("depth"));
    }

    [Test]
    public void Update_ConditionMissing_LogsTheProblemAndTheRecoveryOnce(
        [Values(DepthSubmission.TurnedOff, DepthSubmission.NotSupported, DepthSubmission.NoMainCamera, DepthSubmission.NotRequested)]
        DepthSubmission broken)
    {
        Break(broken);
        Play(4);
        var (panel, depth, mode) = (Panel(), Diagnostic("depth_submission"), _session.Statistics.Reprojection);
        var lines = Lines(" submitted: ");

        _display.Dispose();
        _cell.Player.World.Gpu.Display.AsksForDepth = true;
        using var mended = new PlayedDisplay(_cell.Player);
        _cell.Run(3, _session);

        Assert.That(panel, Does.Contain(DepthSubmissionMessages.ProblemOf(broken)));
        Assert.That(depth, Is.EqualTo(LatencyNames.DepthSubmission.NameOf(broken)));
        Assert.That(mode, Is.EqualTo(ReprojectionMode.Unknown));
        Assert.That(lines, Is.EqualTo(1));
        Assert.That(Lines("depth is submitted again"), Is.EqualTo(1));
        Assert.That(Panel(), Does.Not.Contain("depth"));
    }

    [TestCase(DisplayMode.Unspecified, ReprojectionMode.Depth)]
    [TestCase(DisplayMode.PositionAndOrientation, ReprojectionMode.Depth)]
    [TestCase(DisplayMode.OrientationOnly, ReprojectionMode.OrientationOnly)]
    [TestCase(DisplayMode.None, ReprojectionMode.None)]
    public void Update_ModeRequestedFromTheDisplay_IsReported(DisplayMode asked, ReprojectionMode expected)
    {
        _display.Display.reprojectionMode = asked;

        Play(2);

        Assert.That(_session.Statistics.Reprojection, Is.EqualTo(expected));
        Assert.That(_check.Mode, Is.EqualTo(expected));
    }

    [Test]
    public void Update_RuntimeWithoutDepthMode_ModeIsUnknown()
    {
        using var display = new PlayedDisplay(_cell.Player, PluginMode.OrientationOnly);

        Play(2);

        Assert.That(_session.Statistics.Reprojection, Is.EqualTo(ReprojectionMode.Unknown));
        Assert.That(_session.Statistics.DepthSubmission, Is.EqualTo(DepthSubmission.Active));
    }

    [Test]
    public void Update_NoRuntime_IsUnknownWithoutAMessage()
    {
        _display.Dispose();

        Play(5);

        Assert.That(_session.Statistics.DepthSubmission, Is.EqualTo(DepthSubmission.Unknown));
        Assert.That(Lines("depth"), Is.Zero);
    }

    [Test]
    public void Update_BuildWithoutThePluginsLibrary_IsUnknownAndWarnsOnce()
    {
        OpenXRRuntime.Fault = new DllNotFoundException("UnityOpenXR");

        Play(5);

        Assert.That(_session.Statistics.DepthSubmission, Is.EqualTo(DepthSubmission.Unknown));
        Assert.That(Lines("UnityOpenXR; it is unknown whether depth is submitted"), Is.EqualTo(1));
    }

    [Test]
    public void OnDisable_StateKnown_BecomesUnknown()
    {
        Play(2);

        _check.enabled = false;

        Assert.That(_session.Reprojection, Is.EqualTo(ReprojectionMode.Unknown));
        Assert.That(_session.DepthSubmission, Is.EqualTo(DepthSubmission.Unknown));
    }

    [Test]
    public void OnEnable_NoSessionAbove_Warns()
    {
        new GameObject("Alone").AddComponent<ReprojectionCheck>();

        Assert.That(_cell.Messages, Has.Some.Contains(ComponentMessages.ComponentWithoutSession("reprojection check", "Alone")));
    }

    [Test]
    public void Update_AfterWarmUp_AllocatesNothing()
    {
        Play(10);

        Assert.That(_cell.AllocatedIn(() => _cell.Run(2, _session)), Is.Zero);
    }
}
