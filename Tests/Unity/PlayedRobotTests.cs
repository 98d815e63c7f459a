using Nowpose.Gateway.Plants;
using Nowpose.Kinematics;
using Nowpose.Session;
using Nowpose.Unity;
using Nowpose.UnityPlayer;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests;

/// <summary>Rig, gripper and ghost below a running session.</summary>
public class PlayedRobotTests
{
    PlayedCell _cell;
    MrilSession _session;
    RobotRig _rig;

    [SetUp]
    public void Start()
    {
        _cell = new PlayedCell();
        _session = _cell.NewSession();
        var material = new Material((Shader)null);
        _rig = Below<RobotRig>("Robot", _session.transform).With("_armMaterial", material).With("_toolMaterial", material);
    }

    [TearDown]
    public void Stop() => _cell.Dispose();

    static T Below<T>(string name, Transform parent) where T : Component
    {
        var made = new GameObject(name);
        made.transform.SetParent(parent, false);
        return made.AddComponent<T>();
    }

    Ghost NewGhost()
    {
        var ghost = Below<Ghost>("Ghost", _session.transform);
        ghost.GetComponent<RobotRig>().With("_shows", RigPose.Held);
        return ghost;
    }

    void Play(double seconds = 5)
    {
        _session.gameObject.SetActive(true);
        _cell.Run(seconds, _session);
    }

    Vector3 ToolOf(ReadOnlySpan<double> joints)
    {
        var poses = new RigidTransform[_session.Robot.Links.Count];
        new ForwardKinematics(_session.Robot).Compute(joints, poses);
        var tool = UnityFrame.ToUnity(poses[_session.Robot.IndexOfLink(_session.Robot.ToolLink.Name)]);
        return _rig.transform.TransformPoint(new Vector3((float)tool.X, (float)tool.Y, (float)tool.Z));
    }

    [Test]
    public void Rig_EachFrame_HasThePoseOfTheFrame()
    {
        _session.transform.SetPositionAndRotation(new Vector3(1, 0, 2), Quaternion.Euler(0, 30, 0));
        _session.gameObject.SetActive(true);

        var worst = 0f;
        var frames = 0;
        _cell.Run(5, _session, () =>
        {
            worst = Math.Max(worst, Vector3.Distance(_rig.Tool.position, ToolOf(_session.Frame.Joints)));
            frames++;
        });

        Assert.That(worst, Is.LessThan(1e-5));
        Assert.That(frames, Is.GreaterThan(290));
    }

    [Test]
    public void Rig_SessionAssigned_FollowsIt()
    {
        var other = _cell.Play("ur5");
        _rig.With("_session", other);

        Play(0.1);

        Assert.That(_rig.Model.Name, Is.EqualTo("ur5"));
        Assert.That(_rig.Session, Is.SameAs(other));
    }

    [Test]
    public void Rig_DescriptionArrives_IsBuilt()
    {
        _session.RobotAsset = null;
        Play(0.5);
        Assert.That(_rig.transform.childCount, Is.EqualTo(0));

        _session.Session.Described(RobotFiles.LoadText("ur5"));
        _cell.Run(5, _session);

        Assert.That(_rig.GetComponentsInChildren<MeshRenderer>(), Has.Length.GreaterThan(10));
        Assert.That(Vector3.Distance(_rig.Tool.position, ToolOf(_session.Frame.Joints)), Is.LessThan(1e-5));
    }

    [Test]
    public void Rig_AnotherRobot_RemovesTheOld()
    {
        Play();
        var objects = _cell.Player.ObjectCount;
        var (ur5, youbot) = (RobotDescriptionAsset.Create("ur5", RobotFiles.LoadText("ur5")), _session.RobotAsset);

        _session.RobotAsset = ur5;
        _cell.Run(0.1, _session);
        Assert.That(_rig.Model.Name, Is.EqualTo("ur5"));
        Assert.That(_rig.transform.childCount, Is.EqualTo(1));
        _session.RobotAsset = youbot;
        _cell.Run(0.1, _session);

        Assert.That(_cell.Player.ObjectCount, Is.EqualTo(objects + 1), "the asset of the UR5");
    }

    [Test]
    public void Rig_Paused_IsNotRebuilt()
    {
        Play();
        var tool = _rig.Tool;

        _cell.Player.Pause(true);
        _cell.Player.Pause(false);
        _cell.Run(0.5, _session);

        Assert.That(_rig.Tool, Is.SameAs(tool));
    }

    [Test]
    public void Rig_Disabled_KeepsItsPose()
    {
        Play();
        _rig.enabled = false;
        var tool = _rig.Tool.position;

        _cell.Run(0.5, _session);
        Assert.That(_rig.Tool.position, Is.EqualTo(tool));
        _rig.enabled = true;
        _cell.Run(0.1, _session);

        Assert.That(_rig.Tool.position, Is.Not.EqualTo(tool));
    }

