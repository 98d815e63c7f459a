using Nowpose.Gateway.Plants;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using NUnit.Framework;
using UnityEngine;
using static Nowpose.Unity.Tests.Hatched;
using static Nowpose.Unity.Tests.Rendering.PlayedAppearance;

namespace Nowpose.Unity.Tests.Rendering;

/// <summary>Tests objects and robots below one another. The state of each determines only the look of its own parts, and of what stands on it.</summary>
public class NestedAppearanceTests : PlayedParts
{
    (RobotRig Rig, Renderer Part) NewRobot(Transform parent, string robotNamespace = "")
    {
        var made = new GameObject("Robot" + robotNamespace);
        made.SetActive(false);
        made.transform.SetParent(parent, false);
        var rig = made.AddComponent<RobotRig>().With("_session", _session).With("_robotNamespace", robotNamespace)
            .With("_description", RobotDescriptionAsset.Create("second", RobotFiles.LoadText("youbot")));
        made.AddComponent<PoseAppearance>().With("_session", _session);
        var part = Part("arm", made.transform);
        made.SetActive(true);
        return (rig, part);
    }

    (TrackedObject Shown, Renderer Part) NewObject(string name, Transform parent)
    {
        var shown = Below<TrackedObject>(name, parent);
        return (shown, Part("look of " + name, shown.transform));
    }

    void SendSecond(double t)
    {
        var joints = RobotFiles.Load("youbot").MovingJoints.Select(joint => joint.Name).ToArray();
        _session.Session.Listener.Received(
            new JointStateMessage(At(t), joints, joints.Select(_ => 0.003).ToArray()), HeadsetTime.FromSeconds(1000 + t + Latency), "arm2");
    }

    [Test]
    public void Show_RobotBecomesCurrent_ObjectWithoutAPoseStaysHidden()
    {
        var (rig, arm) = NewRobot(_session.transform);
        var (_, box) = NewObject("box", rig.transform);
        _cell.IsPlantUp = false;
        Run(1);
        Assert.That((arm.isVisible, box.isVisible), Is.EqualTo((false, false)));

        _cell.IsPlantUp = true;
        Run(1);

        Assert.That(_session.Frame.State, Is.EqualTo(PoseState.Current));
        Assert.That((arm.isVisible, box.isVisible), Is.EqualTo((true, false)), "no pose of the object has arrived");
        Assert.That(rig.GetComponent<PoseAppearance>().PartCount, Is.EqualTo(rig.GetComponentsInChildren<Renderer>(true).Length - 1));
    }

    [Test]
    public void Show_ObjectBelowDestroyed_LabelIsThatOfTheRemainingParts()
    {
        var (pallet, _) = NewObject("pallet", _session.transform);
        var (workpiece, _) = NewObject("workpiece", pallet.transform);
        var appearance = pallet.GetComponent<PoseAppearance>();
        workpiece.GetComponent<PoseAppearance>().enabled = false;
        _cell.IsPlantUp = false;
        void Send(double t)
        {
            SendPose("world", "pallet", t, Along(t));
            SendPose("world", "workpiece", t, Along(t));
        }
        Run(1, Send);
        Assert.That((pallet.State, workpiece.State, appearance.Look.Label), Is.EqualTo((PoseState.Current, PoseState.Current, "")));

        UnityEngine.Object.Destroy(workpiece.gameObject);
        Run(0.1, Send);

        Assert.That((pallet.State, _session.Frame.State), Is.EqualTo((PoseState.Current, PoseState.Incomplete)));
        Assert.That((appearance.Look.Label, appearance.PartCount), Is.EqualTo(("", 1)));
    }

    [Test]
    public void Show_RobotBecomesCurrentAgain_StoppedObjectStaysStriped()
    {
        var (rig, arm) = NewRobot(_session.transform);
        var (_, box) = NewObject("box", rig.transform);
        Run(2, t => SendPose("world", "box", t, Along(t)));
        Assert.That((IsHatched(arm), IsHatched(box)), Is.EqualTo((false, false)));

        Run(1);
        _cell.IsPlantUp = false;
        Run(1);
        Assert.That((IsHatched(arm), IsHatched(box)), Is.EqualTo((true, true)));
        _cell.IsPlantUp = true;
        Run(1);

        Assert.That((IsHatched(arm), IsHatched(box)), Is.EqualTo((false, true)));
    }

