using Nowpose.Frames;
using Nowpose.Gateway.Plants;
using Nowpose.Messages;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using Nowpose.Session;
using Nowpose.Unity.Messages;
using NUnit.Framework;
using UnityEngine;
using static Nowpose.Unity.Tests.Hatched;

namespace Nowpose.Unity.Tests;

public class PlayedNamespaceTests : PlayedParts
{
    [Test]
    public void Rig_ListenerEndsTheSession_TheRobotDoesNotLookCurrent()
    {
        var rig = Below<RobotRig>("Robot", _session.transform);
        var grip = Below<GripByReach>("grip", rig.transform);
        var appearance = rig.gameObject.AddComponent<PoseAppearance>();
        var part = Rendering.PlayedAppearance.Part("part", rig.transform);
        Below<TrackedObject>("box", rig.transform);
        appearance.Refresh();
        Run(1);
        Assert.That(IsHatched(part), Is.False);

        rig.Posed += () => _session.enabled = false;
        Run(0.1);

        Assert.That((_session.Session, IsHatched(part), grip.Fault), Is.EqualTo(((CompensationSession)null, true, grip.Fault)));
        Assert.That(_cell.Player.Logs.Where(log => log.Exception != null), Is.Empty);
    }

    [Test]
    public void Rig_WithNamespace_ShowsItsRobotOnItsMovingBase()
    {
        var text = RobotFiles.LoadText("youbot");
        var rig = Second(text);
        var joints = RobotFiles.Load("youbot").MovingJoints.Select(joint => joint.Name).ToArray();
        void Send(double t, bool isBaseSent = true)
        {
            _session.Session.Listener.Received(
                new JointStateMessage(At(t), joints, joints.Select(_ => 0.003).ToArray()), HeadsetTime.FromSeconds(1000 + t + Latency), "arm2");
            if (isBaseSent) SendPose("world", "arm2/arm_link_0", t, Along(0.1 * t));
        }
        Run(2, t => Send(t));

        Assert.That(rig.IsFollowing, Is.True);
        Assert.That(rig.Joints[0], Is.EqualTo(0.003).Within(1e-6));
        AssertAt(rig.transform, _session.transform, Along(0.1 * (_cell.Now + Visu)), 1e-3);
        Assert.That(rig.StateIn(_session.Frame), Is.EqualTo(PoseState.Current));

        Assert.That(FaultsNow(), Is.Empty);
        Run(1, t => Send(t, isBaseSent: false));
        Assert.That(rig.StateIn(_session.Frame), Is.EqualTo(PoseState.Held), "the robot is not where its base was");
        Assert.That(FaultsNow(), Is.EqualTo(RobotMessages.OfRobot("arm2", StatusMessages.BaseNotCurrent)));
        AssertStoppedBefore(1);
        Run(2, t => Send(t));
        Assert.That(rig.StateIn(_session.Frame), Is.EqualTo(PoseState.Current));

        Run(1);
        Assert.That(rig.StateIn(_session.Frame), Is.EqualTo(PoseState.Held), "only the robot whose source has ended is held");
        Assert.That(FaultsNow(), Does.StartWith("robot arm2: joints arm_joint_1, arm_joint_2, "));
        AssertStoppedBefore(1);
        Assert.That(_session.Frame.State, Is.EqualTo(PoseState.Current));
        Assert.That(_session.Session.Robots.WorstPose, Is.EqualTo(PoseState.Held));
        rig.gameObject.SetActive(false);
        Assert.That(FaultsNow(), Is.Empty, "a robot that is not shown has no row");
        Assert.That(_session.Session.Robots.WorstPose, Is.EqualTo(PoseState.Current), "and does not count for the state of the cell");
    }

    [Test]
    public void Rig_NamespaceIsNotServed_HasAFaultThatNamesTheServedNamespaces()
    {
        Second(RobotFiles.LoadText("youbot"));
        Run(0.5);

        _session.Session.Listener.NamespacesReceived(["arm1", "arm3"]);
        Run(0.5);

        Assert.That(FaultsNow(), Is.EqualTo(RobotMessages.OfRobot("arm2", RobotMessages.OtherNamespaces("arm2", ["arm1", "arm3"]))));
    }

