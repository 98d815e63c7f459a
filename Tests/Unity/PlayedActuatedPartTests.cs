using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Unity.Messages;
using NUnit.Framework;
using UnityEngine;
using static Nowpose.Unity.Tests.Hatched;

namespace Nowpose.Unity.Tests;

public class PlayedActuatedPartTests : PlayedParts
{
    [Test]
    public void ActuatedPart_ChangeReceivedLate_JoinsTheMotionOfATimelyChange()
    {
        var part = Below<ActuatedPart>("jaw", _session.transform).With("_wayMetres", new Vector3(0, 0, 0.02f)).With("_strokeMs", 300f);
        Run(1);
        SendSignal("jaw", _cell.Now - 1, 0);
        Run(0.5);
        Assert.That(part.Share, Is.Zero);

        var change = _cell.Now - Latency;
        SendSignal("jaw", change, 1);
        Run(0.1);

        var passed = _cell.Now + Visu - change;
        Assert.That(passed, Is.InRange(0.2, 0.25));
        var stroke = new Signals.ActuatedStroke(0, 1, 0.3);
        stroke.Change(0, At(0));
        stroke.Change(1, At(1));
        Assert.That(part.Share, Is.EqualTo(stroke.At(At(1 + passed))).Within(1e-4));
        Assert.That(part.transform.localPosition.z, Is.EqualTo(0.02 * part.Share).Within(1e-6));

        Run(0.5);
        Assert.That(part.Share, Is.EqualTo(1).Within(1e-6));
    }

    // While it is switched off, an object may be copied or, in a pool, get another place.
    [Test]
    public void ActuatedPart_ObjectIsSwitchedOff_ReturnsToThePoseForZero([Values(0f, 0.3f)] float place)
    {
        var part = Below<ActuatedPart>("jaw", _session.transform).With("_wayMetres", new Vector3(0, 0, 0.02f)).With("_strokeMs", 0f);
        Run(1);
        SendSignal("jaw", _cell.Now - 1, 1);
        Run(0.5);

        part.gameObject.SetActive(false);
        Assert.That((part.Share, part.transform.localPosition), Is.EqualTo((0f, Vector3.zero)));
        part.transform.localPosition = new Vector3(0, 0, place);
        part.gameObject.SetActive(true);
        Run(0.5);

        Assert.That(part.transform.localPosition.z, Is.EqualTo(place + 0.02f).Within(1e-6));
    }

    // A model in millimetres has the scale 0.001. A cell in miniature is scaled as a whole.
    [TestCase(0.001f, 1f)]
    [TestCase(0.001f, 0.1f)]
    [TestCase(1f, 0.1f)]
    public void ActuatedPart_BelowAScaledModel_MovesByItsWayInMetresOfTheCell(float model, float cell)
    {
        _session.transform.localScale = Vector3.one * cell;
        var scaled = Below<FrameProbe>("model", _session.transform).transform;
        scaled.localScale = Vector3.one * model;
        var part = Below<ActuatedPart>("door", scaled).With("_wayMetres", new Vector3(0, 0.02f, 0.5f)).With("_strokeMs", 0f);
        part.transform.localPosition = new Vector3(1, 2, 3);
        var start = part.transform.position;
        Run(1);

        SendSignal("door", _cell.Now - 1, 1);
        Run(0.5);

        Assert.That(Vector3.Distance(part.transform.position - start, new Vector3(0, 0.02f * cell, 0.5f * cell)), Is.LessThan(1e-5));
        SendSignal("door", _cell.Now - Latency, 0);
        Run(0.5);
        Assert.That(Vector3.Distance(part.transform.localPosition, new Vector3(1, 2, 3)), Is.LessThan(1e-5));
    }

    [Test]
    public void ActuatedPart_SignalNotCurrent_LooksDifferentUntilItIsCurrent()
    {
        var rig = Below<RobotRig>("Robot", _session.transform);
        var appearance = rig.gameObject.AddComponent<PoseAppearance>();
        var jaw = Below<ActuatedPart>("jaw", rig.transform);
        var (moved, other) = (Rendering.PlayedAppearance.Part("moved", jaw.transform), Rendering.PlayedAppearance.Part("other", rig.transform));
        appearance.Refresh();
        Run(1);
        Assert.That(_session.Frame.State, Is.EqualTo(PoseState.Current));
        Assert.That(
            (IsHatched(moved), IsHatched(other), appearance.Look.Label), Is.EqualTo((true, false, ObjectMessages.SignalNotCurrent)), jaw.Fault);

        SendSignal("jaw", _cell.Now - 1, 1);
        Run(0.5);
        Assert.That((IsHatched(moved), IsHatched(other), appearance.Look.Label), Is.EqualTo((false, false, "")));

        _session.Session.Listener.SignalStatusReceived(
            new JointStatusMessage([new JointReport("jaw", JointDataState.Refused, At(0), "signal jaw has the value NaN")]), HeadsetTime.FromSeconds(1000));
        Run(0.1);
        Assert.That((IsHatched(moved), IsHatched(other), appearance.Look.Reason), Is.EqualTo((true, false, "signal jaw has the value NaN")));
    }

