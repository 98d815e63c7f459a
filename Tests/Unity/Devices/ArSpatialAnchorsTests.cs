using Nowpose.Anchoring;
using Nowpose.ArFoundation;
using Nowpose.Kinematics;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.XR.ARFoundation;
using UnityEngine.XR.ARSubsystems;
using Object = UnityEngine.Object;

namespace Nowpose.Unity.Tests.Devices;

[TestFixture("5.1")]
[TestFixture("6.2")]
[TestFixture("6.3")]
public sealed class ArSpatialAnchorsTests(string arFoundation)
{
    static readonly RigidTransform Place = RigidTransform.FromXyzRpy(1.5, -0.4, 0.8, 0.1, 0.2, 0.3);

    PlayedCell _cell;
    PlayedOrigin _origin;
    XRAnchorSubsystem _device;
    GameObject _object;
    ArSpatialAnchors _anchors;

    [SetUp]
    public void SetUp()
    {
        _cell = new PlayedCell();
        _origin = new PlayedOrigin();
        _origin.Device.ArFoundation = Version.Parse(arFoundation);
        _device = _origin.Device.Offer<XRAnchorSubsystem>();
        _object = new GameObject("Anchors");
        _anchors = _object.AddComponent<ArSpatialAnchors>();
        Run(0.1);
    }

    [TearDown]
    public void TearDown()
    {
        _cell.Dispose();
        _origin.Dispose();
    }

    void Run(double seconds) => _cell.Run(seconds, null);

    static double Metres(RigidTransform? a, in RigidTransform b)
    {
        var apart = a.Value.Inverse * b;
        return Math.Sqrt(apart.X * apart.X + apart.Y * apart.Y + apart.Z * apart.Z);
    }

    // Returns the id of the device's only anchor.
    TrackableId IdOfTheOnlyOne()
    {
        foreach (var anchor in _anchors.Manager.trackables) return anchor.trackableId;
        return TrackableId.invalidId;
    }

    [Test]
    public void Hold_DeviceAccepts_AnchorIsHeldAtThePose()
    {
        var anchor = _anchors.Hold(Place);
        var before = anchor.State;

        Run(0.1);

        Assert.That(before, Is.EqualTo(SpatialAnchorState.Pending));
        Assert.That(anchor.State, Is.EqualTo(SpatialAnchorState.Tracking));
        Assert.That(Metres(anchor.Pose, Place), Is.LessThan(1e-5));
        Assert.That(anchor.Problem, Is.Null);
        Assert.That(anchor.KeptAs, Is.Null);
        Assert.That(_device.Count, Is.EqualTo(1));
    }

    // An object in the active scene is destroyed when that scene is unloaded.
    [Test]
    public void Hold_DeviceAccepts_AnchorIsAnObjectOfTheOrigin()
    {
        _anchors.Hold(Place);
        Run(0.1);

        Assert.That(Object.FindObjectOfType<ARAnchor>().transform.parent, Is.SameAs(_origin.Origin.TrackablesParent));
    }

    [Test]
    public void Pose_DeviceCorrectsItsMap_FollowsTheCorrection()
    {
        var anchor = _anchors.Hold(Place);
        Run(0.1);
        var corrected = Place * RigidTransform.FromXyzRpy(0.01, 0.02, 0, 0, 0, 0);
        var world = UnityPoses.ToWorld(corrected);

        _device.Place(IdOfTheOnlyOne(), _origin.InSession(world.position, world.rotation), TrackingState.Tracking);
        Run(0.1);

        Assert.That(Metres(anchor.Pose, corrected), Is.LessThan(1e-5));
    }

    [Test]
    public void State_DeviceLosesTracking_IsLostWithTheLastPoseAndRecovers()
    {
        var anchor = _anchors.Hold(Place);
        Run(0.1);
        var id = IdOfTheOnlyOne();
        var world = UnityPoses.ToWorld(Place);

        _device.Place(id, new Pose(Vector3.zero, Quaternion.identity), TrackingState.Limited);
        Run(0.1);
        var (lost, pose) = (anchor.State, anchor.Pose);
        _device.Place(id, _origin.InSession(world.position, world.rotation), TrackingState.Tracking);
        Run(0.1);

        Assert.That(lost, Is.EqualTo(SpatialAnchorState.Lost));
        Assert.That(Metres(pose, Place), Is.LessThan(1e-5), "the last pose is kept");
        Assert.That(anchor.State, Is.EqualTo(SpatialAnchorState.Tracking));
    }

    [TestCase(false)]
    [TestCase(true)]
    public void State_SwitchedOff_IsLostWithTheReasonUntilItIsSwitchedOn(bool isObject)
    {
        var anchor = _anchors.Hold(Place);
        Run(0.1);
        void Switch(bool on)
        {
            if (isObject) _object.SetActive(on);
            else _anchors.enabled = on;
            Run(0.1);
        }

        Switch(false);
        Assert.That((anchor.State, anchor.Problem), Is.EqualTo((SpatialAnchorState.Lost, DeviceMessages.AnchorsOff)));
        Assert.That(Metres(anchor.Pose, Place), Is.LessThan(1e-5), "the last pose is kept");
        Switch(true);

        Assert.That((anchor.State, anchor.Problem), Is.EqualTo((SpatialAnchorState.Tracking, (string)null)));
    }

