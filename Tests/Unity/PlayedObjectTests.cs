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

/// <summary>Objects, signals and a second robot of the cell in a running scene.</summary>
public class PlayedObjectTests
{
    const double Latency = 0.08, Visu = 0.04;

    PlayedCell _cell;
    MrilSession _session;
    string _folder;

    [SetUp]
    public void Start()
    {
        _folder = Directory.CreateTempSubdirectory("nowpose-objects-").FullName;
        Begin();
    }

    void Begin()
    {
        _cell = new PlayedCell();
        _cell.Player.World.Host.PersistentDataPath = _folder;
        _session = _cell.NewSession();
    }

    [TearDown]
    public void Stop()
    {
        _cell.Dispose();
        Directory.Delete(_folder, true);
    }

    // The headset clock starts at 1000 s and is 300 s behind the control clock.
    static ControlTime At(double seconds) => ControlTime.FromSeconds(1300 + seconds);

    T Below<T>(string name, Transform parent) where T : Component
    {
        var made = new GameObject(name);
        made.transform.SetParent(parent, false);
        return made.AddComponent<T>();
    }

    void SendPose(string parent, string child, double t, in RigidTransform pose) => _session.Session.Listener.FramesReceived(
        new TransformsMessage(pose.ToTransform(At(t), parent, child)), false, HeadsetTime.FromSeconds(1000 + t + Latency));

    void SendSignal(string name, double t, double value, double latency = Latency) => _session.Session.Listener.SignalsReceived(
        new SignalsMessage(At(t), new SignalValue(name, value)), HeadsetTime.FromSeconds(1000 + t + latency));

    void Run(double seconds, Action<double> send = null, Action seen = null)
    {
        _session.gameObject.SetActive(true);
        _cell.Run(seconds, _session, () =>
        {
            seen?.Invoke();
            send?.Invoke(_cell.Now - Latency);
        });
    }

    static RigidTransform Along(double x, double yaw = 0) => RigidTransform.FromXyzRpy(x, 0.2, 0.1, 0, 0, yaw);

    static void AssertAt(Transform shown, Transform world, in RigidTransform pose, double within = 1e-4)
    {
        var expected = UnityPoses.ToWorld(pose);
        Assert.That(Vector3.Distance(shown.position, world.TransformPoint(expected.position)), Is.LessThan(within));
        Assert.That(Quaternion.Angle(shown.rotation, world.rotation * expected.rotation), Is.LessThan(0.1));
    }

    [Test]
    public void TrackedObject_Moving_IsShownAtTheDisplayTimeBelowTheMovedAnchor()
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
    public void TrackedObject_ParentIsALink_IsInTheDisplayedGripper()
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
        _session.Parts.Update();
        Assert.That(_session.Parts.Faults, Does.Contain("object fixture: not placed; place it by hand, or publish its frame on /tf_static"));
        var look = fixture.GetComponent<PoseAppearance>().Look;
        Assert.That((look.Words, look.IsDrawn, look.IsHatched), Is.EqualTo(("not placed", true, true)));

        fixture.BeginMove();
        fixture.transform.SetPositionAndRotation(new Vector3(2, 2.5f, 3), Quaternion.Euler(0, 30, 0));
        Run(0.5, Send);
        fixture.EndMove();
        Run(0.5, Send);

        Assert.That((fixture.State, fixture.IsMoving, lid.State), Is.EqualTo((PoseState.Current, false, PoseState.Current)));
        Assert.That(Vector3.Distance(fixture.transform.position, new Vector3(2, 2.5f, 3)), Is.LessThan(1e-5));
        AssertAt(lid.transform, fixture.transform, Along(0.05));
        Assert.That(fixture.GetComponent<PoseAppearance>().Look.IsHatched, Is.False);

        // A new run of the app, in which the base is elsewhere.
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
    public void StationaryObject_SourcePublishesItsFrame_ReplacesThePlaceByHand()
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
    public void StationaryObject_UnusableFile_IsPutAsideAndNamed()
    {
        var path = Path.Combine(_folder, "stationary-objects.json");
        File.WriteAllText(path, "{");
        Below<StationaryObject>("fixture", _session.transform);

        Run(0.1);

        Assert.That(_cell.Messages, Has.Exactly(1).Matches("stationary-objects.json, line 1: .*; kept as .*; place the objects again"));
        Assert.That((File.Exists(path), File.Exists(path + ".bad")), Is.EqualTo((false, true)));
    }