    [Test]
    public void ActuatedPart_WithAnAppearanceOfItsOwn_DoesNotDependOnTheRobot()
    {
        var jaw = Below<ActuatedPart>("jaw", _session.transform);
        var part = Rendering.PlayedAppearance.Part("moved", jaw.transform);
        var appearance = jaw.gameObject.AddComponent<PoseAppearance>();
        _cell.IsPlantUp = false;
        Run(1);
        SendSignal("jaw", _cell.Now - 1, 1);
        Run(0.5);
        Assert.That(_session.Frame.State, Is.EqualTo(PoseState.Incomplete), "the robot has no samples");
        Assert.That((IsHatched(part), part.forceRenderingOff, appearance.Look.Label), Is.EqualTo((false, false, "")));

        _session.Session.Listener.SignalStatusReceived(
            new JointStatusMessage([new JointReport("jaw", JointDataState.Stale, At(0), "its source ended")]), HeadsetTime.FromSeconds(1000));
        Run(0.1);
        Assert.That((IsHatched(part), appearance.Look.Label), Is.EqualTo((true, ObjectMessages.SignalNotCurrent)));
    }

    [Test]
    public void ActuatedPart_TimeNotKnown_LooksUnsynchronised()
    {
        var jaw = Below<ActuatedPart>("jaw", _session.transform);
        var part = Rendering.PlayedAppearance.Part("moved", jaw.transform);
        var appearance = jaw.gameObject.AddComponent<PoseAppearance>();
        _cell.IsSyncUp = false;
        Run(1);

        Assert.That(IsHatched(part));
        Assert.That(appearance.Look.Label, Does.StartWith(PoseMessages.Of(PoseState.Unsynchronised)));
    }

    // A signal with the opening in millimetres would keep the jaw at its end.
    [TestCase(1.005, false)]
    [TestCase(42, true)]
    [TestCase(-1, true)]
    public void ActuatedPart_ValueOutsideItsStroke_LooksDifferentUntilAValueIsWithinIt(double value, bool isOutside)
    {
        var rig = Below<RobotRig>("Robot", _session.transform);
        var appearance = rig.gameObject.AddComponent<PoseAppearance>();
        var jaw = Below<ActuatedPart>("jaw", rig.transform).With("_strokeMs", 0f);
        var moved = Rendering.PlayedAppearance.Part("moved", jaw.transform);
        appearance.Refresh();
        Run(1);

        SendSignal("jaw", _cell.Now - 1, value);
        Run(0.5);
        var fault = isOutside ? ObjectMessages.ValueOutsideStroke(value) : null;
        Assert.That((jaw.Fault, IsHatched(moved), appearance.Look.Label), Is.EqualTo((fault, isOutside, isOutside ? ObjectMessages.OutsideStroke : "")));
        Assert.That(FaultsNow(), Is.EqualTo(isOutside ? "signal jaw: " + fault : ""));

        SendSignal("jaw", _cell.Now - Latency, 0.5);
        Run(0.5);
        Assert.That((jaw.Fault, jaw.Share, IsHatched(moved)), Is.EqualTo(((string)null, 0.5f, false)));
    }

    [Test]
    public void ActuatedPart_OnAnother_LooksDifferentIfEitherSignalIsNotCurrent()
    {
        var rig = Below<RobotRig>("Robot", _session.transform);
        var appearance = rig.gameObject.AddComponent<PoseAppearance>();
        var slide = Below<ActuatedPart>("slide", rig.transform);
        var jaw = Below<ActuatedPart>("jaw", slide.transform).With("_wayMetres", new Vector3(0, 0, 1));
        var box = Below<TrackedObject>("box", jaw.transform);
        var (moved, shown) = (Rendering.PlayedAppearance.Part("moved", jaw.transform), Rendering.PlayedAppearance.Part("shown", box.transform));
        void Send(double t) => SendPose("world", "box", t, Along(t));
        appearance.Refresh();
        Run(1, Send);
        SendSignal("jaw", _cell.Now - 1, 1);
        Run(0.5, Send);
        Assert.That((IsHatched(moved), IsHatched(shown), appearance.Look.Label),
            Is.EqualTo((true, false, ObjectMessages.SignalNotCurrent)), "the slide has no value");

        SendSignal("slide", _cell.Now - 1, 1);
        Run(0.5, Send);
        Assert.That((IsHatched(moved), appearance.Look.Label), Is.EqualTo((false, "")));

        jaw.enabled = false;
        jaw.enabled = true;
        var frames = 0;
        Run(0.1, Send, () => { if (frames++ > 0) Assert.That(jaw.Share, Is.EqualTo(1), "from the first frame on, because its signal changed long ago"); });
    }

