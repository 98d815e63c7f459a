using Nowpose.Frames;
using Nowpose.Gateway.Plants;
using Nowpose.Kinematics;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using Nowpose.Session;
using Nowpose.Unity;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests;

/// <summary>Tests objects of the cell in a running scene: tracked, placed by hand, and gripped.</summary>
public class PlayedObjectTests : PlayedParts
{
    [Test]
    public void TrackedObject_Moving_IsShownAtTheDisplayTimeRelativeToTheAnchor()
    {
        var anchor = Below<BaseAnchor>("Base Anchor", _session.transform);
        anchor.transform.position = new Vector3(1, 2, 3);
        var box = Below<TrackedObject>("box", anchor.transform);
        Run(2, t => SendPose("world", "box", t, Along(0.3 * t, 0.4 * t)));

        Run(1, t => SendPose("world", "box", t, Along(0.3 * t, 0.4 * t)), () =>
        {
            Assert.That(box.State, Is.EqualTo(PoseState.Current));
            AssertAt(box.transform, anchor.transform, Along(0.3 * (_cell.Now + Visu), 0.4 * (_cell.Now + Visu)), 1e-3);
        });
        anchor.transform.position = new Vector3(-5, 0, 0);
        _cell.Frame(_session);

        AssertAt(box.transform, anchor.transform, Along(0.3 * (_cell.Now + Visu), 0.4 * (_cell.Now + Visu)), 1e-3);
    }

    [Test]
    public void TrackedObject_ParentIsALink_MovesWithTheDisplayedGripper()
    {
        var rig = Below<RobotRig>("Robot", _session.transform);
        var part = Below<TrackedObject>("part", _session.transform);
        Run(1, t => SendPose("tool_centre_point", "part", t, Along(0.05)));

        Run(1, t => SendPose("tool_centre_point", "part", t, Along(0.05)), () =>
        {
            var grasp = UnityPoses.ToWorld(Along(0.05));
            Assert.That(Vector3.Distance(part.transform.position, rig.Tool.TransformPoint(grasp.position)), Is.LessThan(1e-4), "0.1 mm");
        });
        Assert.That(part.Parent, Is.EqualTo("tool_centre_point"));
    }

    // The objects below a moving one are enabled before it, as an inactive parent or a later change of the hierarchy causes it.
    [Test]
    public void TrackedObject_BelowAMovingObjectThatIsEnabledLater_IsNotDisplacedByIt()
    {
        var lid = Below<TrackedObject>("lid", _session.transform);
        var knob = Below<TrackedObject>("knob", lid.transform);
        var box = Below<TrackedObject>("box", _session.transform);
        var rig = Below<RobotRig>("Robot", _session.transform);
        void Send(double t)
        {
            SendPose("world", "box", t, Along(t));
            SendPose("world", "lid", t, Along(-t));
            SendPose("world", "knob", t, Along(0.5));
        }
        Run(2, Send, () => { if (lid.transform.parent == _session.transform && rig.Tool != null) lid.transform.SetParent(box.transform); });
        knob.enabled = false;
        knob.enabled = true;

        Run(1, Send, () =>
        {
            AssertAt(box.transform, _session.transform, Along(_cell.Now + Visu), 1e-3);
            AssertAt(lid.transform, _session.transform, Along(-_cell.Now - Visu), 1e-3);
            AssertAt(knob.transform, _session.transform, Along(0.5), 1e-3);
        });

        knob.transform.SetParent(rig.Tool);
        Run(1, Send, () => AssertAt(knob.transform, _session.transform, Along(0.5), 1e-3));
    }

    [Test]
    public void StationaryObject_InvalidName_IsReportedOnceAndKeepsTheSavedPlaces()
    {
        var file = Path.Combine(_folder, "stationary-objects.json");
        StationaryFrameFile.Save(file, new TransformsMessage(Along(2).ToTransform(default, "world", "other")));
        var before = File.ReadAllText(file);
        var wrong = Below<StationaryObject>(new string('x', 129), _session.transform);
        Run(0.5);

        wrong.BeginMove();
        Run(0.5);
        wrong.EndMove();

        Assert.That(File.ReadAllText(file), Is.EqualTo(before));
        Assert.That(wrong.Fault, Does.StartWith("the frame 'xxx").And.Contain("allowed: 1 to 128 characters, not 'world'"));
        Assert.That(_cell.Player.Logs.Count(log => log.Type == LogType.Error), Is.EqualTo(1));
    }