    [Test]
    public void TrackedObject_Held_IsWhereTheNewestPosePutsItAndNotListed()
    {
        var ghost = Below<TrackedObject>("ghost", _session.transform).With("_frame", "box").With("_shows", RigPose.Held);
        Run(2, t => SendPose("world", "box", t, Along(0.3 * t)));

        Run(1, t => SendPose("world", "box", t, Along(0.3 * t)), () =>
        {
            Assert.That(ghost.State, Is.EqualTo(PoseState.Current));
            // The pose of the frame before arrived after that frame.
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
        Assert.That((grip.Held, grip.Fault), Is.EqualTo(((string)null, "no connection")), "the test's session has no gateway");

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

        Assert.That(moved, Is.GreaterThan(0.001), "the arm does move");
        Assert.That(_session.Parts.Objects, Is.EqualTo(new[] { "box" }));
        grip.gameObject.SetActive(false);
        Run(1, Send);
        Assert.That(Vector3.Distance(box.transform.position, UnityPoses.ToWorld(pose).position), Is.LessThan(1e-4), "a hidden gripper gives it back");
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
    public void GripByReach_UnknownLink_IsNamedOnceAndOnThePanel()
    {
        var (_, grip, _) = NewGrip("hand");
        Run(1);

        Assert.That(grip.Fault, Does.Match("^the robot '.+' has no link 'hand'$"));
        Assert.That(_cell.Messages, Has.Exactly(1).Matches("grip by reach 'grip': the robot '.+' has no link 'hand'"));
        _session.Parts.Update();
        Assert.That(_session.Parts.Faults, Does.Contain("gripper grip: " + grip.Fault));
    }

    [Test]
    public void GripByReach_NoRig_StatesWhatToAssign()
    {
        var grip = Below<GripByReach>("grip", _session.transform);
        Run(0.5);

        Assert.That(grip.Fault, Is.EqualTo("no rig"));
        Assert.That(_cell.Messages, Has.Exactly(1).Contains("grip by reach 'grip' has no rig on a parent; assign one"));
    }

    [Test]
    public void PlannedPath_SetPointsPublished_LeadsAlongTheToolsWay()
    {
        var (rig, path, line) = NewPath();
        Run(1);
        Assert.That((line.enabled, path.DrawnSeconds), Is.EqualTo((false, 0f)), "no plan");

        SendPlan(_cell.Now, 3);
        Run(0.2);
        Assert.That(path.DrawnSeconds, Is.EqualTo(1).Within(1e-6));
        var expected = line.GetPosition(line.positionCount - 1);
        Assert.That(Vector3.Distance(line.GetPosition(0), rig.Tool.position), Is.LessThan(2e-4), "begins at the displayed tool");
        Run(1);
        Assert.That(Vector3.Distance(expected, rig.Tool.position), Is.LessThan(1e-3), "one second later, the tool is where the line ended");
        Assert.That(Vector3.Distance(expected, line.GetPosition(line.positionCount - 1)), Is.GreaterThan(1e-3), "the tool does move");

        Run(2.5);
        Assert.That((line.enabled, path.DrawnSeconds), Is.EqualTo((false, 0f)));
    }

    [Test]
    public void PlannedPath_PoseNotCurrent_IsHidden()
    {
        var (_, path, line) = NewPath();
        Run(1);
        SendPlan(_cell.Now, 6);
        Run(0.2);
        Assert.That(line.enabled, Is.True);

        _cell.IsPlantUp = false;
        Run(1.5);

        Assert.That(_session.Frame.State, Is.EqualTo(PoseState.Held));
        Assert.That((line.enabled, path.DrawnSeconds), Is.EqualTo((false, 0f)));
        _cell.IsPlantUp = true;
        Run(1);
        Assert.That(line.enabled, Is.True);
        _session.enabled = false;
        Assert.That(line.enabled, Is.False, "no session");
    }

    [Test]
    public void PlannedPath_Drawn_AllocatesNothing()
    {
        var (_, path, _) = NewPath();
        Run(1);
        SendPlan(_cell.Now, 9);
        Run(1);

        Assert.That(_cell.AllocatedIn(() => _cell.Run(1, _session)), Is.Zero);
        Assert.That(path.DrawnSeconds, Is.GreaterThan(0.9));
    }

    (RobotRig Rig, PlannedPath Path, LineRenderer Line) NewPath()
    {
        var rig = Below<RobotRig>("Robot", _session.transform);
        var path = Below<PlannedPath>("path", rig.transform);
        return (rig, path, path.GetComponent<LineRenderer>());
    }

    // The set-points are those that the robot follows; they arrive with the samples' latency.
    void SendPlan(double from, double seconds)
    {
        var robot = _session.Session.Robot;
        var joints = robot.MovingJoints.Select(joint => joint.Name).ToArray();
        var points = new List<JointTrajectoryPoint>();
        for (var t = 0.0; t <= seconds; t += 0.02)
        {
            var at = HeadsetTime.FromSeconds(1000 + from + t);
            points.Add(new JointTrajectoryPoint(TimeSpan.FromSeconds(t), [.. joints.Select((_, j) => PlayedCell.PositionAt(robot, at, j))]));
        }
        _session.Session.Listener.Planned(new JointTrajectoryMessage(At(from), joints, points.ToArray()), HeadsetTime.FromSeconds(1000 + from));
    }

    [Test]
    public void Signal_Changes_RaiseEventsOnceInOrderAndInTime()
    {
        var signal = Below<CellSignal>("gripper", _session.transform);
        var seen = new List<(double Light, double Value)>();
        signal.Changed += value => seen.Add((_cell.Now + Visu, value));
        Run(1);
        SendSignal("gripper", _cell.Now - 1, 0);
        Run(0.5);
        var change = _cell.Now + 0.5;
        SendSignal("gripper", change, 1, latency: -0.4);
        SendSignal("gripper", change + 0.005, 0, latency: -0.4);

        Run(1);

        Assert.That(seen.Select(each => each.Value), Is.EqualTo(new[] { 0.0, 1, 0 }));
        Assert.That(seen[1].Light - change, Is.InRange(-1e-6, 1 / 60.0 + 1e-6), "in the frame whose light has its stamp");
        Assert.That(signal.Value, Is.Zero);
    }

    [Test]
    public void Signal_NoGateway_StatesIt()
    {
        var signal = Below<CellSignal>("gripper", _session.transform);
        Run(0.5);

        Assert.That((signal.Value, signal.Fault), Is.EqualTo(((double?)null, "no connection")));
    }

    [Test]
    public void ActuatedPart_LateNews_IsInPhase()
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

    [Test]
    public void Rig_InANamespace_ShowsItsRobotOnItsMovingBase()
    {
        var text = RobotFiles.LoadText("youbot");
        var rig = Second(text);
        var joints = RobotFiles.Load("youbot").MovingJoints.Select(joint => joint.Name).ToArray();
        void Send(double t)
        {
            _session.Session.Listener.Received(
                new JointStateMessage(At(t), joints, joints.Select(_ => 0.003).ToArray()), HeadsetTime.FromSeconds(1000 + t + Latency), "arm2");
            SendPose("world", "arm2/arm_link_0", t, Along(0.1 * t));
        }
        Run(2, Send);

        Assert.That(rig.IsFollowing, Is.True);
        Assert.That(rig.Joints[0], Is.EqualTo(0.003).Within(1e-6));
        AssertAt(rig.transform, _session.transform, Along(0.1 * (_cell.Now + Visu)), 1e-3);
        Assert.That(rig.StateIn(_session.Frame), Is.EqualTo(PoseState.Current));

        Run(1);
        Assert.That(rig.StateIn(_session.Frame), Is.EqualTo(PoseState.Held), "its source has ended; the session's robot goes on");
        Assert.That(_session.Frame.State, Is.EqualTo(PoseState.Current));
    }

    RobotRig Second(string urdf)
    {
        var made = new GameObject("Second");
        made.SetActive(false);
        made.transform.SetParent(_session.transform, false);
        var rig = made.AddComponent<RobotRig>().With("_robotNamespace", "arm2");
        if (urdf != null) rig.With("_description", RobotDescriptionAsset.Create("second", urdf));
        made.SetActive(true);
        return rig;
    }

    [Test]
    public void Rig_InANamespaceWithoutDescription_StatesWhatToAssign()
    {
        var rig = Second(null);
        Run(0.5);

        Assert.That(rig.IsFollowing, Is.False);
        Assert.That(_cell.Messages, Has.Exactly(1).Contains("assign a Robot Description to the rig 'Second'"));
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

        Assert.That(_cell.AllocatedIn(() => _cell.Run(1, _session)), Is.Zero);
    }

    [Test]
    public void Parts_NotCurrent_AreNamedWithTheirFaults()
    {
        Below<TrackedObject>("part", _session.transform);
        Below<TrackedObject>("lid", _session.transform);
        var parts = _session.Parts;
        Run(6, t => SendPose("world", "part", t, Along(0.1 * t)));

        parts.Update();
        Assert.That((parts.Summary, parts.FirstFault), Is.EqualTo(("! 1 not current", "object lid: no pose received")));

        SendPose("world", "lid", _cell.Now - Latency, Along(1));
        Run(2);

        parts.Update();
        Assert.That(parts.Summary, Is.EqualTo("! 2 not current"));
        Assert.That(parts.Faults, Is.EqualTo("object part: its poses have stopped; object lid: its poses have stopped"));
        var signal = Below<CellSignal>("closed", _session.transform);
        _session.transform.Find("part").gameObject.SetActive(false);
        Run(0.1);
        parts.Update();
        Assert.That(parts.Faults, Is.EqualTo("object lid: its poses have stopped; signal closed: " + signal.Fault), "a hidden object is not shown");
        Run(1, t => SendPose("world", "lid", t, Along(1)));
        signal.gameObject.SetActive(false);
        parts.Update();
        Assert.That((parts.Summary, parts.Faults), Is.EqualTo(("1 current", (string)null)));
    }
}