    [Test]
    public void ActuatedPart_OnATrackedObject_ReportsTheConflictAndDoesNotMoveIt()
    {
        var box = Below<TrackedObject>("box", _session.transform);
        var part = box.gameObject.AddComponent<ActuatedPart>().With("_wayMetres", new Vector3(0, 0, 1)).With("_signal", "jaw");
        Run(1, t => SendPose("world", "box", t, Along(t)));
        SendSignal("jaw", _cell.Now - 1, 1);

        Run(1, t => SendPose("world", "box", t, Along(t)), () => AssertAt(box.transform, _session.transform, Along(_cell.Now + Visu), 1e-3));

        Assert.That(box.GetComponent<PoseAppearance>().Look.IsHatched, Is.False, "the tracked object itself is shown correctly");
        Assert.That(part.Fault, Is.EqualTo(ObjectMessages.OtherMover));
        Assert.That(_cell.Player.Logs.Count(log => log.Type == LogType.Error && log.Message.Contains(ObjectMessages.OtherMover)), Is.EqualTo(1));
    }

    [Test]
    public void ActuatedPart_OnALinkThatAJointMoves_ReportsTheConflictAndDoesNotMoveIt()
    {
        var rig = Below<RobotRig>("Robot", _session.transform);
        Run(1);
        var link = rig.Link("gripper_finger_link_l");
        var part = link.gameObject.AddComponent<ActuatedPart>().With("_wayMetres", new Vector3(0, 0, 1));
        SendSignal(link.name, _cell.Now - 1, 1);

        var rest = link.localPosition.z;
        Run(1, seen: () => Assert.That(link.localPosition.z, Is.EqualTo(rest).Within(0.02)));

        AssertConflict(part, ObjectMessages.MovedByJoint("Robot", "gripper_finger_joint_l"));
        UnityEngine.Object.Destroy(part);
        Run(0.1);
        Assert.That(FaultsNow(), Is.Empty);
    }

    [Test]
    public void ActuatedPart_OnALinkThatNoJointMoves_Moves()
    {
        var rig = Below<RobotRig>("Robot", _session.transform);
        Run(1);
        var part = rig.Tool.gameObject.AddComponent<ActuatedPart>();
        SendSignal(rig.Tool.name, _cell.Now - 1, 1);
        Run(1);

        Assert.That((part.Fault, part.Share), Is.EqualTo(((string)null, 1f)));
    }

    [Test]
    public void ActuatedPart_OnAFingerOfAGripper_MovesItOnlyWhenTheGripperDoesNot()
    {
        var rig = Below<RobotRig>("Robot", _session.transform);
        var gripper = Below<VirtualGripper>("Virtual Gripper", rig.transform);
        var finger = Below<FrameProbe>("Finger", gripper.transform).transform;
        gripper.With("_fingers", new List<GripperFinger> { new("gripper_finger_joint_l", finger) });
        var part = finger.gameObject.AddComponent<ActuatedPart>().With("_wayMetres", new Vector3(0, 0, 1)).With("_signal", "jaw");
        Run(1);
        SendSignal("jaw", _cell.Now - 1, 1);
        Run(1, seen: () => Assert.That(finger.localPosition.magnitude, Is.LessThan(0.02)));
        AssertConflict(part, ObjectMessages.MovedByGripper("Virtual Gripper", "gripper_finger_joint_l"));

        gripper.enabled = false;
        Run(1);
        Assert.That((part.Fault, part.Share, FaultsNow(), _session.Parts.Count), Is.EqualTo(((string)null, 1f, "", 1)));
        // The gripper left the finger at the displayed position of its joint at rest, which is 0 except for rounding.
        Assert.That((finger.localPosition - new Vector3(0, 0, 1)).magnitude, Is.LessThan(1e-6));
    }

    void AssertConflict(ActuatedPart part, string conflict)
    {
        Assert.That((part.Fault, part.Share), Is.EqualTo((conflict, 0f)));
        Assert.That(FaultsNow(), Is.EqualTo($"actuated part {part.name}: {conflict}"));
        var log = ComponentMessages.Of("actuated part", part.name, conflict);
        Assert.That(_cell.Player.Logs.Count(each => each.Type == LogType.Error && each.Message.EndsWith(log, StringComparison.Ordinal)), Is.EqualTo(1));
    }

    [TestCase(-3600)]
    [TestCase(3600)]
    public void ActuatedPart_ControlClockSteps_StaysAtItsPositionAndMovesFromThere(double step)
    {
        // With this start value, control times stay positive after the step.
        _cell.ControlStepSeconds = 7200;
        void Send(double value) =>
            SendSignal("jaw", _cell.Now - Latency + _cell.ControlStepSeconds, value, Latency - _cell.ControlStepSeconds);
        var part = Below<ActuatedPart>("jaw", _session.transform).With("_strokeMs", 300f);
        Run(1);
        Send(0);
        Run(0.5);
        Send(1);
        Run(1);
        var restarts = 0;
        _session.Session.Restarted += (_, _) => restarts++;

        _cell.ControlStepSeconds += step;
        Run(5, seen: () => Assert.That(part.Share, Is.EqualTo(1).Within(1e-6)));
        Assert.That(restarts, Is.EqualTo(1));

        Send(0);
        Run(0.03);
        Assert.That(part.Share, Is.InRange(0.05, 0.95), "moves");
        Run(0.5);
        Assert.That(part.Share, Is.Zero.Within(1e-6));
    }
}
