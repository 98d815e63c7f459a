using Nowpose.Frames;
using Nowpose.Messages;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using Nowpose.Session;
using Nowpose.Unity.Messages;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests;

public class PlayedGripTests : PlayedParts
{
    [Test]
    public void GripByReach_SignalCloses_CarriesTheObjectInTheDisplayedTool()
    {
        var (rig, grip, box) = NewGrip();
        Run(2, _ => { });
        var tool = rig.Tool;
        var pose = UnityPoses.ToRoom(tool.position, tool.rotation) * Along(0.01);
        void Send(double t) => SendPose("world", "box", t, pose);
        Run(1, Send);
        SendSignal("grip", _cell.Now - 1, 0);
        Run(0.5, Send);
        Assert.That((grip.Held, grip.Fault), Is.EqualTo(((string)null, (string)null)));

        SendSignal("grip", _cell.Now - Latency, 1);
        Run(0.5, Send);
        var inHand = Quaternion.Inverse(rig.Tool.rotation) * (box.transform.position - rig.Tool.position);
        var moved = 0f;
        var start = box.transform.position;
        Run(2, Send, () =>
        {
            Assert.That(grip.Held, Is.EqualTo("box"));
            var now = Quaternion.Inverse(rig.Tool.rotation) * (box.transform.position - rig.Tool.position);
            Assert.That(Vector3.Distance(now, inHand), Is.LessThan(1e-4), "0.1 mm");
            moved = Mathf.Max(moved, Vector3.Distance(start, box.transform.position));
        });

        Assert.That(moved, Is.GreaterThan(0.001), "the arm moves");
        Assert.That(_session.Parts.Grippable, Is.EqualTo(new[] { "box" }));
        grip.gameObject.SetActive(false);
        Run(1, Send);
        Assert.That(Vector3.Distance(box.transform.position, UnityPoses.ToWorld(pose).position), Is.LessThan(1e-4), "a hidden gripper returns the object to its source");
        Assert.That(box.State, Is.EqualTo(PoseState.Held), "the source repeats the place from before the grip");
        Assert.That(_session.Parts.Count, Is.EqualTo(1));
        grip.gameObject.SetActive(true);
        Run(1, Send);
        Assert.That((grip.Held, grip.Fault, box.State), Is.EqualTo(((string)null, FrameMessages.ArmWithoutData, PoseState.Held)));
    }

    [Test]
    public void GripByReach_SignalEndsWhileAnObjectIsHeld_ObjectLooksDifferentAndStatesTheReason()
    {
        var (rig, grip, box) = NewGrip();
        var part = Rendering.PlayedAppearance.Part("part", box.transform);
        box.GetComponent<PoseAppearance>().Refresh();
        Run(2, _ => { });
        var pose = UnityPoses.ToRoom(rig.Tool.position, rig.Tool.rotation);
        void Send(double t) => SendPose("world", "box", t, pose);
        Run(1, Send);
        SendSignal("grip", _cell.Now - 1, 0);
        Run(0.5, Send);
        SendSignal("grip", _cell.Now - Latency, 1);
        Run(1, Send);
        Assert.That((grip.Held, box.Fault, Hatched.IsHatched(part)), Is.EqualTo(("box", (string)null, false)));

        _session.Session.Listener.SignalStatusReceived(
            new JointStatusMessage([new JointReport("grip", JointDataState.Stale, At(0), "its source ended")]), HeadsetTime.FromSeconds(1000));
        Run(0.5, Send);

        Assert.That((box.State, Hatched.IsHatched(part)), Is.EqualTo((PoseState.Held, true)));
        Assert.That(box.Fault, Is.EqualTo(FrameMessages.MayBeGripped("its source ended")));
        Assert.That(FaultsNow(), Does.Contain("object box: " + box.Fault).And.Contain("gripper grip: its source ended"));
    }

    [Test]
    public void GripByReach_SignalNotPublished_AllocatesNothingInAFrame()
    {
        var (_, grip, box) = NewGrip();
        Run(2, t => SendPose("world", "box", t, Along(0.01)));

        Assert.That(_cell.AllocatedIn(() => _cell.Run(1, _session)), Is.Zero);
        Assert.That((grip.Fault, box.State), Is.EqualTo((SignalMessages.NoConnection, PoseState.Held)));
    }

    (RobotRig Rig, GripByReach Grip, TrackedObject Box) NewGrip(string link = "")
    {
        var rig = Below<RobotRig>("Robot", _session.transform);
        var made = new GameObject("grip");
        made.SetActive(false);
        made.transform.SetParent(rig.transform, false);
        var grip = made.AddComponent<GripByReach>().With("_link", link).With("_reachMetres", 0.5f);
        made.SetActive(true);
        return (rig, grip, Below<TrackedObject>("box", _session.transform));
    }

