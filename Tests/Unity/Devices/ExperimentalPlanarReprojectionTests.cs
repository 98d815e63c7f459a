using Nowpose.Gateway.Plants;
using Nowpose.OpenXR;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using NUnit.Framework;
using UnityEngine;
using PluginMode = Microsoft.MixedReality.OpenXR.ReprojectionMode;
using ReprojectionMode = Nowpose.Latency.ReprojectionMode;
using ReprojectionSettings = Microsoft.MixedReality.OpenXR.ReprojectionSettings;

namespace Nowpose.Unity.Tests.Devices;

public sealed class ExperimentalPlanarReprojectionTests
{
    const float FrameSeconds = 1 / 60f;

    PlayedCell _cell;
    PlayedDisplay _display;
    MrilSession _session;
    RobotRig _rig;
    ExperimentalPlanarReprojection _plane;

    [SetUp]
    public void SetUp() => _cell = new PlayedCell();

    [TearDown]
    public void TearDown()
    {
        _display.Dispose();
        _cell.Dispose();
    }

    void Play(params PluginMode[] supported)
    {
        _display = new PlayedDisplay(_cell.Player, supported);
        _display.Camera.transform.SetPositionAndRotation(new Vector3(0, 1.6f, -2), Quaternion.Euler(10, 20, 0));
        _session = _cell.NewSession("ur5");
        var arm = new GameObject("Arm");
        arm.transform.SetParent(_session.transform, false);
        arm.transform.SetPositionAndRotation(new Vector3(1, 0.2f, 3), Quaternion.Euler(0, 70, 0));
        _rig = arm.AddComponent<RobotRig>();
        _plane = _session.gameObject.AddComponent<ExperimentalPlanarReprojection>();
        _session.gameObject.SetActive(true);
    }

    void Run(double seconds) => _cell.Run(seconds, _session);

    ReprojectionSettings Newest => _display.View.Set[^1];

    [Test]
    public void Posed_EachFrame_SetsThePlaneThroughTheToolFacingTheViewer()
    {
        Play();
        Run(3);
        _display.View.Set.Clear();

        Run(1);

        Assert.That(_display.View.Set, Has.Count.EqualTo(60).Within(1));
        Assert.That(Newest.ReprojectionMode, Is.EqualTo(PluginMode.PlanarManual));
        Assert.That((Newest.ReprojectionPlaneOverridePosition.Value - _rig.Tool.position).magnitude, Is.LessThan(1e-5f));
        Assert.That((Newest.ReprojectionPlaneOverrideNormal.Value + _display.Camera.transform.forward).magnitude, Is.LessThan(1e-5f));
        Assert.That(_session.Statistics.Reprojection, Is.EqualTo(ReprojectionMode.PlanarManual));
        Assert.That(_plane.Problem, Is.Null);
    }

    [Test]
    public void Posed_MovingTool_SendsItsVelocityInTheWorld()
    {
        Play();
        Run(5);
        var before = _rig.Tool.position;
        Run(FrameSeconds * 0.9);
        var after = _rig.Tool.position;

        var velocity = Newest.ReprojectionPlaneOverrideVelocity.Value;

        var expected = (after - before) / FrameSeconds;
        Assert.That(expected.magnitude, Is.GreaterThan(0.002f), "the robot moves");
        Assert.That((velocity - expected).magnitude, Is.LessThan(0.05f * expected.magnitude + 1e-4f));
    }

    [Test]
    public void Posed_RobotInANamespace_SendsTheVelocityOfItsTool()
    {
        Play();
        _rig.Follow(_session, "arm2", RobotDescriptionAsset.Create("second", RobotFiles.LoadText("ur5")));
        var joints = RobotFiles.Load("ur5").MovingJoints.Select(joint => joint.Name).ToArray();

        // The second robot rests, and the session's own robot moves.
        _cell.Run(5, _session, () => _session.Session.Listener.Received(
            new JointStateMessage(ControlTime.FromSeconds(1300 + _cell.Now - 0.08), joints, joints.Select(_ => 0.1).ToArray()),
            HeadsetTime.FromSeconds(1000 + _cell.Now), "arm2"));

        Assert.That(_session.Session.Robots[1].Frame.State, Is.EqualTo(PoseState.Current));
        Assert.That(Newest.ReprojectionPlaneOverrideVelocity.Value.magnitude, Is.LessThan(1e-4f));
    }

