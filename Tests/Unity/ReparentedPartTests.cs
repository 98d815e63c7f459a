using Nowpose.Anchoring;
using Nowpose.Gateway.Plants;
using Nowpose.Kinematics;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Tests.Rendering;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Events;

namespace Nowpose.Unity.Tests;

/// <summary>Tests components that a script adds before it moves their object below the session, and rigs that a script configures.</summary>
public class ReparentedPartTests : PlayedParts
{
    [Test]
    public void TrackedObject_ParentSetAfterItWasEnabled_FollowsTheSession()
    {
        var tracked = Loose<TrackedObject>("box");

        tracked.transform.SetParent(_session.transform);
        Run(2, t => SendPose("world", "box", t, Along(0.1 * t)));

        Assert.That(tracked.State, Is.EqualTo(PoseState.Current));
    }

    [Test]
    public void StationaryObject_ParentSetAfterItWasEnabled_IsPlaced()
    {
        var placed = Loose<StationaryObject>("fixture");

        placed.transform.SetParent(_session.transform);
        Run(2, t => SendPose("world", "fixture", t, Along(1)));

        AssertAt(placed.transform, _session.transform, Along(1));
    }

    [Test]
    public void SignalParts_ParentSetAfterTheyWereEnabled_FollowTheSession()
    {
        var signal = Loose<CellSignal>("closed");
        var part = Loose<ActuatedPart>("closed");

        foreach (var each in new Component[] { signal, part }) each.transform.SetParent(_session.transform);
        Run(2);
        SendSignal("closed", _cell.Now - 1, 1);
        Run(0.5);

        Assert.That((signal.Value, part.Share), Is.EqualTo(((double?)1, 1f)));
    }

    [TestCase(true)]
    [TestCase(false)]
    public void Signal_NoLongerWithASession_RaisesThatItIsNotCurrent(bool isMoved)
    {
        var (onNotCurrent, reasons) = (new UnityEvent<string>(), new List<string>());
        onNotCurrent.AddListener(reasons.Add);
        var signal = Below<CellSignal>("closed", _session.transform).With("_onNotCurrent", onNotCurrent);
        if (!isMoved)
        {
            signal.transform.SetParent(null);
            signal.Follow(_session);
        }
        Run(1);
        SendSignal("closed", _cell.Now - 1, 1);
        Run(0.5);
        Assert.That(signal.Fault, Is.Null);
        reasons.Clear();

        if (isMoved) signal.transform.SetParent(null);
        else signal.Follow(null);
        Run(0.5);

        Assert.That(reasons, Is.EqualTo(new[] { StatusMessages.NoSession }));
    }

    [Test]
    public void Appearance_ParentSetAfterItWasEnabled_ShowsTheSessionsPose()
    {
        var rig = Loose<RobotRig>("Robot");
        var appearance = rig.gameObject.AddComponent<PoseAppearance>();

        rig.transform.SetParent(_session.transform);
        Run(2);

        Assert.That(rig.IsFollowing, Is.True);
        Assert.That(appearance.Look.Label, Is.Empty);
    }

    [TestCase(true)]
    [TestCase(false)]
    public void ActuatedPart_OtherParentDuringItsStroke_ContinuesFromItsPlaceThere(bool keepsWorldPose)
    {
        var (first, second) = (new GameObject("first"), new GameObject("second"));
        foreach (var tool in new[] { first, second }) tool.transform.SetParent(_session.transform, false);
        second.transform.localPosition = new Vector3(3, 0, 0);
        var jaw = Below<ActuatedPart>("jaw", first.transform).With("_wayMetres", new Vector3(0, 0, 0.02f)).With("_turnDegrees", new Vector3(0, 40, 0))
            .With("_strokeMs", 0f);
        jaw.transform.localPosition = new Vector3(0, 1, 0);
        Run(1);
        SendSignal("jaw", _cell.Now - 1, 0.5);
        Run(0.5);
        Assert.That(jaw.transform.localPosition.z, Is.EqualTo(0.01).Within(1e-6));

        jaw.transform.SetParent(second.transform, keepsWorldPose);
        var before = jaw.transform.localPosition;
        Run(0.1);
        Assert.That(Vector3.Distance(jaw.transform.localPosition, before), Is.LessThan(1e-6));
        Assert.That(Quaternion.Angle(jaw.transform.localRotation, Quaternion.Euler(0, 20, 0)), Is.LessThan(0.1));

        SendSignal("jaw", _cell.Now - Latency, 1);
        Run(0.5);
        Assert.That(Vector3.Distance(jaw.transform.localPosition, before + new Vector3(0, 0, 0.01f)), Is.LessThan(1e-6));
    }

    [Test]
    public void ActuatedPart_MovedBelowAnotherSession_KeepsItsPlaceThere()
    {
        var other = _cell.Play();
        var jaw = Below<ActuatedPart>("jaw", _session.transform).With("_wayMetres", new Vector3(0, 0, 0.02f)).With("_strokeMs", 0f);
        Run(1);
        SendSignal("jaw", _cell.Now - 1, 1);
        Run(0.5);

        jaw.transform.SetParent(other.transform, false);
        jaw.transform.localPosition = new Vector3(5, 0, 0.02f);
        jaw.transform.SetParent(_session.transform, false);

        Assert.That(Vector3.Distance(jaw.transform.localPosition, new Vector3(5, 0, 0.02f)), Is.LessThan(1e-6));
    }

