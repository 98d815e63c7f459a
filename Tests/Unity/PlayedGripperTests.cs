using Nowpose.Session;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using Nowpose.UnityPlayer;
using NUnit.Framework;
using UnityEngine;
using static Nowpose.Unity.Tests.PlayedRig;

namespace Nowpose.Unity.Tests;

/// <summary>Tests the gripper and the ghost below a running session.</summary>
public class PlayedGripperTests
{
    PlayedRig _played;

    [SetUp]
    public void Start() => _played = new PlayedRig();

    [TearDown]
    public void Stop() => _played.Dispose();

    [Test]
    public void Gripper_OneFingerDestroyed_OtherFingerStillMoves()
    {
        var gripper = Below<VirtualGripper>("Virtual Gripper", _played.Rig.transform);
        var lost = Below<FrameProbe>("Left", gripper.transform).transform;
        var kept = Below<FrameProbe>("Right", gripper.transform).transform;
        gripper.With("_fingers", new List<GripperFinger>
        {
            new("gripper_finger_joint_l", lost), new("gripper_finger_joint_l", null), new("gripper_finger_joint_r", kept),
        });
        _played.Play();

        UnityEngine.Object.Destroy(lost.gameObject);
        _played.Cell.Run(1, _played.Session);

        Assert.That(_played.Cell.Player.Logs.Where(log => log.Type == LogType.Exception), Is.Empty);
        var joint = _played.Session.Robot.IndexOfMovingJoint("gripper_finger_joint_r");
        Assert.That(kept.localPosition.magnitude, Is.EqualTo(Math.Abs(_played.Session.Frame.Joints[joint])).Within(1e-6));
    }

    [Test]
    public void Gripper_EnabledBeforeTheRig_HasNoDelay()
    {
        _played.Rig.enabled = false;
        var gripper = Below<VirtualGripper>("Virtual Gripper", _played.Rig.transform);
        _played.Play(0.1);
        _played.Rig.enabled = true;

        var worst = 0f;
        _played.Cell.Run(
            3, _played.Session, () => worst = Math.Max(worst, Vector3.Distance(gripper.transform.position, _played.Rig.Flange.position)));

        Assert.That(gripper.Flange, Is.SameAs(_played.Rig.Link("arm_link_5")));
        Assert.That(worst, Is.LessThan(1e-6));
        Assert.That(_played.Rig.Flange.position, Is.Not.EqualTo(_played.Rig.transform.position));
    }

    [Test]
    public void Gripper_FingerJointMoves_OpensAndCloses()
    {
        var gripper = Below<VirtualGripper>("Virtual Gripper", _played.Rig.transform);
        var finger = Below<FrameProbe>("Finger", gripper.transform).transform;
        gripper.With("_fingers", new List<GripperFinger> { new("gripper_finger_joint_l", finger) });
        _played.Session.gameObject.SetActive(true);
        var (min, max) = (1f, 0f);

        _played.Cell.Run(12, _played.Session, () =>
        {
            if (_played.Session.Frame.State != PoseState.Current) return;
            min = Math.Min(min, finger.localPosition.magnitude);
            max = Math.Max(max, finger.localPosition.magnitude);
            var joint = _played.Session.Robot.IndexOfMovingJoint("gripper_finger_joint_l");
            Assert.That(finger.localPosition.magnitude, Is.EqualTo(_played.Session.Frame.Joints[joint]).Within(1e-6));
        });

        Assert.That(min, Is.LessThan(0.0015));
        Assert.That(max, Is.GreaterThan(0.0085));
    }

    [TestCase(0.001f, 1f)]
    [TestCase(0.001f, 0.1f)]
    [TestCase(1f, 0.1f)]
    public void Gripper_FingerOfAScaledModel_MovesByTheJointPositionInMetresOfTheRig(float model, float cell)
    {
        _played.Session.transform.localScale = Vector3.one * cell;
        var gripper = Below<VirtualGripper>("Virtual Gripper", _played.Rig.transform);
        var scaled = Below<FrameProbe>("Model", gripper.transform).transform;
        scaled.localScale = Vector3.one * model;
        var finger = Below<FrameProbe>("Finger", scaled).transform;
        gripper.With("_fingers", new List<GripperFinger> { new("gripper_finger_joint_l", finger) });

        _played.Play(2);

        var way = Math.Abs(_played.Session.Frame.Joints[_played.Session.Robot.IndexOfMovingJoint("gripper_finger_joint_l")]);
        Assert.That(way, Is.GreaterThan(0.001));
        Assert.That(Vector3.Distance(finger.position, scaled.position), Is.EqualTo(cell * way).Within(1e-6));
    }