    [TestCase(true)]
    [TestCase(false)]
    public void Posed_VelocityDisabledOrPoseStale_SendsNoVelocity(bool isSwitchedOff)
    {
        Play();
        Run(5);
        var sent = Newest.ReprojectionPlaneOverrideVelocity;

        if (isSwitchedOff) _plane.SendVelocity = false;
        else _cell.IsPlantUp = false;
        Run(3);

        Assert.That(sent, Is.Not.Null);
        Assert.That(Newest.ReprojectionPlaneOverrideVelocity, Is.Null);
        Assert.That(Newest.ReprojectionMode, Is.EqualTo(PluginMode.PlanarManual));
    }

    [Test]
    public void OnDisable_InUse_StopsAndReportsThePreviousMode()
    {
        Play();
        Run(3);
        var during = _session.Reprojection;
        _plane.enabled = false;
        _display.View.Set.Clear();

        Run(1);

        Assert.That(during, Is.EqualTo(ReprojectionMode.PlanarManual));
        Assert.That(_display.View.Set, Is.Empty, "the request is valid for one frame");
        Assert.That(_session.Reprojection, Is.EqualTo(ReprojectionMode.Depth));
    }

    [Test]
    public void Update_RigNotPosed_ReportsThePreviousMode()
    {
        Play();
        Run(3);
        var during = _session.Reprojection;

        _rig.enabled = false;
        Run(2.5 * FrameSeconds);
        var paused = (_session.Reprojection, _session.Statistics.Reprojection);
        var problem = _plane.Problem;
        _rig.enabled = true;
        Run(1);

        Assert.That(during, Is.EqualTo(ReprojectionMode.PlanarManual));
        Assert.That(paused, Is.EqualTo((ReprojectionMode.Depth, ReprojectionMode.Depth)));
        Assert.That(problem, Is.EqualTo(DeviceMessages.PlanarPaused));
        Assert.That(_session.Reprojection, Is.EqualTo(ReprojectionMode.PlanarManual));
        Assert.That(_plane.Problem, Is.Null);
    }

    [Test]
    public void Update_RigPosedEachFrame_ReportsPlanarManualInEachFrame()
    {
        Play();
        Run(3);
        var other = 0;

        _cell.Run(1, _session, () => other += _session.Reprojection == ReprojectionMode.PlanarManual ? 0 : 1);

        Assert.That(other, Is.Zero);
    }

    [Test]
    public void Posed_RuntimeWithoutPlanarManual_IsLoggedOnce()
    {
        Play(PluginMode.Depth, PluginMode.OrientationOnly);

        Run(3);

        Assert.That(_display.View.Set, Is.Empty);
        Assert.That(_plane.Problem, Does.EndWith(DeviceMessages.PlanarNotSupported));
        Assert.That(_cell.Messages.Count(m => m.Contains("(experiment) " + DeviceMessages.PlanarNotSupported)), Is.EqualTo(1));
        Assert.That(_session.Reprojection, Is.EqualTo(ReprojectionMode.Depth));
    }

    [Test]
    public void Posed_BeforeTheRuntimesSessionOrWhileInactive_SetsNothing()
    {
        Play();
        _display.View.IsActive = false;
        Run(1);

        Assert.That(_display.View.Set, Is.Empty);
        Assert.That(_plane.Problem, Is.Null);
        Assert.That(_session.Reprojection, Is.Not.EqualTo(ReprojectionMode.PlanarManual));
    }

    [Test]
    public void OnEnable_NoRig_WarnsAndNamesTheProblem()
    {
        Play();

        var alone = new GameObject("Alone").AddComponent<ExperimentalPlanarReprojection>();

        Assert.That(alone.Problem, Does.EndWith(DeviceMessages.PlanarWithoutRig));
        Assert.That(_cell.Messages, Has.Some.Contains(DeviceMessages.PlanarLog("Alone", DeviceMessages.PlanarWithoutRig)));
    }
}
