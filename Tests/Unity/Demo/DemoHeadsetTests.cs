using Nowpose.Cli.Demo;
using Nowpose.Gateway.Plants;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Latency.Profile;
using Nowpose.Motion;
using Nowpose.Session;
using Nowpose.Simulation;
using Nowpose.Unity;
using Nowpose.Unity.Tests;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Demo;

/// <summary>Tests that the recorded data of the demo agree with the transforms in its scene. A virtual cell supplies the data.</summary>
[TestFixture("youbot")]
[TestFixture("ur5")]
public class DemoHeadsetTests(string robot)
{
    /// <summary>Tolerance that allows for the rounding of floats over a chain of ten links.</summary>
    const double ToleranceMm = 0.01;

    readonly RobotModel _model = RobotFiles.Load(robot);
    SteppedClock _clock;
    DemoHeadset _headset;
    ToolKinematics _kinematics;
    VirtualCell _cell;
    CompensationSession _described;
    RobotRig _displayed;
    Ghost _ghost;
    double _now;
    TimeSpan? _gpuTime;

    [SetUp]
    public void LoadScene()
    {
        _clock = new SteppedClock();
        _clock.Set(_now = 100);
        _headset = new DemoHeadset(_model, PlayedCell.Offline, _clock, 1000);
        _kinematics = new ToolKinematics(_model);
        _cell = new VirtualCell(
            new PickAndPlaceMotion(_model), new VirtualClock(_clock.Now, TimeSpan.FromSeconds(50), 37e-6),
            new VirtualCellSettings(50, 55, 105, 0, 0, NetworkProfile.Lan), seed: 1, _clock.Now);
        _described = null;
        _gpuTime = null;
        _ghost = UnityEngine.Object.FindObjectsOfType<Ghost>(true).Single();
        _displayed = UnityEngine.Object.FindObjectsOfType<RobotRig>(true).Single(rig => rig.Shows == RigPose.Displayed);
        UnityEngine.Object.FindObjectsOfType<BaseAnchor>(true).Single().Place(new Vector3(0.4f, -0.2f, 1.1f), Quaternion.Euler(10, 130, -20));
    }

    [TearDown]
    public void TakeDown() => _headset.Dispose();

    void Run(double seconds, Action seen = null)
    {
        for (var end = _now + seconds; _now < end; seen?.Invoke())
        {
            _clock.Set(_now += 1 / 60.0);
            if (_headset.Session != _described) (_described = _headset.Session).Described(RobotFiles.LoadText(robot));
            _cell.Run(_clock.Now, _headset.Session);
            if (_gpuTime is TimeSpan gpu) _headset.ReportGpuTime(gpu);
            _headset.Step(_now - 100);
        }
    }

    /// <summary>Converts a point in the scene to the robot's base frame, in URDF axes.</summary>
    static ToolPosition InBaseFrame(RobotRig rig, Vector3 point)
    {
        var place = rig.transform.InverseTransformPoint(point);
        return new ToolPosition(place.z, -place.x, place.y);
    }

    [Test]
    public void Tool_EachFrame_MatchesTransformAndForwardKinematics()
    {
        var held = _ghost.GetComponent<RobotRig>();
        Run(3);
        var (fromScene, fromFrame, gapError, gap, currents) = (0.0, 0.0, 0.0, 0.0, 0);

        Run(10, () =>
        {
            fromScene = Math.Max(fromScene, _headset.Tool.DistanceMm(InBaseFrame(_displayed, _displayed.Tool.position)));
            fromScene = Math.Max(fromScene, _headset.HeldTool.DistanceMm(InBaseFrame(held, held.Tool.position)));
            fromFrame = Math.Max(fromFrame, _headset.Tool.DistanceMm(_kinematics.At(_headset.Frame.Joints)));
            fromFrame = Math.Max(fromFrame, _headset.HeldTool.DistanceMm(_kinematics.At(_headset.Frame.HeldJoints)));
            var between = _headset.Tool.DistanceMm(_headset.HeldTool);
            gapError = Math.Max(gapError, Math.Abs(1000 * _ghost.GapMetres.Value - between));
            gap = Math.Max(gap, between);
            if (_headset.Frame.State == PoseState.Current) currents++;
        });

        Assert.That(fromScene, Is.LessThan(ToleranceMm));
        Assert.That(fromFrame, Is.LessThan(ToleranceMm));
        Assert.That(gapError, Is.LessThan(ToleranceMm));
        Assert.That(gap, Is.GreaterThan(5), "the robot moves, and the ghost shows the compensated distance");
        Assert.That(currents, Is.GreaterThan(500));
        Assert.That(_headset.Complaint, Is.Null);
        Assert.That(_headset.Log.ApplicationLatencies, Has.Count.GreaterThan(200));
    }

    [Test]
    public void ReportGpuTime_AboveTheLimitAndBack_ChangesTheSceneAndIsLoggedOnce()
    {
        _gpuTime = TimeSpan.FromMilliseconds(10);
        Run(3);
        _headset.Session.Calibrate(new LatencyProfile(
            40, 1, "", 60, DateTime.UnixEpoch, CalibrationMethod.Manual, 0, 15, RenderTimeSourceKind.DisplayGpuTime));
        Run(2);
        var before = (_headset.Frame.State, _headset.Alarms);

        _gpuTime = TimeSpan.FromMilliseconds(17);
        Run(1);
        var beyond = (_headset.Frame.State, _headset.Alarms);
        _gpuTime = TimeSpan.FromMilliseconds(10);
        Run(2);

        Assert.That(before, Is.EqualTo((PoseState.Current, 0)));
        Assert.That(beyond, Is.EqualTo((PoseState.OutsideRange, 1)));
        Assert.That((_headset.Frame.State, _headset.Alarms), Is.EqualTo((PoseState.Current, 1)));
    }

    [Test]
    public void Tool_TransformMoved_IsRecordedAtItsPose()
    {
        Run(3);
        var (tool, heldTool) = (_headset.Tool, _headset.HeldTool);

        _displayed.Tool.position += new Vector3(0.03f, 0, 0);
        var moved = (_headset.Tool, _headset.HeldTool);
        _ghost.GetComponent<RobotRig>().Tool.position += new Vector3(0, 0.02f, 0);

        Assert.That(moved.Tool.DistanceMm(tool), Is.EqualTo(30).Within(ToleranceMm));
        Assert.That(moved.HeldTool, Is.EqualTo(heldTool));
        Assert.That(_headset.HeldTool.DistanceMm(heldTool), Is.EqualTo(20).Within(ToleranceMm));
    }
}
