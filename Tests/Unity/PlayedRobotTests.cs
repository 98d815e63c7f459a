using Nowpose.Gateway.Plants;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using Nowpose.UnityPlayer;
using NUnit.Framework;
using UnityEngine;
using static Nowpose.Unity.Tests.PlayedRig;

namespace Nowpose.Unity.Tests;

/// <summary>Tests the rig below a running session.</summary>
public class PlayedRobotTests
{
    PlayedRig _played;

    [SetUp]
    public void Start() => _played = new PlayedRig();

    [TearDown]
    public void Stop() => _played.Dispose();

    [Test]
    public void Rig_EachFrame_ShowsThePoseOfTheSessionsFrame()
    {
        _played.Session.transform.SetPositionAndRotation(new Vector3(1, 0, 2), Quaternion.Euler(0, 30, 0));
        _played.Session.gameObject.SetActive(true);

        var worst = 0f;
        var frames = 0;
        _played.Cell.Run(5, _played.Session, () =>
        {
            worst = Math.Max(worst, Vector3.Distance(_played.Rig.Tool.position, _played.ToolOf(_played.Session.Frame.Joints)));
            frames++;
        });

        Assert.That(worst, Is.LessThan(1e-5));
        Assert.That(frames, Is.GreaterThan(290));
    }

    [Test]
    public void Rig_SessionAssigned_FollowsIt()
    {
        var other = _played.Cell.Play("ur5");
        _played.Rig.With("_session", other);

        _played.Play(0.1);

        Assert.That(_played.Rig.Model.Name, Is.EqualTo("ur5"));
        Assert.That(_played.Rig.Session, Is.SameAs(other));
    }

    [Test]
    public void Rig_DescriptionArrives_IsBuilt()
    {
        _played.Session.RobotAsset = null;
        _played.Play(0.5);
        Assert.That(_played.Rig.transform.childCount, Is.EqualTo(0));

        _played.Session.Session.Described(RobotFiles.LoadText("ur5"));
        _played.Cell.Run(5, _played.Session);

        Assert.That(_played.Rig.GetComponentsInChildren<MeshRenderer>(), Has.Length.GreaterThan(10));
        Assert.That(Vector3.Distance(_played.Rig.Tool.position, _played.ToolOf(_played.Session.Frame.Joints)), Is.LessThan(1e-5));
    }

    [Test]
    public void Rig_AnotherRobot_ReplacesThePreviousRobot()
    {
        _played.Play();
        var objects = _played.Cell.Player.ObjectCount;
        var (ur5, youbot) = (RobotDescriptionAsset.Create("ur5", RobotFiles.LoadText("ur5")), _played.Session.RobotAsset);

        _played.Session.RobotAsset = ur5;
        _played.Cell.Run(0.1, _played.Session);
        Assert.That(_played.Rig.Model.Name, Is.EqualTo("ur5"));
        Assert.That(_played.Rig.transform.childCount, Is.EqualTo(1));
        _played.Session.RobotAsset = youbot;
        _played.Cell.Run(0.1, _played.Session);

        Assert.That(_played.Cell.Player.ObjectCount, Is.EqualTo(objects + 1), "the asset of the UR5");
    }

    [Test]
    public void Rig_Paused_IsNotRebuilt()
    {
        _played.Play();
        var tool = _played.Rig.Tool;

        _played.Cell.Player.Pause(true);
        _played.Cell.Player.Pause(false);
        _played.Cell.Run(0.5, _played.Session);

        Assert.That(_played.Rig.Tool, Is.SameAs(tool));
    }

    [Test]
    public void Rig_Disabled_KeepsItsPose()
    {
        _played.Play();
        _played.Rig.enabled = false;
        var tool = _played.Rig.Tool.position;

        _played.Cell.Run(0.5, _played.Session);
        Assert.That(_played.Rig.Tool.position, Is.EqualTo(tool));
        _played.Rig.enabled = true;
        _played.Cell.Run(0.1, _played.Session);

        Assert.That(_played.Rig.Tool.position, Is.Not.EqualTo(tool));
    }

    [Test]
    public void Rig_LinkMissing_IsLoggedOnceAndTheRestContinues()
    {
        // An object with the name of the root link is sufficient for the rig to search for all links.
        Below<FrameProbe>("arm_link_0", _played.Rig.transform);
        var ghost = _played.NewGhost();

        _played.Play();

        var fault = _played.Cell.Player.Logs.Single(log => log.Type == LogType.Error);
        Assert.That(fault.Message, Does.StartWith("[Nowpose] ").And.Contain("'arm_link_1'").And.Contain("'arm_joint_1'"));
        Assert.That(fault.Context, Is.SameAs(_played.Rig));
        Assert.That(_played.Rig.Model, Is.Null);
        Assert.That(ghost.GetComponent<RobotRig>().Model, Is.Not.Null);
    }