    [Test]
    public void Rig_WithNamespaceBeyondItsLimitsOrWithAnotherDescription_HasAFault()
    {
        Second(RobotFiles.LoadText("ur5"));
        var joints = RobotFiles.Load("ur5").MovingJoints.Select(joint => joint.Name).ToArray();
        void Send(double t, double first) => _session.Session.Listener.Received(
            new JointStateMessage(At(t), joints, [first, .. joints[1..].Select(_ => 0.1)]), HeadsetTime.FromSeconds(1000 + t + Latency), "arm2");
        Run(2, t => Send(t, 0.1));
        Assert.That(FaultsNow(), Is.Empty);

        _session.Session.Listener.Described(RobotFiles.LoadText("youbot"), "arm2");
        Run(0.2, t => Send(t, 0.1));
        Assert.That(FaultsNow(), Is.EqualTo(RobotMessages.OfRobot("arm2", RobotMessages.DescriptionDiffers)));

        _session.Session.Listener.Described(RobotFiles.LoadText("ur5"), "arm2");
        Run(1, t => Send(t, 45));
        var found = _session.Session.Robots[1].Limits.Present;
        Assert.That(found.Joint.Name, Is.EqualTo(joints[0]));
        Assert.That(FaultsNow(), Is.EqualTo(RobotMessages.OfRobot("arm2", found.Words)));
        Assert.That(_cell.Messages, Has.Exactly(1).Contains(RobotMessages.OfRobot("arm2", found.Words)));
    }

    [Test]
    public void Rig_WithNamespaceWhoseStampsGetAheadByMoreThanASecond_ReportsTheStampsInsteadOfJointsWithoutData()
    {
        Second(RobotFiles.LoadText("ur5"));
        var joints = RobotFiles.Load("ur5").MovingJoints.Select(joint => joint.Name).ToArray();
        void Send(double t, double ahead) => _session.Session.Listener.Received(
            new JointStateMessage(At(t + ahead), joints, [.. joints.Select(_ => 0.1)]), HeadsetTime.FromSeconds(1000 + t + Latency), "arm2");

        Run(2, t => Send(t, 0));
        Run(3, t => Send(t, 2));

        Assert.That(FaultsNow(), Is.EqualTo(RobotMessages.OfRobot("arm2", RobotMessages.StampsAhead)));
    }

    // The poses of the last session remain where they were, but nothing reports whether they are still right.
    [Test]
    public void CellParts_SessionHasEnded_AreNotCurrent()
    {
        Second(RobotFiles.LoadText("ur5"));
        var joints = RobotFiles.Load("ur5").MovingJoints.Select(joint => joint.Name).ToArray();
        var box = Below<TrackedObject>("box", _session.transform);
        Run(2, t =>
        {
            _session.Session.Listener.Received(
                new JointStateMessage(At(t), joints, [.. joints.Select(_ => 0.1)]), HeadsetTime.FromSeconds(1000 + t + Latency), "arm2");
            SendPose("world", "box", t, Along(0.1));
        });
        Assert.That((FaultsNow(), _session.Parts.Summary), Is.EqualTo(("", "2 current")));

        _session.enabled = false;

        Assert.That(FaultsNow(), Is.EqualTo($"robot arm2: {StatusMessages.NoSession}; object box: {StatusMessages.NoSession}"));
        Assert.That((_session.Parts.Summary, box.State, _session.Parts.SinceOf(0)), Is.EqualTo((
            StatusMessages.NotCurrent(2), PoseState.Incomplete, (ControlTime?)null)));
    }

    // The uncompensated robot stands on the newest pose of its base, not on the predicted one.
    [Test]
    public void Rig_ShowsHeldPoseOnAMovingBase_StandsOnTheNewestPoseOfTheBase()
    {
        var ghost = Second(RobotFiles.LoadText("youbot"), RigPose.Held);
        void Send(double t) => SendPose("world", "arm2/arm_link_0", t, Along(0.3 * t));
        Run(2, Send);

        // The pose that was sent in the previous frame arrived after that frame, so it is the newest pose.
        Run(1, Send, () => AssertAt(ghost.transform, _session.transform, Along(0.3 * (_cell.Now - 1 / 60.0 - Latency)), 1e-4));
    }

    [Test]
    public void Gripper_BesideARigOnAMovingBase_HasThePoseOfTheFlange()
    {
        var rig = Second(RobotFiles.LoadText("youbot"));
        var gripper = Below<VirtualGripper>("gripper", _session.transform);
        gripper.Mount(rig);
        void Send(double t) => SendPose("world", "arm2/arm_link_0", t, Along(0.3 * t));
        Run(2, Send);

        Run(1, Send, () => Assert.That(Vector3.Distance(gripper.transform.position, rig.Flange.position), Is.LessThan(1e-5)));
    }

    [Test]
    public void Rig_WithNamespaceAfterAPause_KeepsItsLinksAndTheObjectsBelowThem()
    {
        var rig = Second(RobotFiles.LoadText("youbot"));
        Run(0.5);
        var (flange, own) = (rig.Flange, Below<FrameProbe>("own", rig.Flange));

        _cell.Player.Pause(true);
        _cell.Player.Pause(false);
        Run(0.5);

        Assert.That((rig.IsFollowing, rig.Flange, own != null), Is.EqualTo((true, flange, true)));
    }