    [Test]
    public void Rig_LinkMissing_IsLoggedOnceAndTheRestContinues()
    {
        // The root link alone counts as a hierarchy.
        Below<FrameProbe>("arm_link_0", _rig.transform);
        var ghost = NewGhost();

        Play();

        var fault = _cell.Player.Logs.Single(log => log.Type == LogType.Error);
        Assert.That(fault.Message, Does.StartWith("[Nowpose] ").And.Contain("'arm_link_1'").And.Contain("'arm_joint_1'"));
        Assert.That(fault.Context, Is.SameAs(_rig));
        Assert.That(_rig.Model, Is.Null);
        Assert.That(ghost.GetComponent<RobotRig>().Model, Is.Not.Null);
    }

    [Test]
    public void Rig_LinkDestroyed_IsLoggedOnceAndTheRestContinues()
    {
        var ghost = NewGhost();
        Play();

        UnityEngine.Object.Destroy(_rig.Link("arm_link_3").gameObject);
        _cell.Run(1, _session);

        var fault = _cell.Player.Logs.Single(log => log.Type is LogType.Error or LogType.Exception);
        Assert.That(fault.Message, Does.StartWith("[Nowpose] ").And.Contain("'arm_link_3'").And.Contain("is missing"));
        Assert.That(_rig.IsFollowing, Is.False);
        Assert.That(ghost.GetComponent<RobotRig>().Joints.ToArray(), Is.EqualTo(_session.Frame.HeldJoints.ToArray()));
    }

    [Test]
    public void Gripper_FingerDestroyed_TheOtherStillMoves()
    {
        var gripper = Below<VirtualGripper>("Virtual Gripper", _rig.transform);
        var lost = Below<FrameProbe>("Left", gripper.transform).transform;
        var kept = Below<FrameProbe>("Right", gripper.transform).transform;
        gripper.With("_fingers", new List<GripperFinger> { new("gripper_finger_joint_l", lost), new("gripper_finger_joint_r", kept) });
        Play();

        UnityEngine.Object.Destroy(lost.gameObject);
        _cell.Run(1, _session);

        Assert.That(_cell.Player.Logs.Where(log => log.Type == LogType.Exception), Is.Empty);
        var joint = _session.Robot.IndexOfMovingJoint("gripper_finger_joint_r");
        Assert.That(kept.localPosition.magnitude, Is.EqualTo(Math.Abs(_session.Frame.Joints[joint])).Within(1e-6));
    }

    [Test]
    public void Rig_NoSession_IsLoggedUnlessAScriptMovesIt()
    {
        var alone = new GameObject("Alone").AddComponent<RobotRig>();
        var moved = new GameObject("Moved").AddComponent<RobotRig>().With("_armMaterial", new Material((Shader)null));
        moved.Bind(RobotFiles.Load("ur5"));

        _cell.Frame(null);
        _cell.Frame(null);

        Assert.That(_cell.Player.Logs.Single().Context, Is.SameAs(alone));
        Assert.That(_cell.Messages.Single(), Does.Contain("'Alone'").And.Contain("no session"));
    }

    [Test]
    public void Rig_BuiltWithoutMaterials_IsLoggedOnce()
    {
        var rig = new GameObject("Plain").AddComponent<RobotRig>();

        rig.Bind(RobotFiles.Load("ur5"));
        rig.Bind(RobotFiles.Load("youbot"));

        Assert.That(_cell.Messages.Single(), Does.Contain("'Plain' has no material").And.Contain("magenta"));
        Assert.That(_cell.Player.Logs.Single().Context, Is.SameAs(rig));
    }

    [Test]
    public void Rig_BuiltWithoutMaterials_UsesThePackagesShaderWithoutLeakingMaterials()
    {
        var shader = new AssetLibrary(RepositoryFiles.Root).Load<Material>(RepositoryFiles.Package + "/Runtime/Materials/Hologram.mat").shader;
        var rig = new GameObject("Plain").AddComponent<RobotRig>();

        rig.Bind(RobotFiles.Load("ur5"));
        var drawn = rig.GetComponentsInChildren<MeshRenderer>().Select(r => r.sharedMaterial).Distinct().ToList();
        rig.Bind(RobotFiles.Load("youbot"));
        _cell.Frame(null);

        Assert.That(drawn.Single() == null, "the first robot's material is destroyed with it");
        Assert.That(rig.GetComponentsInChildren<MeshRenderer>().Select(r => r.sharedMaterial.shader).Distinct(), Is.EqualTo(new[] { shader }));
    }