    [Test]
    public void Show_RobotOnAnObject_IsNeverMoreCurrentThanTheObject([Values] bool isSameObject)
    {
        var vehicle = NewObject("vehicle", _session.transform);
        var rig = isSameObject ? vehicle.Shown.gameObject.AddComponent<RobotRig>().With("_session", _session) : NewRobot(vehicle.Shown.transform).Rig;
        var arm = Part("tool", rig.transform);
        void Send(double t) => SendPose("world", "vehicle", t, Along(t));
        Run(2, Send);
        Assert.That(IsHatched(arm), Is.False);

        _cell.IsPlantUp = false;
        Run(1, Send);
        Assert.That((vehicle.Shown.State, IsHatched(arm)), Is.EqualTo((PoseState.Current, true)), "the joints have stopped");
        _cell.IsPlantUp = true;
        Run(1, Send);
        Assert.That(IsHatched(arm), Is.False);

        Run(1);
        Assert.That((_session.Frame.State, IsHatched(arm)), Is.EqualTo((PoseState.Current, true)), "the vehicle has stopped");
    }

    [Test]
    public void Show_RobotOnARobot_IsNeverMoreCurrentThanTheLower()
    {
        var (lower, _) = NewRobot(_session.transform);
        var (_, arm) = NewRobot(lower.transform, "arm2");
        Run(2, SendSecond);
        Assert.That(IsHatched(arm), Is.False);

        _cell.IsPlantUp = false;
        Run(1, SendSecond);
        Assert.That(IsHatched(arm), Is.True);
        _cell.IsPlantUp = true;
        Run(1, SendSecond);
        Assert.That((IsHatched(arm), arm.isVisible), Is.EqualTo((false, true)));

        lower.enabled = false;
        Run(0.1, SendSecond);
        Assert.That(arm.isVisible, Is.False, "nothing moves the lower robot");
    }

    [Test]
    public void Show_GripperOfAnotherRobotElsewhere_HasTheStateOfThatRobot()
    {
        var (second, _) = NewRobot(_session.transform, "arm2");
        var gripper = Child("Gripper", _session.transform).AddComponent<VirtualGripper>().With("_rig", second);
        gripper.gameObject.AddComponent<PoseAppearance>();
        var palm = Part("Palm", gripper.transform);
        Run(2, SendSecond);
        Assert.That(IsHatched(palm), Is.False);

        Run(1);

        Assert.That((_session.Frame.State, IsHatched(palm)), Is.EqualTo((PoseState.Current, true)));
    }

    [Test]
    public void Enable_AddedBelowAnotherAppearance_TakesOverTheOriginalLook()
    {
        var (rig, _) = NewRobot(_session.transform);
        var sign = Part("Sign", rig.transform);
        Run(2);
        _cell.IsPlantUp = false;
        Run(1);
        Assert.That(IsHatched(sign), Is.True);

        sign.gameObject.AddComponent<PoseAppearance>();
        Run(0.1);
        Assert.That(IsHatched(sign), Is.True);
        _cell.IsPlantUp = true;
        Run(1);

        Assert.That((IsHatched(sign), sign.isVisible), Is.EqualTo((false, true)), "the stripes are not its own look");
    }

    [Test]
    public void Show_SignalNotCurrent_StripesThePartsAtAndBelowItsObject()
    {
        var conveyor = Below<TrackedObject>("conveyor", _session.transform);
        var (lamp, belt) = (Part("lamp", conveyor.transform), Part("belt", conveyor.transform));
        var glow = Part("glow", lamp.transform);
        var signal = lamp.gameObject.AddComponent<CellSignal>();
        Below<CellSignal>("other", _session.transform);
        void Send(double t) => SendPose("world", "conveyor", t, Along(0));
        Run(1, Send);
        Assert.That((IsHatched(lamp), IsHatched(glow), IsHatched(belt)), Is.EqualTo((true, true, false)), signal.Fault);

        SendSignal("lamp", _cell.Now - 1, 1);
        Run(0.5, Send);
        Assert.That((IsHatched(lamp), IsHatched(glow), IsHatched(belt)), Is.EqualTo((false, false, false)));

        _session.Session.Listener.SignalStatusReceived(
            new JointStatusMessage([new JointReport("lamp", JointDataState.Stale, At(0), "node deleted")]), HeadsetTime.FromSeconds(1000));
        Run(0.1, Send);
        Assert.That((IsHatched(lamp), IsHatched(glow), IsHatched(belt)), Is.EqualTo((true, true, false)));
        Assert.That(conveyor.GetComponent<PoseAppearance>().Look.Reason, Is.EqualTo("node deleted"));

        _session.Session.Listener.SignalStatusReceived(new JointStatusMessage([]), HeadsetTime.FromSeconds(1000));
        Run(0.1, Send);
        Assert.That(IsHatched(lamp), Is.False);

        signal.enabled = false;
        Run(0.1, Send);
        Assert.That((IsHatched(lamp), IsHatched(belt)), Is.EqualTo((true, false)), "a disabled component follows no signal");
        Assert.That(conveyor.GetComponent<PoseAppearance>().Look.Reason, Is.EqualTo(ObjectMessages.Disabled("signal", "lamp")));
    }
}
