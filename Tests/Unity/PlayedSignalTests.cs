using Nowpose.Frames;
using Nowpose.Gateway.Plants;
using Nowpose.Kinematics;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using Nowpose.Session;
using Nowpose.Unity;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Events;

namespace Nowpose.Unity.Tests;

/// <summary>Tests planned paths, signals, and a second robot of the cell in a running scene.</summary>
public class PlayedSignalTests : PlayedParts
{
    [Test]
    public void PlannedPath_SetPointsPublished_FollowsThePathOfTheTool()
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
        Assert.That(Vector3.Distance(expected, line.GetPosition(line.positionCount - 1)), Is.GreaterThan(1e-3), "the tool moves");

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

    // Sends the set-points that the robot follows. They arrive with the latency of the samples.
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
    public void Signal_Changing_RaisesEachEventOnceInOrderAndOnTime()
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
        Assert.That(seen[1].Light - change, Is.InRange(-1e-6, 1 / 60.0 + 1e-6), "the change is visible in the frame whose display time is its stamp");
        Assert.That(signal.Value, Is.Zero);
    }

    [TestCase(-0.08)]
    [TestCase(0)]
    [TestCase(0.06)]
    [TestCase(0.25)]
    public void Signal_MessageDelayed_RaisesEventsAtItsStampOrAtItsArrivalIfLater(double delay)
    {
        const double frame = 1 / 60.0;
        var signal = Below<CellSignal>("gripper", _session.transform);
        Run(1);
        SendSignal("gripper", _cell.Now - 1, 0);
        Run(0.5);
        var change = _cell.Now + 0.503;
        var (light, arrival) = (double.NaN, double.NaN);
        signal.Changed += _ => light = _cell.Now + Visu;

        Run(1.5, seen: () =>
        {
            if (!double.IsNaN(arrival) || _cell.Now < change + delay) return;
            arrival = _cell.Now;
            SendSignal("gripper", change, 1, arrival - change);
        });

        Assert.That(light - Math.Max(change, arrival + Visu), Is.InRange(-1e-6, frame + 1e-6));
    }

    [TestCase("0.0 mm", 12.345, "12.3 mm")]
    [TestCase("on;;off", 1, "on")]
    [TestCase("on;;off", 0, "off")]
    [TestCase("Z", 2.5, "2.5")] // not a format
    public void Signal_TextListenerAdded_ReceivesTheFormattedValue(string format, double value, string expected)
    {
        var words = Below<TextMesh>("words", _session.transform);
        var onText = new UnityEvent<string>();
        onText.Persistent.Add(PersistentCall.Of(words, "set_text", PersistentListenerMode.EventDefined, null));
        Below<CellSignal>("width", _session.transform).With("_onText", onText).With("_textFormat", format);
        Run(1);
        SendSignal("width", _cell.Now - 1, value);
        Run(0.5);

        Assert.That(words.text, Is.EqualTo(expected));
    }

    [TestCase("", "width")]
    [TestCase("Open", "Open")]
    public void Signal_MethodsWithANameAssigned_ReceiveTheParameterAndTheValue(string parameter, string expected)
    {
        var animator = Below<ParameterDouble>("animator", _session.transform);
        var (onState, onValue, onInteger) = (new UnityEvent<string, bool>(), new UnityEvent<string, float>(), new UnityEvent<string, int>());
        onState.Persistent.Add(PersistentCall.Of(animator, nameof(ParameterDouble.SetBool), PersistentListenerMode.EventDefined, null));
        onValue.Persistent.Add(PersistentCall.Of(animator, nameof(ParameterDouble.SetFloat), PersistentListenerMode.EventDefined, null));
        onInteger.Persistent.Add(PersistentCall.Of(animator, nameof(ParameterDouble.SetInteger), PersistentListenerMode.EventDefined, null));
        Below<CellSignal>("width", _session.transform)
            .With("_parameter", parameter).With("_onNamedState", onState).With("_onNamedValue", onValue).With("_onNamedInteger", onInteger);
        Run(1);

        SendSignal("width", _cell.Now - 1, 0.25);
        Run(0.5);
        SendSignal("width", _cell.Now - 0.1, 2.75);
        Run(0.5);
        SendSignal("width", _cell.Now - 0.1, 1e300);
        Run(0.5);

        Assert.That(animator.Calls, Is.EqualTo(new[]
        {
            expected + " False", expected + " 0.25", expected + " 0", expected + " True", expected + " 2.75", expected + " 3",
            expected + " Infinity", expected + " 2147483647",
        }));
    }

    [Test]
    public void Signal_ListenerThrows_OtherComponentsReceiveTheChange()
    {
        var first = Below<CellSignal>("first", _session.transform).With("_signal", "jaw");
        var second = Below<CellSignal>("second", _session.transform).With("_signal", "jaw");
        first.Changed += _ => throw new InvalidOperationException("a mistake of the user");
        var received = new List<double>();
        second.Changed += received.Add;
        Run(1);
        SendSignal("jaw", _cell.Now - 1, 1);

        Run(0.3);

        Assert.That(received, Is.EqualTo(new[] { 1.0 }));
        Assert.That(_cell.Player.Logs.Count(log => log.Type == LogType.Exception), Is.EqualTo(1));
    }

    [Test]
    public void Signal_ListenerEndsTheSession_NoFrameRemains()
    {
        var signal = Below<CellSignal>("jaw", _session.transform);
        signal.Changed += _ => _session.enabled = false;
        Run(1);
        SendSignal("jaw", _cell.Now - 1, 1);

        _cell.Run(0.3, _session);

        Assert.That((_session.Session, _session.Frame), Is.EqualTo(((CompensationSession)null, (DisplayFrame)null)));
        Assert.That(_cell.Player.Logs.Where(log => log.Type == LogType.Exception), Is.Empty);
    }

    [Test]
    public void Signal_NoGateway_FaultNamesTheMissingGateway()
    {
        var signal = Below<CellSignal>("gripper", _session.transform);
        Run(0.5);

        Assert.That((signal.Value, signal.Fault), Is.EqualTo(((double?)null, "no connection")));
    }

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
        Assert.That((IsHatched(moved), IsHatched(other), appearance.Look.Label), Is.EqualTo((true, false, "signal not current")), jaw.Fault);

        SendSignal("jaw", _cell.Now - 1, 1);
        Run(0.5);
        Assert.That((IsHatched(moved), IsHatched(other), appearance.Look.Label), Is.EqualTo((false, false, "")));

        _session.Session.Listener.SignalStatusReceived(
            new JointStatusMessage([new JointReport("jaw", JointDataState.Refused, At(0), "signal jaw has the value NaN")]), HeadsetTime.FromSeconds(1000));
        Run(0.1);
        Assert.That((IsHatched(moved), IsHatched(other), appearance.Look.Reason), Is.EqualTo((true, false, "signal jaw has the value NaN")));

        jaw.enabled = false;
        Run(0.1);
        Assert.That(IsHatched(moved), Is.False, "a disabled part follows no signal");
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
        Assert.That((IsHatched(moved), IsHatched(shown), appearance.Look.Label), Is.EqualTo((true, false, "signal not current")), "the slide has no value");

        SendSignal("slide", _cell.Now - 1, 1);
        Run(0.5, Send);
        Assert.That((IsHatched(moved), appearance.Look.Label), Is.EqualTo((false, "")));

        jaw.enabled = false;
        jaw.enabled = true;
        var frames = 0;
        Run(0.1, Send, () => { if (frames++ > 0) Assert.That(jaw.Share, Is.EqualTo(1), "from the first frame on, because its signal changed long ago"); });
    }

    static bool IsHatched(Renderer renderer)
    {
        var block = new MaterialPropertyBlock();
        renderer.GetPropertyBlock(block);
        return block.GetFloat(Shader.PropertyToID("_Hatch")) > 0;
    }

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
    public void PlannedPath_RobotNoLongerKnown_IsHidden()
    {
        var (_, path, line) = NewPath();
        Run(1);
        SendPlan(_cell.Now, 6);
        Run(0.2);
        Assert.That(line.enabled, Is.True);

        _session.RobotAsset = null;
        Run(0.5);

        Assert.That((_session.Robot, line.enabled, path.DrawnSeconds), Is.EqualTo(((RobotModel)null, false, 0f)));
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
        Assert.That(part.Fault, Is.EqualTo("the tracked or stationary object on the same object moves it; put the actuated part on a child object"));
        Assert.That(_cell.Player.Logs.Count(log => log.Type == LogType.Error && log.Message.Contains("put the actuated part on a child object")), Is.EqualTo(1));
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
        Assert.That(FaultsNow(), Is.EqualTo("robot arm2: its base is not current"));
        Run(2, t => Send(t));
        Assert.That(rig.StateIn(_session.Frame), Is.EqualTo(PoseState.Current));

        Run(1);
        Assert.That(rig.StateIn(_session.Frame), Is.EqualTo(PoseState.Held), "only the robot whose source has ended is held");
        Assert.That(FaultsNow(), Is.EqualTo("robot arm2: too few recent samples"));
        Assert.That(_session.Frame.State, Is.EqualTo(PoseState.Current));
        rig.gameObject.SetActive(false);
        Assert.That(FaultsNow(), Is.Empty, "a robot that is not shown has no row");
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
    public void Rig_WithNamespaceButNoDescription_StatesWhatToAssign()
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
    public void CellParts_NotCurrent_AreNamedWithTheirFaults()
    {
        Below<TrackedObject>("part", _session.transform);
        Below<TrackedObject>("lid", _session.transform);
        var parts = _session.Parts;
        Run(6, t => SendPose("world", "part", t, Along(0.1 * t)));

        Assert.That((FaultsNow(), parts.Summary), Is.EqualTo(("object lid: no pose received", "! 1 not current")));

        SendPose("world", "lid", _cell.Now - Latency, Along(1));
        Run(2);

        Assert.That(FaultsNow(), Is.EqualTo("object part: no new poses are arriving; object lid: no new poses are arriving"));
        Assert.That(parts.Summary, Is.EqualTo("! 2 not current"));
        var signal = Below<CellSignal>("closed", _session.transform);
        _session.transform.Find("part").gameObject.SetActive(false);
        Run(0.1);
        Assert.That(FaultsNow(), Is.EqualTo("object lid: no new poses are arriving; signal closed: " + signal.Fault), "a hidden object is not shown");
        Run(1, t => SendPose("world", "lid", t, Along(1)));
        signal.gameObject.SetActive(false);
        Assert.That((FaultsNow(), parts.Summary), Is.EqualTo(("", "1 current")));
    }
}