    // AR Foundation no longer updates anchors without a running subsystem, so that they would keep their last state.
    [Test]
    public void State_SubsystemStops_IsLostUntilItRuns()
    {
        var anchor = _anchors.Hold(Place);
        Run(0.1);

        _device.Stop();
        Run(5);
        Assert.That((anchor.State, _anchors.Problem), Is.EqualTo((SpatialAnchorState.Lost, DeviceMessages.NotRunning("ARAnchorManager"))));
        _device.Start();
        Run(0.1);

        Assert.That((anchor.State, _anchors.Problem), Is.EqualTo((SpatialAnchorState.Tracking, (string)null)));
    }

    // After a restart of OpenXR, the subsystem is another object, which does not know the anchors of the earlier one.
    [Test]
    public void State_RuntimeRestarted_Fails()
    {
        var anchor = _anchors.Hold(Place);
        Run(0.1);

        _device.Stop();
        Run(1);
        var meanwhile = anchor.State;
        using var restarted = new ArDevice { ArFoundation = Version.Parse(arFoundation) };
        restarted.Offer<XRAnchorSubsystem>();
        _cell.Player.ReportGpuTime(TimeSpan.FromMilliseconds(5));
        Run(1);

        Assert.That(meanwhile, Is.EqualTo(SpatialAnchorState.Lost));
        Assert.That((anchor.State, anchor.Problem), Is.EqualTo((SpatialAnchorState.Failed, DeviceMessages.AnchorOfEarlierSession)));
        anchor = _anchors.Hold(Place);
        Run(0.1);
        Assert.That(anchor.State, Is.EqualTo(SpatialAnchorState.Tracking));
    }

    [Test]
    public void Hold_DeviceAcceptsNoAnchors_FailsAfterATimeoutWithTheReason()
    {
        _device.Accepts = false;
        var anchor = _anchors.Hold(Place);
        Run(5);
        var early = anchor.State;

        Run(6);

        Assert.That(early, Is.EqualTo(SpatialAnchorState.Pending));
        Assert.That(anchor.State, Is.EqualTo(SpatialAnchorState.Failed));
        Assert.That(anchor.Problem, Is.EqualTo(DeviceMessages.AnchorNotCreated));
    }

    [Test]
    public void Hold_DeviceAcceptsAnchorsLater_AnchorIsHeld()
    {
        _device.Accepts = false;
        var anchor = _anchors.Hold(Place);
        Run(5);

        _device.Accepts = true;
        Run(1.1);

        Assert.That((anchor.State, anchor.Problem), Is.EqualTo((SpatialAnchorState.Tracking, (string)null)));
    }

    [Test]
    public void Hold_DeviceWithoutAnchors_FailsWithTheReason()
    {
        _origin.Device.Dispose();
        var manager = _anchors.Manager;
        manager.enabled = false;
        manager.enabled = true;

        var anchor = _anchors.Hold(Place);
        Run(11);

        Assert.That(anchor.State, Is.EqualTo(SpatialAnchorState.Failed));
        Assert.That(anchor.Problem, Does.Contain(DeviceMessages.NotOffered("ARAnchorManager", "")));
        Assert.That(_cell.Messages.Count(m => m.Contains("spatial anchors 'Anchors'")), Is.EqualTo(1));
    }

    [Test]
    public void State_DeviceDropsTheAnchor_Fails()
    {
        var anchor = _anchors.Hold(Place);
        Run(0.1);

        _device.Remove(IdOfTheOnlyOne());
        Run(0.1);

        Assert.That(anchor.State, Is.EqualTo(SpatialAnchorState.Failed));
        Assert.That(anchor.Problem, Is.EqualTo(DeviceMessages.AnchorRemoved));
    }

    [Test]
    public void Dispose_HeldAnchor_RemovesItFromTheDevice()
    {
        var anchor = _anchors.Hold(Place);
        Run(0.1);

        anchor.Dispose();
        anchor.Dispose();
        Run(0.1);

        Assert.That(_device.Count, Is.Zero);
        Assert.That(anchor.State, Is.EqualTo(SpatialAnchorState.Failed));
        Assert.That(Object.FindObjectOfType<ARAnchor>(), Is.Null);
    }

    [Test]
    public void Dispose_BeforeTheDeviceCreatedIt_CreatesNothing()
    {
        _anchors.Hold(Place).Dispose();
        Run(0.1);

        Assert.That(_device.Count, Is.Zero);
    }

    [Test]
    public void OnDestroy_HeldAnchors_FailAndAreRemoved()
    {
        var anchor = _anchors.Hold(Place);
        Run(0.1);

        Object.Destroy(_object);
        Run(0.1);

        Assert.That(anchor.State, Is.EqualTo(SpatialAnchorState.Failed));
        Assert.That(_device.Count, Is.Zero);
    }

    [Test]
    public void Keep_NoStore_ReportsTheMissingStoreAndTheAnchorStaysHeld()
    {
        var anchor = _anchors.Hold(Place);
        Run(0.1);

        anchor.Keep("cell");
        Run(0.1);

        Assert.That(_anchors.IsReady, Is.False);
        Assert.That(anchor.State, Is.EqualTo(SpatialAnchorState.Tracking));
        Assert.That(anchor.KeptAs, Is.Null);
        Assert.That(anchor.Problem, Is.EqualTo(DeviceMessages.NoStoreComponent));
        Assert.That(_anchors.Find("cell"), Is.Null);
    }

    [Test]
    public void Update_AfterWarmUp_AllocatesNothing()
    {
        var anchor = (ArSpatialAnchor)_anchors.Hold(Place);
        Run(1);

        var before = GC.GetAllocatedBytesForCurrentThread();
        for (var i = 0; i < 100; i++) anchor.Follow();

        Assert.That(GC.GetAllocatedBytesForCurrentThread() - before, Is.Zero);
    }
}