    [Test]
    public void StationaryObject_RenamedAtRunTime_IsSavedUnderTheNameOfItsFrame()
    {
        var fixture = Below<StationaryObject>("fixture", _session.transform).With("_fileName", "");
        Run(0.5);
        fixture.name = "renamed";

        fixture.BeginMove();
        Run(0.1);
        fixture.EndMove();

        Assert.That(fixture.Frame, Is.EqualTo("fixture"));
        Assert.That(StationaryFrameFile.Load(Path.Combine(_folder, "stationary-objects.json"))[0].Child, Is.EqualTo("fixture"));
    }

    [Test]
    public void TrackedObject_NoLongerSent_LooksHeldWhileTheRobotIsCurrent()
    {
        var box = Below<TrackedObject>("box", _session.transform);
        var appearance = box.GetComponent<PoseAppearance>();
        Run(2, t => SendPose("world", "box", t, Along(t)));
        Assert.That(appearance.Look.IsHatched, Is.False);

        Run(1);

        Assert.That(_session.Frame.State, Is.EqualTo(PoseState.Current));
        Assert.That(box.State, Is.EqualTo(PoseState.Held));
        Assert.That(appearance.Look.IsHatched, Is.True);
    }

    [Test]
    public void Cell_WithoutARobot_ShowsObjectsAndSignals()
    {
        _session.RobotAsset = null;
        var rig = Below<RobotRig>("Robot", _session.transform);
        var box = Below<TrackedObject>("box", _session.transform);
        var jaw = Below<ActuatedPart>("jaw", _session.transform).With("_wayMetres", new Vector3(0, 0, 0.02f));
        Run(1, t => SendPose("world", "box", t, Along(t)));
        SendSignal("jaw", _cell.Now - 1, 1);

        Run(1, t => SendPose("world", "box", t, Along(t)), () => AssertAt(box.transform, _session.transform, Along(_cell.Now + Visu), 1e-3));

        Assert.That((_session.Robot, _session.Frame, rig.Model), Is.EqualTo(((RobotModel)null, (DisplayFrame)null, (RobotModel)null)));
        Assert.That((box.State, box.GetComponent<PoseAppearance>().Look.IsHatched), Is.EqualTo((PoseState.Current, false)));
        Assert.That((jaw.Share, jaw.Fault), Is.EqualTo((1f, (string)null)));
    }

    [Test]
    public void TrackedObject_NeverSent_IsNotDrawn()
    {
        var box = Below<TrackedObject>("box", _session.transform);
        Run(1);

        Assert.That(box.State, Is.EqualTo(PoseState.Incomplete));
        Assert.That(box.GetComponent<PoseAppearance>().Look.IsDrawn, Is.False);
    }

    [Test]
    public void StationaryObject_PlacedByHand_StaysSavedAndCarriesItsChildren()
    {
        var anchor = Below<BaseAnchor>("Base Anchor", _session.transform);
        anchor.transform.position = new Vector3(1, 2, 3);
        var fixture = Below<StationaryObject>("fixture", anchor.transform);
        var lid = Below<TrackedObject>("lid", anchor.transform);
        void Send(double t) => SendPose("fixture", "lid", t, Along(0.05));
        Run(1, Send);
        Assert.That(FaultsNow(), Does.Contain("object fixture: not placed; place it by hand, or publish its frame on /tf_static"));
        var look = fixture.GetComponent<PoseAppearance>().Look;
        Assert.That((look.Label, look.IsDrawn, look.IsHatched), Is.EqualTo(("not placed", true, true)));

        fixture.BeginMove();
        fixture.transform.SetPositionAndRotation(new Vector3(2, 2.5f, 3), Quaternion.Euler(0, 30, 0));
        Run(0.5, Send);
        fixture.EndMove();
        Run(0.5, Send);

        Assert.That((fixture.State, fixture.IsMoving, lid.State), Is.EqualTo((PoseState.Current, false, PoseState.Current)));
        Assert.That(Vector3.Distance(fixture.transform.position, new Vector3(2, 2.5f, 3)), Is.LessThan(1e-5));
        AssertAt(lid.transform, fixture.transform, Along(0.05));
        Assert.That(fixture.GetComponent<PoseAppearance>().Look.IsHatched, Is.False);

        // Simulates a new run of the application, with the base in another place.
        var place = anchor.transform.InverseTransformPoint(fixture.transform.position);
        _cell.Dispose();
        Begin();
        anchor = Below<BaseAnchor>("Base Anchor", _session.transform);
        anchor.transform.position = new Vector3(-4, 0, 1);
        fixture = Below<StationaryObject>("fixture", anchor.transform);
        Run(0.5);
        Assert.That(fixture.State, Is.EqualTo(PoseState.Current));
        Assert.That(Vector3.Distance(anchor.transform.InverseTransformPoint(fixture.transform.position), place), Is.LessThan(1e-5));
    }