    [Test]
    public void Gripper_NoRigAbove_NamesTheRemedy()
    {
        var gripper = new GameObject("Lost Gripper").AddComponent<VirtualGripper>();

        _played.Cell.Frame(null);

        var fault = _played.Cell.Player.Logs.Single();
        Assert.That(fault.Type, Is.EqualTo(LogType.Error));
        Assert.That(fault.Message, Is.EqualTo("[Nowpose] " + ComponentMessages.GripperWithoutRig("Lost Gripper")));
        Assert.That(fault.Context, Is.SameAs(gripper));
    }

    [Test]
    public void Gripper_RobotHasOtherFingerJoints_IsLoggedOnceListedAndStriped()
    {
        var appearance = _played.Rig.gameObject.AddComponent<PoseAppearance>();
        var gripper = Below<VirtualGripper>("Virtual Gripper", _played.Rig.transform);
        var finger = Below<FrameProbe>("Finger", gripper.transform).transform;
        var part = Rendering.PlayedAppearance.Part("part", finger);
        gripper.With("_fingers", new List<GripperFinger> { new("left_joint", finger), new("gripper_finger_joint_l", finger), new("right_joint", finger) });

        _played.Play(2);

        var said = _played.Cell.Player.Logs.Single(l => l.Message.Contains("gripper"));
        var fault = ComponentMessages.FingerJointUnknown("youbot", "'left_joint' and no 'right_joint'");
        Assert.That((said.Type, said.Context), Is.EqualTo((LogType.Error, gripper)));
        Assert.That(said.Message, Does.EndWith(ComponentMessages.Of("gripper", "Virtual Gripper", fault)));
        var parts = _played.Session.Parts;
        parts.Update();
        Assert.That((parts.FaultCount, parts.FaultyTitle(0), parts.FaultOf(0)), Is.EqualTo((1, "gripper Virtual Gripper", fault)));
        Assert.That(_played.Session.Frame.State, Is.EqualTo(PoseState.Current));
        Assert.That((Hatched.IsHatched(part), appearance.Look.Label, appearance.Look.Reason), Is.EqualTo((true, ObjectMessages.FingerNotMoved, fault)));

        gripper.gameObject.SetActive(false);
        parts.Update();
        Assert.That(parts.Count, Is.Zero);
    }

