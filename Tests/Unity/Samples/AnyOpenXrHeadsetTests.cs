using Nowpose.Unity;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Status;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.InputSystem;

namespace Nowpose.Unity.Tests.Samples;

/// <summary>Tests the camera and the buttons of the sample.</summary>
public sealed class AnyOpenXrHeadsetTests : AnyOpenXrHeadsetFixture
{
    CellActions Actions => _session.GetComponent<CellActions>();

    [Test]
    public void Scene_Played_LogsNoErrors()
    {
        Run(2);

        Assert.That(_cell.Player.Logs.Where(log => log.Type is LogType.Error or LogType.Exception).Select(log => log.Message), Is.Empty);
    }

    // The tracking space of a headset starts at the floor or at the head. The base is placed relative to the head in both cases.
    [TestCase(1.6f)]
    [TestCase(0.05f)]
    public void Head_Moves_CameraFollowsFromItsInitialHeight(float height)
    {
        var camera = _cell.Player.Find<Camera>().transform;
        MoveHead(new Vector3(0.1f, height, -0.2f), Quaternion.identity);
        var first = camera.position;

        MoveHead(new Vector3(0.2f, height - 0.1f, -0.2f), Quaternion.Euler(10, 20, 0));

        Assert.That((first - new Vector3(0.1f, 0, -0.2f)).magnitude, Is.LessThan(1e-5f));
        Assert.That((camera.position - new Vector3(0.2f, -0.1f, -0.2f)).magnitude, Is.LessThan(1e-5f));
        Assert.That(Quaternion.Angle(camera.rotation, Quaternion.Euler(10, 20, 0)), Is.LessThan(0.1f));
        Assert.That(Marker.transform.position.y, Is.EqualTo(-0.6f).Within(1e-5), "below the head, and not below the floor");
    }

    void MoveHead(Vector3 position, Quaternion rotation)
    {
        Controls.Set("<XRHMD>/centerEyePosition", position);
        Controls.Set("<XRHMD>/centerEyeRotation", rotation);
        Run(0.1);
    }

    // The controller of Magic Leap 2 has a menu button and no primary button.
    [TestCase("{PrimaryButton}")]
    [TestCase("{MenuButton}")]
    public void ConnectButton_PressedTwice_ConnectsAndDisconnects(string button)
    {
        Assert.That(_session.IsConnecting, Is.False, "the scene does not connect by itself");

        Press("<XRController>{RightHand}/" + button);
        Assert.That(_session.IsConnecting);

        Press("<XRController>{RightHand}/" + button);
        Assert.That(_session.IsConnecting, Is.False);
    }

    [TestCase("{SecondaryButton}")]
    [TestCase("{TriggerButton}")]
    public void PanelButton_Pressed_HidesThePanel(string button)
    {
        Press("<XRController>{RightHand}/" + button);

        Assert.That(Actions.IsPanelShown, Is.False);
    }

    [TestCase("<XRController>{LeftHand}/{PrimaryButton}")]
    [TestCase("<Keyboard>/g")]
    public void GhostButton_Pressed_TogglesTheGhostOncePerPress(string path)
    {
        Press(path);
        Assert.That(Actions.IsGhostShown);

        Press(path);
        Assert.That(Actions.IsGhostShown, Is.False);
    }

    [Test]
    public void OtherButtons_Pressed_TriggerTheirActions()
    {
        Press("<Keyboard>/c");
        Press("<XRController>{LeftHand}/{SecondaryButton}");
        Press("<XRController>{RightHand}/{Primary2DAxis}/right");
        Press("<XRController>{RightHand}/{Primary2DAxis}/right");
        Press("<Keyboard>/downArrow");

        Assert.That(Actions.IsConnecting);
        Assert.That(Actions.IsOcclusionOn, Is.False);
        Assert.That(Actions.NudgeMs, Is.EqualTo(2));
        Assert.That(Actions.Opacity, Is.EqualTo(0.9f).Within(1e-6));
    }

    [Test]
    public void CalibrationButtons_Pressed_ShiftTheRobotAndReportOnThePanel()
    {
        var nudge = _session.GetComponent<LatencyNudge>();
        Assert.That(nudge.enabled, Is.False, "as in the prefab");

        Press("<XRController>{LeftHand}/{Primary2DAxis}/right");
        Press("<Keyboard>/k");
        Press("<XRController>{LeftHand}/{Primary2DAxis}/left");
        Run(0.5);
        Assert.That((nudge.enabled, nudge.OffsetMm), Is.EqualTo((true, 1f)));
        Assert.That(Message, Is.EqualTo(NudgeReports.Progress(1, NudgeAxis.X, 0, 0)));

        Press("<XRController>{LeftHand}/{Primary2DAxisClick}");
        Run(0.5);
        Assert.That(Message, Is.EqualTo("! " + NudgeReports.NotSteady), "the mark");

        Press("<XRController>{LeftHand}/{GripButton}");
        Run(0.5);
        Assert.That(Message, Is.EqualTo("! " + nudge.Problem).And.Not.EqualTo("! " + NudgeReports.NotSteady), "the result");

        Press("<XRController>{LeftHand}/{TriggerButton}");
        Run(0.5);
        Assert.That(nudge.Problem, Is.Null);
    }

    // The message of the panel without line breaks.
    string Message => _session.GetComponentInChildren<StatusPanel>().Texts.ValueOf(StatusRow.Message).Replace('\n', ' ');
}