    [Test]
    public void Gripper_EnabledBeforeTheRig_HasNoDelay()
    {
        _rig.enabled = false;
        var gripper = Below<VirtualGripper>("Virtual Gripper", _rig.transform);
        Play(0.1);
        _rig.enabled = true;

        var worst = 0f;
        _cell.Run(3, _session, () => worst = Math.Max(worst, Vector3.Distance(gripper.transform.position, _rig.Flange.position)));

        Assert.That(gripper.Flange, Is.SameAs(_rig.Link("arm_link_5")));
        Assert.That(worst, Is.LessThan(1e-6));
        Assert.That(_rig.Flange.position, Is.Not.EqualTo(_rig.transform.position));
    }

    [Test]
    public void Gripper_FingerJointMoves_OpensAndCloses()
    {
        var gripper = Below<VirtualGripper>("Virtual Gripper", _rig.transform);
        var finger = Below<FrameProbe>("Finger", gripper.transform).transform;
        gripper.With("_fingers", new List<GripperFinger> { new("gripper_finger_joint_l", finger) });
        _session.gameObject.SetActive(true);
        var (min, max) = (1f, 0f);

        _cell.Run(12, _session, () =>
        {
            if (_session.Frame.State != PoseState.Current) return;
            min = Math.Min(min, finger.localPosition.magnitude);
            max = Math.Max(max, finger.localPosition.magnitude);
            var joint = _session.Robot.IndexOfMovingJoint("gripper_finger_joint_l");
            Assert.That(finger.localPosition.magnitude, Is.EqualTo(_session.Frame.Joints[joint]).Within(1e-6));
        });

        Assert.That(min, Is.LessThan(0.0015));
        Assert.That(max, Is.GreaterThan(0.0085));
    }

    [Test]
    public void Gripper_NoRigAbove_NamesTheRemedy()
    {
        var gripper = new GameObject("Lost Gripper").AddComponent<VirtualGripper>();

        _cell.Frame(null);

        var fault = _cell.Player.Logs.Single();
        Assert.That(fault.Type, Is.EqualTo(LogType.Error));
        Assert.That(fault.Message, Does.Contain("'Lost Gripper'").And.Contain("assign a rig"));
        Assert.That(fault.Context, Is.SameAs(gripper));
    }

    [Test]
    public void Gripper_RobotWithoutItsJoints_IsLoggedOnceWithoutAWarning()
    {
        var gripper = Below<VirtualGripper>("Virtual Gripper", _rig.transform);
        var finger = Below<FrameProbe>("Finger", gripper.transform).transform;
        gripper.With("_fingers", new List<GripperFinger> { new("left_joint", finger), new("gripper_finger_joint_l", finger), new("right_joint", finger) });

        Play(0.5);

        var said = _cell.Player.Logs.Single(l => l.Message.Contains("gripper"));
        Assert.That(said.Type, Is.EqualTo(LogType.Log));
        Assert.That(said.Message, Is.EqualTo(
            "[Nowpose] gripper 'Virtual Gripper': robot 'youbot' has no moving joint 'left_joint' and no 'right_joint', so its finger does not move"));
        Assert.That(said.Context, Is.SameAs(gripper));
    }

    [Test]
    public void Gripper_FlangeUnknown_IsLoggedOnce()
    {
        Below<VirtualGripper>("Virtual Gripper", _rig.transform).With("_flangeLink", "hand");

        Play(0.5);

        Assert.That(_cell.Messages.Single(), Does.Contain("'youbot'").And.Contain("'hand'"));
    }

    [Test]
    public void Ghost_Shown_HasThePoseOfTheSamples()
    {
        var ghost = NewGhost();
        Assert.That(ghost.GapMetres, Is.Null);

        Play();

        var gap = Vector3.Distance(ToolOf(_session.Frame.HeldJoints), ToolOf(_session.Frame.Joints));
        Assert.That(ghost.GapMetres, Is.EqualTo(gap).Within(1e-5));
        Assert.That(gap, Is.GreaterThan(1e-4));
    }

    [Test]
    public void Ghost_HiddenAndShownAgain_FollowsAgain()
    {
        var ghost = NewGhost();
        Play();

        ghost.Visible = false;
        Assert.That(ghost.Visible, Is.False);
        Assert.That(ghost.GapMetres, Is.Null);
        _cell.Run(0.5, _session);
        ghost.Visible = true;
        _cell.Run(0.5, _session);

        Assert.That(Vector3.Distance(ghost.GetComponent<RobotRig>().Tool.position, ToolOf(_session.Frame.HeldJoints)), Is.LessThan(1e-5));
    }

    [Test]
    public void Ghost_NoRigBeside_IsLogged()
    {
        var ghost = new GameObject("Lone Ghost").AddComponent<Ghost>();

        Assert.That(_cell.Player.Logs.Single().Context, Is.SameAs(ghost));
        Assert.That(ghost.GapMetres, Is.Null);
    }
}