    [Test]
    public void Appearance_RigFollowsASessionElsewhere_ShowsThatSession()
    {
        var rig = Loose<RobotRig>("Robot");
        var appearance = rig.gameObject.AddComponent<PoseAppearance>();
        var part = PlayedAppearance.Part("look", rig.transform);
        appearance.Refresh();
        Run(0.1);
        Assert.That((part.isVisible, Hatched.IsHatched(part)), Is.EqualTo((true, false)), "a script moves the robot");

        rig.Follow(_session);
        appearance.Refresh();
        Run(2);
        Assert.That((part.isVisible, appearance.Look.Label), Is.EqualTo((true, "")));

        _cell.IsPlantUp = false;
        Run(2);
        Assert.That((part.isVisible, Hatched.IsHatched(part)), Is.EqualTo((true, true)));
    }

    [Test]
    public void Rig_MovedBelowAnotherSession_FollowsIt()
    {
        var other = _cell.Play();
        var rig = Below<RobotRig>("Robot", _session.transform);
        Run(1);

        rig.transform.SetParent(other.transform);

        Assert.That(rig.Session, Is.SameAs(other));
    }

    [Test]
    public void Parts_MovedToAnotherBaseOfTheSession_AreShownThereWithTheLookOfThatBase()
    {
        var (first, second) = (Below<BaseAnchor>("first", _session.transform), Below<BaseAnchor>("second", _session.transform));
        second.transform.localPosition = new Vector3(3, 0, 1);
        first.Use("", [new BaseMarker("a", RigidTransform.Identity)]);
        var parts = new Dictionary<string, Component>
        {
            ["box"] = Below<TrackedObject>("box", first.transform),
            ["fixture"] = Below<StationaryObject>("fixture", first.transform),
            ["arm_link_0"] = Below<RobotRig>("Robot", first.transform),
        };
        var look = parts["box"].GetComponent<PoseAppearance>();
        void Send(double t)
        {
            foreach (var frame in parts.Keys) SendPose("world", frame, t, Along(1));
        }
        Run(2, Send);
        foreach (var part in parts.Values) AssertAt(part.transform, first.transform, Along(1));
        Assert.That(look.Look.Label, Is.EqualTo(BaseMessages.NotLockedLabel));

        foreach (var part in parts.Values) part.transform.SetParent(second.transform, false);
        Run(0.1, Send);

        foreach (var part in parts.Values) AssertAt(part.transform, second.transform, Along(1));
        Assert.That(look.Look.Label, Is.Empty);
    }

    [Test]
    public void Gripper_MovedToTheFlangeOfAnotherRig_FollowsThatRig()
    {
        var (first, second) = (Below<RobotRig>("First", _session.transform), Below<RobotRig>("Second", _session.transform));
        var loose = Loose<VirtualGripper>("loose");
        var gripper = Below<VirtualGripper>("gripper", first.transform);
        var mounted = Below<VirtualGripper>("mounted", first.transform);
        Run(0.5);
        mounted.Mount(second);

        gripper.transform.SetParent(second.Flange, false);
        loose.transform.SetParent(second.Flange, false);
        mounted.transform.SetParent(_session.transform, false);

        Assert.That((gripper.Rig, gripper.Flange), Is.EqualTo((second, second.Flange)));
        Assert.That((loose.Rig, mounted.Rig), Is.EqualTo((second, second)), "a mounted gripper keeps its rig");
    }

    [Test]
    public void GripByReach_MovedBelowAnotherRig_GripsWithThatRobot()
    {
        var grip = Loose<GripByReach>("grip");
        var rig = Below<RobotRig>("Robot", _session.transform);

        grip.transform.SetParent(rig.transform, false);
        Run(1);
        SendSignal("grip", _cell.Now - 1, 0);
        Run(0.5);
        Assert.That(grip.Fault, Is.Null);

        grip.transform.SetParent(null, false);
        Run(0.1);
        Assert.That((grip.Fault, _session.Parts.Count), Is.EqualTo((StatusMessages.NoRig, 0)));
    }

    [Test]
    public void Rig_SessionAssigned_KeepsItWithANewParent()
    {
        var rig = Loose<RobotRig>("Robot");
        rig.Follow(_session);

        rig.transform.SetParent(_cell.Play().transform);

        Assert.That(rig.Session, Is.SameAs(_session));
    }

    [Test]
    public void Follow_SessionNamespaceAndDescription_ShowsThatRobot()
    {
        var rig = Loose<RobotRig>("Second");
        var joints = RobotFiles.Load("youbot").MovingJoints.Select(joint => joint.Name).ToArray();

        rig.Follow(_session, "arm2", RobotDescriptionAsset.Create("second", RobotFiles.LoadText("youbot")));
        Run(2, t => _session.Session.Listener.Received(
            new JointStateMessage(At(t), joints, joints.Select(_ => 0.003).ToArray()), HeadsetTime.FromSeconds(1000 + t + Latency), "arm2"));

        Assert.That((rig.RobotNamespace, rig.IsFollowing), Is.EqualTo(("arm2", true)));
        Assert.That(rig.Joints[0], Is.EqualTo(0.003).Within(1e-6));
    }

    [Test]
    public void Follow_Held_ShowsTheNewestSamples()
    {
        var rig = Below<RobotRig>("Ghost", _session.transform);

        rig.Follow(null, shows: RigPose.Held);
        Run(3);

        Assert.That((rig.Session, rig.Shows), Is.EqualTo((_session, RigPose.Held)));
        Assert.That(rig.Joints.ToArray(), Is.EqualTo(_session.Frame.HeldJoints.ToArray()));
        Assert.That(rig.Joints[0], Is.Not.EqualTo(_session.Frame.Joints[0]));
    }

    [Test]
    public void Follow_RigDisabled_AppliesWhenItIsEnabled()
    {
        var rig = Loose<RobotRig>("Robot");
        rig.enabled = false;

        rig.Follow(_session);
        Assert.That(rig.Session, Is.Null);
        rig.enabled = true;

        Assert.That(rig.Session, Is.SameAs(_session));
    }
}