    // The fingers of the robot are fixed to the flange, beside the link that is entered.
    [TestCase("tool0")]
    [TestCase("flange")]
    public void Gripper_FingersBesideTheFlangeLink_UnknownFingerIsAFault(string flangeLink)
    {
        var description = RobotDescriptionAsset.Create("arm", @"<robot name='arm'>
            <link name='base'/><link name='wrist_3'/><link name='flange'/><link name='tool0'/><link name='finger'/>
            <joint name='wrist' type='continuous'><parent link='base'/><child link='wrist_3'/><axis xyz='0 0 1'/></joint>
            <joint name='end' type='fixed'><parent link='wrist_3'/><child link='flange'/></joint>
            <joint name='tool' type='fixed'><parent link='flange'/><child link='tool0'/></joint>
            <joint name='grip' type='prismatic'><parent link='flange'/><child link='finger'/><axis xyz='0 1 0'/>
                <limit lower='0' upper='0.05' velocity='1' effort='1'/></joint></robot>");
        _played.Rig.With("_session", _played.Session).With("_robotNamespace", "arm2").With("_description", description);
        var gripper = Below<VirtualGripper>("Virtual Gripper", _played.Rig.transform).With("_flangeLink", flangeLink);
        gripper.With("_fingers", new List<GripperFinger> { new("gripp", Below<FrameProbe>("Finger", gripper.transform).transform) });

        _played.Play(0.5);

        var said = _played.Cell.Player.Logs.Single(log => ReferenceEquals(log.Context, gripper));
        var fault = ComponentMessages.FingerJointUnknown("arm", "'gripp'");
        Assert.That((said.Type, said.Message.EndsWith(ComponentMessages.Of("gripper", gripper.name, fault))), Is.EqualTo((LogType.Error, true)));
    }

    [Test]
    public void Gripper_OfAGhostWithAFault_IsListedOnlyForTheDisplayedGripper()
    {
        NewFaultyGripper(_played.Rig.transform);
        NewFaultyGripper(_played.NewGhost().transform);

        _played.Play(0.5);

        _played.Session.Parts.Update();
        Assert.That(_played.Session.Parts.FaultCount, Is.EqualTo(1));
    }

    static void NewFaultyGripper(Transform rig)
    {
        var gripper = Below<VirtualGripper>("Virtual Gripper", rig);
        gripper.With("_fingers", new List<GripperFinger> { new("gripp", Below<FrameProbe>("Finger", gripper.transform).transform) });
    }

    [Test]
    public void Gripper_FlangeUnknown_IsLoggedOnce()
    {
        Below<VirtualGripper>("Virtual Gripper", _played.Rig.transform).With("_flangeLink", "hand");

        _played.Play(0.5);

        var error = _played.Cell.Player.Logs.Single(log => log.Type == LogType.Error);
        Assert.That(error.Message, Does.Contain("'youbot'").And.Contain("'hand'"));
    }

    [Test]
    public void Ghost_Shown_HasThePoseOfTheSamples()
    {
        var ghost = _played.NewGhost();
        Assert.That(ghost.GapMetres, Is.Null);

        _played.Play();

        var gap = Vector3.Distance(_played.ToolOf(_played.Session.Frame.HeldJoints), _played.ToolOf(_played.Session.Frame.Joints));
        Assert.That(ghost.GapMetres, Is.EqualTo(gap).Within(1e-5));
        Assert.That(gap, Is.GreaterThan(1e-4));
    }

    [Test]
    public void Ghost_HiddenAndShownAgain_FollowsAgain()
    {
        var ghost = _played.NewGhost();
        _played.Play();

        ghost.Visible = false;
        Assert.That(ghost.Visible, Is.False);
        Assert.That(ghost.GapMetres, Is.Null);
        _played.Cell.Run(0.5, _played.Session);
        ghost.Visible = true;
        _played.Cell.Run(0.5, _played.Session);

        Assert.That(
            Vector3.Distance(ghost.GetComponent<RobotRig>().Tool.position, _played.ToolOf(_played.Session.Frame.HeldJoints)), Is.LessThan(1e-5));
    }

    [Test]
    public void Ghost_NoRigBeside_IsLogged()
    {
        var ghost = new GameObject("Lone Ghost").AddComponent<Ghost>();

        Assert.That(_played.Cell.Player.Logs.Single().Context, Is.SameAs(ghost));
        Assert.That(ghost.GapMetres, Is.Null);
    }

    [Test]
    public void Mount_GripperIsHiddenAndShown_StaysOnItsRig()
    {
        var gripper = Below<VirtualGripper>("Virtual Gripper", _played.Rig.transform);
        var other = Below<RobotRig>("Other robot", _played.Session.transform);
        other.transform.position = new Vector3(5, 0, 0);
        _played.Play(1);
        gripper.Mount(other);

        gripper.gameObject.SetActive(false);
        _played.Cell.Run(0.1, _played.Session);
        gripper.gameObject.SetActive(true);
        _played.Cell.Run(0.1, _played.Session);

        Assert.That(gripper.Rig, Is.SameAs(other));
        Assert.That(Vector3.Distance(gripper.transform.position, other.Flange.position), Is.LessThan(1e-5));
    }

    [Test]
    public void Mount_GripperIsDisabled_FollowsItsRigOnceEnabled()
    {
        var gripper = Below<VirtualGripper>("Virtual Gripper", _played.Rig.transform);
        var other = Below<RobotRig>("Other robot", _played.Session.transform);
        _played.Play(1);
        gripper.enabled = false;

        gripper.Mount(other);
        Assert.That(gripper.Rig, Is.Null);
        gripper.enabled = true;

        Assert.That(gripper.Rig, Is.SameAs(other));
    }

    [Test]
    public void Mount_Null_FollowsTheRigOnAParent()
    {
        var gripper = Below<VirtualGripper>("Virtual Gripper", _played.Rig.transform);
        _played.Play(1);
        gripper.Mount(Below<RobotRig>("Other robot", _played.Session.transform));

        gripper.Mount(null);

        Assert.That((gripper.Rig, gripper.Flange), Is.EqualTo((_played.Rig, _played.Rig.Flange)));
    }
}
