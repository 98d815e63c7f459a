using Nowpose.Frames;
using Nowpose.Gateway.Plants;
using Nowpose.Kinematics;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Calibration;

/// <summary>Tests which rig the Latency Nudge shifts, and that frames of the cell keep the shift.</summary>
public class NudgedRigTests : PlayedParts
{
    static readonly string[] Joints = [.. RobotFiles.Load("youbot").MovingJoints.Select(joint => joint.Name)];

    [TestCase(true)]
    [TestCase(false)]
    public void OffsetMm_RootLinkHasAFrame_RigStaysShifted(bool isMoving)
    {
        var rig = Below<RobotRig>("Robot", _session.transform);
        var nudge = _session.gameObject.AddComponent<LatencyNudge>();
        RigidTransform PoseAt(double t) => Along(isMoving ? 0.3 * t : 0.3, yaw: 1);
        void Send(double t)
        {
            var root = _session.Session.Robots[0].Root;
            if (isMoving) SendPose("world", root, t, PoseAt(t));
            else _session.Session.Listener.FramesReceived(
                new TransformsMessage(PoseAt(0).ToTransform(default, "world", root)), true, HeadsetTime.FromSeconds(1000 + _cell.Now));
        }
        Run(2, Send);
        nudge.OffsetMm = 40;
        Run(0.2, Send);

        AssertAt(rig.transform, _session.transform, PoseAt(_cell.Now + Visu) * RigidTransform.FromXyzRpy(0.04, 0, 0, 0, 0, 0), 1e-3);

        nudge.enabled = false;
        Run(0.1, Send);
        AssertAt(rig.transform, _session.transform, PoseAt(_cell.Now + Visu), 1e-3);
    }

    [Test]
    public void OffsetMm_FirstRigShowsARobotInANamespace_ShiftsTheSessionsOwnRobot()
    {
        var other = NewSecond();
        var own = Below<RobotRig>("Robot", _session.transform);
        var nudge = _session.gameObject.AddComponent<LatencyNudge>();
        Run(0.1);

        nudge.OffsetMm = 40;

        Assert.That((own.transform.localPosition.magnitude, other.transform.localPosition.magnitude), Is.EqualTo((0.04f, 0f)));
    }

    [Test]
    public void SpeedMmPerS_RigOfARobotInANamespace_IsTheSpeedOfThatRobot()
    {
        var nudge = _session.gameObject.AddComponent<LatencyNudge>().With("_rig", NewSecond());

        Run(3, t => _session.Session.Listener.Received(
            new JointStateMessage(At(t), Joints, Joints.Select(_ => 0.003).ToArray()), HeadsetTime.FromSeconds(1000 + t + Latency), "arm2"));

        Assert.That(nudge.SpeedMmPerS, Is.EqualTo(0).Within(1e-3), "the robot rests, and the session's own robot moves");
    }

    [Test]
    public void Axis_ChangedInTheInspector_DeletesTheMarksAndTurnsTheShift()
    {
        var rig = Second(LatencyNudgeTests.Gantry);
        var nudge = _session.gameObject.AddComponent<LatencyNudge>().With("_rig", rig);
        void Send(double t) => _session.Session.Listener.Received(
            new JointStateMessage(At(t), ["x"], [0.1 * t]), HeadsetTime.FromSeconds(1000 + t + Latency), "arm2");
        Run(3, Send);
        nudge.OffsetMm = 40;
        Assert.That((nudge.Mark(), nudge.ForwardCount), Is.EqualTo((true, 1)), nudge.Problem);

        nudge.With("_axis", NudgeAxis.Z);
        Run(0.1, Send);

        Assert.That(nudge.ForwardCount, Is.EqualTo(0));
        Assert.That(Vector3.Distance(rig.transform.localPosition, new Vector3(0, 0.04f, 0)), Is.LessThan(1e-6));
    }

    [Test]
    public void SpeedMmPerS_OwnRobotUnknown_IsTheSpeedOfTheRobotInTheNamespace()
    {
        _session.RobotAsset = null;
        var rig = NewSecond();
        var nudge = _session.gameObject.AddComponent<LatencyNudge>().With("_rig", rig);

        Run(3, t => _session.Session.Listener.Received(
            new JointStateMessage(At(t), Joints, Joints.Select(_ => 0.003).ToArray()), HeadsetTime.FromSeconds(1000 + t + Latency), "arm2"));

        Assert.That((_session.Robot, rig.IsFollowing), Is.EqualTo(((RobotModel)null, true)));
        Assert.That(nudge.SpeedMmPerS, Is.EqualTo(0).Within(1e-3));
    }

    RobotRig NewSecond() => Below<RobotRig>("Second", _session.transform).With("_robotNamespace", "arm2")
        .With("_description", RobotDescriptionAsset.Create("second", RobotFiles.LoadText("youbot")));

    [TestCase(NudgeAxis.X, "1 0 0")]
    [TestCase(NudgeAxis.Y, "0 1 0")]
    [TestCase(NudgeAxis.Z, "0 0 1")]
    public void SpeedMmPerS_AxisOfTheMotion_IsTheSpeedAlongIt(NudgeAxis axis, string along)
    {
        var rig = Second(LatencyNudgeTests.Gantry.Replace("1 0 0", along));
        var nudge = _session.gameObject.AddComponent<LatencyNudge>().With("_rig", rig).With("_axis", axis);

        Run(3, t => _session.Session.Listener.Received(
            new JointStateMessage(At(t), ["x"], [0.1 * t]), HeadsetTime.FromSeconds(1000 + t + Latency), "arm2"));

        Assert.That(nudge.SpeedMmPerS, Is.EqualTo(100).Within(0.1));
    }
}