    [Test]
    public void StationaryObject_SourcePublishesItsFrame_ReplacesTheHandPlacedPose()
    {
        StationaryFrameFile.Save(Path.Combine(_folder, "stationary-objects.json"), new TransformsMessage(
            Along(1).ToTransform(default, "world", "fixture"), Along(2).ToTransform(default, "world", "other")));
        var fixture = Below<StationaryObject>("fixture", _session.transform);
        Run(0.5);
        AssertAt(fixture.transform, _session.transform, Along(1));

        _session.Session.Listener.FramesReceived(
            new TransformsMessage(Along(3).ToTransform(default, "world", "fixture")), true, HeadsetTime.FromSeconds(1000 + _cell.Now));
        Run(0.5);
        AssertAt(fixture.transform, _session.transform, Along(3));

        fixture.BeginMove();
        fixture.transform.position = new Vector3(7, 0, 0);
        Run(0.2);
        fixture.EndMove();
        Run(0.2);
        Assert.That(fixture.transform.position.x, Is.EqualTo(7).Within(1e-5));
        var saved = StationaryFrameFile.Load(fixture.SavedPath);
        Assert.That(new[] { saved[0].Child, saved[1].Child }, Is.EqualTo(new[] { "other", "fixture" }), "the places of other objects are kept");
    }

    [Test]
    public void StationaryObject_MovedByItsSource_CannotBePlaced()
    {
        var fixture = Below<StationaryObject>("box", _session.transform);
        Run(2, t => SendPose("world", "box", t, Along(0.1 * t)));

        fixture.BeginMove();

        Assert.That(fixture.IsMoving, Is.False);
        Assert.That(_cell.Messages, Has.Exactly(1).Contains("stationary object 'box': its source or a gripper moves it, so it cannot be placed by hand"));
    }

    [Test]
    public void StationaryObject_InvalidFile_IsRenamedAndReported()
    {
        var path = Path.Combine(_folder, "stationary-objects.json");
        File.WriteAllText(path, "{");
        Below<StationaryObject>("fixture", _session.transform);

        Run(0.1);

        Assert.That(_cell.Messages, Has.Exactly(1).Matches("stationary-objects.json, line 1: .*; the file is kept as .*; place the objects again"));
        Assert.That((File.Exists(path), File.Exists(path + ".bad")), Is.EqualTo((false, true)));
    }

    [Test]
    public void TrackedObject_ShowsHeldPose_IsAtTheNewestPoseAndNotListed()
    {
        var ghost = Below<TrackedObject>("ghost", _session.transform).With("_frame", "box").With("_shows", RigPose.Held);
        Run(2, t => SendPose("world", "box", t, Along(0.3 * t)));

        Run(1, t => SendPose("world", "box", t, Along(0.3 * t)), () =>
        {
            Assert.That(ghost.State, Is.EqualTo(PoseState.Current));
            // The pose that was sent in the previous frame arrived after that frame, so it is the newest pose.
            AssertAt(ghost.transform, _session.transform, Along(0.3 * (_cell.Now - 1 / 60.0 - Latency)), 1e-4);
        });
        Assert.That((_session.Parts.Count, _session.Parts.Objects.Count), Is.EqualTo((0, 0)));
    }

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
        Assert.That(_session.Parts.Objects, Is.EqualTo(new[] { "box" }));
        grip.gameObject.SetActive(false);
        Run(1, Send);
        Assert.That(Vector3.Distance(box.transform.position, UnityPoses.ToWorld(pose).position), Is.LessThan(1e-4), "a hidden gripper returns the object to its source");
        Assert.That(_session.Parts.Count, Is.EqualTo(1));
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

    [Test]
    public void GripByReach_UnknownLink_IsLoggedOnceAndShownOnThePanel()
    {
        var (_, grip, _) = NewGrip("hand");
        Run(1);

        Assert.That(grip.Fault, Does.Match("^the robot '.+' has no link 'hand'; correct Link$"));
        Assert.That(_cell.Messages, Has.Exactly(1).Matches("grip by reach 'grip': the robot '.+' has no link 'hand'"));
        Assert.That(FaultsNow(), Does.Contain("gripper grip: " + grip.Fault));
    }

    [Test]
    public void GripByReach_NoRig_StatesWhatToAssign()
    {
        var grip = Below<GripByReach>("grip", _session.transform);
        Run(0.5);

        Assert.That(grip.Fault, Is.EqualTo("no rig"));
        Assert.That(_cell.Messages, Has.Exactly(1).Contains("grip by reach 'grip' has no rig on a parent; assign one"));
    }
}
