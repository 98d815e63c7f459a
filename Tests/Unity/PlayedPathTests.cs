using Nowpose.Frames;
using Nowpose.Gateway.Plants;
using Nowpose.Kinematics;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using Nowpose.Session;
using Nowpose.Unity.Messages;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests;

public class PlayedPathTests : PlayedParts
{
    [Test]
    public void PlannedPath_SetPointsPublished_FollowsThePathOfTheTool()
    {
        var (rig, path, line) = NewPath();
        Run(1);
        Assert.That((line.enabled, path.DrawnSeconds, path.Fault), Is.EqualTo((false, 0f, PlannedPathMessages.NoPlan)));

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
    public void PlannedPath_MovedBelowAnotherRig_DrawsThePathOfThatRobot()
    {
        var (_, path, line) = NewPath();
        var other = Below<RobotRig>("Other", _session.transform);
        other.transform.localPosition = new Vector3(3, 0, 0);
        Run(1);

        path.transform.SetParent(other.transform, false);
        SendPlan(_cell.Now, 3);
        Run(0.2);

        Assert.That(Vector3.Distance(line.GetPosition(0), other.Tool.position), Is.LessThan(2e-4));
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

    [TestCase(true)]
    [TestCase(false)]
    public void PlannedPath_BaseMoves_IsHiddenUntilTheBaseIsStationary(bool isRootFrame)
    {
        var (rig, path, line) = NewPath();
        Run(0.1);
        var carrier = isRootFrame ? _session.Session.Robots[0].Root : "cart";
        if (!isRootFrame) rig.transform.SetParent(Below<TrackedObject>("cart", _session.transform).transform, false);
        Run(1, t => SendPose("world", carrier, t, Along(0.5 * t)));
        SendPlan(_cell.Now, 6);
        Run(1, t => SendPose("world", carrier, t, Along(0.5 * t)));
        Assert.That((_session.Frame.State, line.enabled, path.Fault), Is.EqualTo((PoseState.Current, false, PlannedPathMessages.BaseMoves)));

        _session.Session.Listener.FramesReceived(
            new TransformsMessage(Along(1).ToTransform(default, "world", carrier)), true, HeadsetTime.FromSeconds(1000 + _cell.Now));
        Run(0.5);
        Assert.That((_session.Frame.State, line.enabled), Is.EqualTo((PoseState.Current, true)));
    }

    // The base of the carried robot is at rest below the base of the other rig, and moves below one of its links.
    [TestCase("", 4e-4, 1.5e-3)]
    [TestCase("arm_link_2", 2e-3, 6e-3)]
    public void PlannedPath_RigBelowAnotherRig_ContainsThePlannedMotionOfTheOther(string link, double within, double moved)
    {
        var (rig, path, line) = NewPath();
        Run(0.1);
        var carrier = Below<RobotRig>("Carrier", _session.transform);
        Run(0.1);
        rig.transform.SetParent(link.Length == 0 ? carrier.transform : carrier.Link(link), false);
        rig.transform.localPosition = new Vector3(1, 2, -3);
        Run(1);
        Assert.That(path.Fault, Is.EqualTo(PlannedPathMessages.NoPlan));

        SendPlan(_cell.Now, 3);
        Run(0.2);
        Assert.That((path.Fault, line.enabled), Is.EqualTo(((string)null, true)));
        var expected = line.GetPosition(line.positionCount - 1);
        Assert.That(Vector3.Distance(line.GetPosition(0), rig.Tool.position), Is.LessThan(within), "begins at the displayed tool");
        var (start, baseStart) = (rig.Tool.position, rig.transform.position);
        Run(1);
        Assert.That(Vector3.Distance(expected, rig.Tool.position), Is.LessThan(within), "one second later, the tool is where the line ended");
        Assert.That(Vector3.Distance(start, rig.Tool.position), Is.GreaterThan(moved), "the tool moves");
        Assert.That(Vector3.Distance(baseStart, rig.transform.position), link.Length == 0 ? Is.LessThan(1e-5) : Is.GreaterThan(moved));
        Assert.That(_cell.AllocatedIn(() => _cell.Run(0.5, _session)), Is.Zero);
    }

    [Test]
    public void PlannedPath_CarryingRigWithoutPlan_StatesTheReason()
    {
        var (rig, path, line) = NewPath();
        var carrier = Second(RobotFiles.LoadText("youbot"));
        Run(1);
        rig.transform.SetParent(carrier.Link("arm_link_2"), false);
        SendPlan(_cell.Now, 6);
        Run(0.5);
        Assert.That((path.Fault, line.enabled), Is.EqualTo((PlannedPathMessages.CarrierNotCurrent, false)), "without data");

        var joints = RobotFiles.Load("youbot").MovingJoints.Select(joint => joint.Name).ToArray();
        Run(1, t => _session.Session.Listener.Received(
            new JointStateMessage(At(t), joints, [.. joints.Select(_ => 0.01)]), HeadsetTime.FromSeconds(1000 + t + Latency), "arm2"));

        Assert.That((path.Fault, line.enabled), Is.EqualTo((PlannedPathMessages.CarrierWithoutPlan, false)));
    }

    // The session does not move the links of such a rig, or moves them at the time of another clock.
    [TestCase(true)]
    [TestCase(false)]
    public void PlannedPath_CarryingRigIsNotBoundOrHasAnotherSession_IsHidden(bool isBound)
    {
        var (rig, path, line) = NewPath();
        rig.Follow(_session);
        var carrier = Below<RobotRig>("Carrier", isBound ? _cell.Play().transform : _session.transform);
        Run(0.1);
        rig.transform.SetParent(carrier.Link("arm_link_2"), false);
        Run(1);
        if (!isBound) UnityEngine.Object.DestroyImmediate(carrier.Link("arm_link_5").gameObject);
        SendPlan(_cell.Now, 3);
        Run(0.2);

        Assert.That(carrier.IsFollowing, Is.EqualTo(isBound));
        Assert.That((rig.Session, _session.Frame.State), Is.EqualTo((_session, PoseState.Current)));
        Assert.That((path.Fault, line.enabled), Is.EqualTo((PlannedPathMessages.CarrierUnknown, false)));
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
    public void PlannedPath_RigEnabledLater_DrawsThePathOfItsRobot()
    {
        var (rig, _, line) = NewPath();
        rig.enabled = false;
        Run(1);

        rig.enabled = true;
        Run(1);
        SendPlan(_cell.Now, 3);
        Run(0.2);

        Assert.That(line.enabled, Is.True);
    }

    [Test]
    public void PlannedPath_RigDisabled_StatesIt()
    {
        var rig = Below<RobotRig>("rig", _session.transform);
        var path = Below<PlannedPath>("path", rig.transform);
        rig.enabled = false;

        Run(0.2);

        Assert.That((path.Fault, path.DrawnSeconds), Is.EqualTo((PoseMessages.RigDisabled, 0f)));
    }

    [Test]
    public void PlannedPath_NoRig_IsLoggedAndHidden()
    {
        var path = Below<PlannedPath>("path", _session.transform);

        Run(0.2);

        Assert.That(_cell.Messages, Has.Exactly(1).Contains(ComponentMessages.PathWithoutRig("path")));
        Assert.That((path.Fault, path.DrawnSeconds), Is.EqualTo((StatusMessages.NoRig, 0f)));
    }
}