    [Test]
    public void Rig_LinkDestroyed_IsLoggedOnceAndTheRestContinues()
    {
        var ghost = _played.NewGhost();
        _played.Play();

        UnityEngine.Object.Destroy(_played.Rig.Link("arm_link_3").gameObject);
        _played.Cell.Run(1, _played.Session);

        var fault = _played.Cell.Player.Logs.Single(log => log.Type is LogType.Error or LogType.Exception);
        Assert.That(fault.Message, Does.Match(
            "^.Nowpose. " + RigMessages.MissingLink("youbot", "arm_link_2", ".+", "arm_link_3", "arm_joint_3", "is missing")));
        Assert.That(_played.Rig.IsFollowing, Is.False);
        Assert.That(ghost.GetComponent<RobotRig>().Joints.ToArray(), Is.EqualTo(_played.Session.Frame.HeldJoints.ToArray()));
    }

    [Test]
    public void Rig_NoSession_IsLoggedUnlessAScriptMovesIt()
    {
        var alone = new GameObject("Alone").AddComponent<RobotRig>();
        var moved = new GameObject("Moved").AddComponent<RobotRig>().With("_armMaterial", new Material((Shader)null));
        moved.Bind(RobotFiles.Load("ur5"));

        _played.Cell.Frame(null);
        _played.Cell.Frame(null);

        Assert.That(_played.Cell.Player.Logs.Single().Context, Is.SameAs(alone));
        Assert.That(_played.Cell.Messages.Single(), Does.Contain(ComponentMessages.RigWithoutSession("Alone")));
    }

    [Test]
    public void Rig_BuiltWithoutMaterials_IsLoggedOnce()
    {
        var rig = new GameObject("Plain").AddComponent<RobotRig>();

        rig.Bind(RobotFiles.Load("ur5"));
        rig.Bind(RobotFiles.Load("youbot"));

        Assert.That(_played.Cell.Messages.Single(), Is.EqualTo("[Nowpose] " + RigMessages.NoMaterial("Plain", hasShader: false)));
        Assert.That(_played.Cell.Player.Logs.Single().Context, Is.SameAs(rig));
    }

    [Test]
    public void Rig_BuiltWithoutMaterials_UsesThePackagesShaderWithoutLeakingMaterials()
    {
        var shader = RepositoryAssets.NewLibrary().Load<Material>(RepositoryFiles.Package + "/Runtime/Materials/Hologram.mat").shader;
        var rig = new GameObject("Plain").AddComponent<RobotRig>();

        rig.Bind(RobotFiles.Load("ur5"));
        var drawn = rig.GetComponentsInChildren<MeshRenderer>().Select(r => r.sharedMaterial).Distinct().ToList();
        rig.Bind(RobotFiles.Load("youbot"));
        _played.Cell.Frame(null);

        Assert.That(drawn.Single() == null, "the first robot's material is destroyed with it");
        Assert.That(rig.GetComponentsInChildren<MeshRenderer>().Select(r => r.sharedMaterial.shader).Distinct(), Is.EqualTo(new[] { shader }));
    }

    // The objects of another robot may be directly below the rig or below its root link.
    [TestCase(true)]
    [TestCase(false)]
    public void Rig_DrawnObjectInItsWay_IsNamedAndTheRigIsBuiltAfterItsRemoval(bool isDirectlyBelow)
    {
        var stray = GameObject.CreatePrimitive(PrimitiveType.Cube);
        var named = isDirectlyBelow ? stray : new GameObject("other_base");
        named.name = "other_base";
        if (!isDirectlyBelow) stray.transform.SetParent(named.transform, false);
        named.transform.SetParent(_played.Rig.transform, false);
        _played.Play(0.5);
        var robot = _played.Session.Robot;
        Assert.That(_played.Cell.Messages, Has.Exactly(1).EndsWith(RigMessages.NoRootLink(robot.Name, "Robot", robot.Root.Name, "other_base")));

        UnityEngine.Object.Destroy(named);
        _played.Cell.Run(0.1, _played.Session);
        _played.Rig.enabled = false;
        _played.Rig.enabled = true;
        _played.Cell.Run(0.1, _played.Session);

        Assert.That(_played.Rig.IsFollowing);
    }
}