    [TestCase(false, null)]
    [TestCase(true, "fixture")]
    public void GripByReach_FixtureWithinReach_IsGrippedOnlyIfItCanBeGripped(bool canBeGripped, string held)
    {
        var (rig, grip, _) = NewGrip();
        Below<StationaryObject>("fixture", _session.transform).With("_canBeGripped", canBeGripped);
        Run(2, _ => { });
        _session.Session.Listener.FramesReceived(
            new TransformsMessage(UnityPoses.ToRoom(rig.Tool.position, rig.Tool.rotation).ToTransform(default, "world", "fixture")), true, HeadsetTime.FromSeconds(1000));
        SendSignal("grip", _cell.Now - 1, 0);
        Run(0.5);

        SendSignal("grip", _cell.Now - Latency, 1);
        Run(1.5);

        Assert.That((grip.Held, grip.Fault), Is.EqualTo((held, (string)null)));
    }

    [Test]
    public void GripByReach_UnknownLink_IsLoggedOnceAndShownOnThePanel()
    {
        var (_, grip, _) = NewGrip("hand");
        Run(1);

        Assert.That(grip.Fault, Does.Match($"^{ObjectMessages.NoLink(".+", "hand")}$"));
        Assert.That(_cell.Messages, Has.Exactly(1).EndsWith("grip by reach 'grip': " + grip.Fault));
        Assert.That(FaultsNow(), Does.Contain("gripper grip: " + grip.Fault));
    }

    [Test]
    public void GripByReach_NoRig_StatesWhatToAssignAndIsShownOnThePanel()
    {
        var grip = Below<GripByReach>("grip", _session.transform);
        Run(0.5);

        Assert.That(grip.Fault, Is.EqualTo(StatusMessages.NoRig));
        Assert.That(_cell.Messages, Has.Exactly(1).Contains(ComponentMessages.GripWithoutRig("grip")));
        Assert.That(FaultsNow(), Is.EqualTo("gripper grip: " + StatusMessages.NoRig));
        grip.enabled = false;
        Assert.That(FaultsNow(), Is.Empty);
        Assert.That(grip.Fault, Is.EqualTo(ObjectMessages.Disabled("grip by reach", "grip")));
    }

    [TestCase(false)]
    [TestCase(true)]
    public void GripByReach_RigDisabled_IsShownOnThePanelUntilTheRigIsEnabled(bool isInactive)
    {
        var (rig, grip, _) = NewGrip();
        // A gripper below an inactive rig is itself inactive.
        grip.Follow(rig);
        if (isInactive) grip.transform.SetParent(null);
        void Enable(bool isEnabled)
        {
            if (isInactive) rig.gameObject.SetActive(isEnabled);
            else rig.enabled = isEnabled;
        }
        var expected = "gripper grip: " + PoseMessages.RigDisabled;
        Enable(false);
        Run(0.5, _ => { });
        Assert.That(FaultsNow(), Does.Contain(expected), "before the rig was enabled");

        Enable(true);
        Run(1, _ => { });
        SendSignal("grip", _cell.Now - Latency, 0);
        Run(0.5, _ => { });
        Assert.That((grip.Fault, FaultsNow()), Is.EqualTo(((string)null, "object box: " + FrameMessages.NoPose)));

        Enable(false);
        Run(0.5, _ => { });
        Assert.That(grip.Fault, Is.EqualTo(PoseMessages.RigDisabled));
        Assert.That(FaultsNow(), Does.Contain(expected), "after the rig was disabled");
    }

    [Test]
    public void GripByReach_MovedBelowARig_FollowsItsRobot()
    {
        var rig = Below<RobotRig>("Robot", _session.transform);
        var grip = Below<GripByReach>("grip", _session.transform);
        Run(0.5);

        grip.transform.SetParent(rig.transform);
        Run(0.5);

        Assert.That(FaultsNow(), Is.EqualTo("gripper grip: " + SignalMessages.NoConnection));
    }

    [Test]
    public void GripByReach_NoRigAndMovedOutOfTheSession_IsNoPartOfIt()
    {
        var grip = Below<GripByReach>("grip", _session.transform);
        Run(0.5);

        grip.transform.SetParent(null);

        Assert.That(_session.Parts.Count, Is.Zero);
    }

    [Test]
    public void GripByReach_SessionRestarts_GripsInTheNewSession()
    {
        var (rig, grip, _) = NewGrip();
        Run(2, _ => { });
        void Send(double t) => SendPose("world", "box", t, UnityPoses.ToRoom(rig.Tool.position, rig.Tool.rotation));
        void Close()
        {
            Run(1, Send);
            SendSignal("grip", _cell.Now - 1, 0);
            Run(0.5, Send);
            SendSignal("grip", _cell.Now - Latency, 1);
            Run(0.5, Send);
        }
        Close();
        Assert.That((grip.Held, grip.Fault), Is.EqualTo(("box", (string)null)));

        _session.enabled = false;
        Assert.That(grip.Fault, Is.EqualTo(StatusMessages.NoSession));
        _session.enabled = true;
        Run(1, Send);
        Assert.That(grip.Held, Is.Null, "the new session has no signals yet");

        Close();
        Assert.That((grip.Held, grip.Fault), Is.EqualTo(("box", (string)null)));
    }
}