    [Test]
    public void Rig_WithNamespaceButNoDescription_StatesWhatToAssign()
    {
        var rig = Second(null);
        Run(0.5);

        Assert.That(rig.IsFollowing, Is.False);
        Assert.That(_cell.Messages, Has.Exactly(1).Contains(RigMessages.NoDescription("arm2", "Second")));
    }

    // The data of the first part that is not current stopped this many seconds before now.
    void AssertStoppedBefore(double seconds) =>
        Assert.That((At(_cell.Now) - _session.Parts.SinceOf(0).Value).TotalSeconds, Is.EqualTo(seconds + Latency).Within(0.05));

    [Test]
    public void CellParts_TimeNotKnown_HaveRowsOnlyForFaultsOfTheirOwn()
    {
        _cell.IsSyncUp = false;
        foreach (var name in new[] { "box", "fixture", "invalid" }) Below<TrackedObject>(name, _session.transform);
        _session.transform.Find("invalid").GetComponent<TrackedObject>().With("_frame", "world");
        Run(0.1);
        _session.Session.Listener.FramesReceived(
            new TransformsMessage(Along(1).ToTransform(At(0), "unknown", "fixture")), true, HeadsetTime.FromSeconds(1000));
        Run(0.5, t => SendPose("world", "box", t, Along(t)));

        Assert.That(FaultsNow(), Does.StartWith($"object fixture: {FrameMessages.FrameUnknown("unknown")}; object world: "));
        Assert.That((_session.Parts.FaultCount, _session.Parts.Summary), Is.EqualTo((2, StatusMessages.NotCurrent(3))));
    }

    [Test]
    public void Cell_ObjectsAndSignals_AllocateNothing()
    {
        Below<TrackedObject>("box", _session.transform);
        Below<CellSignal>("grip", _session.transform);
        Below<ActuatedPart>("jaw", _session.transform);
        Run(2, t => SendPose("world", "box", t, Along(t)));
        SendSignal("grip", _cell.Now - 1, 1);
        Run(1);

        Assert.That(_cell.AllocatedIn(() => _cell.Run(1, _session, _session.Parts.Update)), Is.Zero);
    }

    [Test]
    public void CellParts_NotCurrent_AreNamedWithTheirFaults()
    {
        Below<TrackedObject>("part", _session.transform);
        Below<TrackedObject>("lid", _session.transform);
        var parts = _session.Parts;
        Run(6, t => SendPose("world", "part", t, Along(0.1 * t)));

        Assert.That((FaultsNow(), parts.Summary), Is.EqualTo(("object lid: " + FrameMessages.NoPose, StatusMessages.NotCurrent(1))));

        SendPose("world", "lid", _cell.Now - Latency, Along(1));
        Run(2);

        Assert.That(FaultsNow(), Is.EqualTo($"object part: {FrameMessages.PosesStopped}; object lid: {FrameMessages.PosesStopped}"));
        AssertStoppedBefore(2);
        Assert.That(parts.Summary, Is.EqualTo(StatusMessages.NotCurrent(2)));
        var signal = Below<CellSignal>("closed", _session.transform);
        _session.transform.Find("part").gameObject.SetActive(false);
        Run(0.1);
        Assert.That(FaultsNow(), Is.EqualTo($"object lid: {FrameMessages.PosesStopped}; signal closed: {signal.Fault}"), "a hidden object is not shown");
        Assert.That(_session.Session.Listener.Diagnostics().Values.Select(pair => pair.Key).Where(key => key.StartsWith("object_") || key.StartsWith("signal_")), Is.EqualTo(new[] { "object_status/lid", "signal_status/closed" }), "the diagnostics name the same parts");
        Run(1, t => SendPose("world", "lid", t, Along(1)));
        signal.gameObject.SetActive(false);
        Assert.That((FaultsNow(), parts.Summary), Is.EqualTo(("", "1 current")));
    }

    // The panel states the problem of the clock once, and not in a row of each robot.
    [Test]
    public void Rig_WithNamespaceAndClockNotSynchronised_HasNoRowOfItsOwn()
    {
        Second(RobotFiles.LoadText("youbot"));
        var joints = RobotFiles.Load("youbot").MovingJoints.Select(joint => joint.Name).ToArray();
        _cell.IsSyncUp = false;
        Run(1, t => _session.Session.Listener.Received(
            new JointStateMessage(At(t), joints, joints.Select(_ => 0.003).ToArray()), HeadsetTime.FromSeconds(1000 + t + Latency), "arm2"));

        Assert.That((FaultsNow(), _session.Parts.Summary), Is.EqualTo(("", StatusMessages.NotCurrent(1))));
    }
}
