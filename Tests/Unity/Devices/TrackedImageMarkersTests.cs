using Nowpose.Anchoring;
using Nowpose.ArFoundation;
using Nowpose.Kinematics;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.XR.ARFoundation;
using UnityEngine.XR.ARSubsystems;

namespace Nowpose.Unity.Tests.Devices;

public sealed class TrackedImageMarkersTests
{
    static readonly TrackableId Id = new(1, 1);
    static readonly Vector3 Centre = new(2, 1, 3);
    static readonly Quaternion Turned = Quaternion.Euler(20, 50, 10);

    PlayedCell _cell;
    PlayedOrigin _origin;
    XRImageTrackingSubsystem _images;
    MrilSession _session;
    TrackedImageMarkers _markers;

    [SetUp]
    public void SetUp()
    {
        _cell = new PlayedCell();
        _origin = new PlayedOrigin();
        _images = _origin.Device.Offer<XRImageTrackingSubsystem>();
        _origin.Origin.gameObject.AddComponent<ARTrackedImageManager>();
        _session = _cell.NewSession();
        _markers = _session.gameObject.AddComponent<TrackedImageMarkers>();
        _session.gameObject.SetActive(true);
        _cell.Frame(_session);
    }

    [TearDown]
    public void TearDown()
    {
        _cell.Dispose();
        _origin.Dispose();
    }

    MarkerSighting Report(TrackingState state)
    {
        _images.Report(new XRTrackedImage(Id, "cell-7", _origin.InSession(Centre, Turned), new Vector2(0.2f, 0.3f), state));
        return ReadOne();
    }

    MarkerSighting ReadOne()
    {
        _cell.Frame(_session);
        var markers = new List<MarkerSighting>();
        _markers.Read(markers);
        Assert.That(markers, Has.Count.EqualTo(1));
        return markers[0];
    }

    [Test]
    public void Read_TiltedImage_HasItsAxesOnThePrintAndItsNameAsPayload()
    {
        var marker = Report(TrackingState.Tracking);

        // In AR Foundation's frame x is to the right, z is towards the upper edge and y is out of the print.
        var axes = new[] { (Turned * Vector3.right, (0.1, 0.0, 0.0)), (Turned * Vector3.forward, (0.0, 0.1, 0.0)), (Turned * Vector3.up, (0.0, 0.0, 0.1)) };
        foreach (var (axis, (x, y, z)) in axes)
        {
            var point = marker.Pose * RigidTransform.FromXyzRpy(x, y, z, 0, 0, 0);
            Assert.That(Vector3.Distance(UnityPoses.ToWorld(point).position, Centre + 0.1f * axis), Is.LessThan(1e-5));
        }
        Assert.That(marker.Payload, Is.EqualTo("cell-7"));
        Assert.That(marker.SizeMetres, Is.EqualTo(0.2).Within(1e-6), "the size is the width of the image");
    }

    [TestCase(0, 0, 0)]
    [TestCase(0, 1.6f, 0)]
    [TestCase(1, 0.5f, -2)]
    public void Read_ImageAtTheSessionsOrigin_IsNotTracked(float x, float y, float z)
    {
        _origin.Origin.transform.position = new Vector3(x, y, z);
        var nowhere = new Pose(Vector3.zero, Quaternion.identity);
        _images.Report(new XRTrackedImage(Id, "cell-7", nowhere, new Vector2(0.2f, 0.3f), TrackingState.Tracking));

        Assert.That(ReadOne().Tracking, Is.EqualTo(MarkerTracking.None));
        Assert.That(Report(TrackingState.Tracking).Tracking, Is.EqualTo(MarkerTracking.Tracking));
    }

    [Test]
    public void Read_ImageOutOfView_HasTheTimeOfItsLastTracking()
    {
        var tracked = Report(TrackingState.Tracking);
        var seen = Report(TrackingState.Limited);
        _cell.Run(1, _session);

        var later = ReadOne();

        Assert.That(tracked.LastSeen, Is.LessThanOrEqualTo(_cell.Clock.Read));
        Assert.That(seen.LastSeen, Is.EqualTo(tracked.LastSeen));
        Assert.That(later.LastSeen, Is.EqualTo(tracked.LastSeen));
        Assert.That(later.Tracking, Is.EqualTo(MarkerTracking.Limited));
    }

    [Test]
    public void Read_ImageNeverTracked_HasTheTimeOfItsFirstReport()
    {
        var first = Report(TrackingState.Limited);

        var later = Report(TrackingState.Limited);

        Assert.That(later.LastSeen, Is.EqualTo(first.LastSeen));
    }

    [Test]
    public void Read_UnchangedPose_KeepsItsTime()
    {
        var first = Report(TrackingState.Tracking);

        for (var i = 0; i < 10; i++) Assert.That(Report(TrackingState.Tracking).LastSeen, Is.EqualTo(first.LastSeen));
    }

    [Test]
    public void Read_ImageInView_LastSeenIsTheTimeOfThePoseChange()
    {
        var first = Report(TrackingState.Tracking);

        var pose = _origin.InSession(Centre + new Vector3(0.0001f, 0, 0), Turned);
        _images.Report(new XRTrackedImage(Id, "cell-7", pose, new Vector2(0.2f, 0.3f), TrackingState.Tracking));
        var second = ReadOne();

        Assert.That(second.LastSeen, Is.GreaterThan(first.LastSeen));
        Assert.That(second.LastSeen, Is.EqualTo(_cell.Clock.Read));
    }

    [Test]
    public void Read_AfterWarmUp_AllocatesNothing()
    {
        Report(TrackingState.Tracking);
        // The second reading is the first that compares a pose.
        ReadOne();
        var markers = new List<MarkerSighting>(4);

        var before = GC.GetAllocatedBytesForCurrentThread();
        _markers.Read(markers);
        var allocated = GC.GetAllocatedBytesForCurrentThread() - before;

        Assert.That(markers, Has.Count.EqualTo(1));
        Assert.That(allocated, Is.Zero);
    }

    [Test]
    public void Problem_OriginWithoutAManager_NamesTheRemedy()
    {
        UnityEngine.Object.Destroy(_origin.Origin.GetComponent<ARTrackedImageManager>());

        _cell.Run(5, _session);

        Assert.That(_markers.Problem, Does.StartWith(DeviceMessages.NoManager("ARTrackedImageManager", "")));
        Assert.That(_cell.Messages.Count(m => m.Contains("tracked images 'Cell'")), Is.EqualTo(1));
    }

    [Test]
    public void Read_NoSessionAbove_UsesTheTimeOfTheStopwatchClock()
    {
        var alone = new GameObject("Alone").AddComponent<TrackedImageMarkers>();
        var clock = new StopwatchHeadsetClock();
        var before = clock.Now;
        Report(TrackingState.Tracking);
        var markers = new List<MarkerSighting>();

        alone.Read(markers);

        Assert.That(markers[0].LastSeen, Is.GreaterThanOrEqualTo(before).And.LessThanOrEqualTo(clock.Now));
    }

    [TestCase(false)]
    [TestCase(true)]
    public void OnEnable_OutsideTheSession_LogsAWarningUnlessABaseAnchorSearchesThere(bool hasAnchor)
    {
        var outside = new GameObject("Outside");
        outside.SetActive(false);
        outside.AddComponent<TrackedImageMarkers>().With("_session", _session);
        if (hasAnchor) outside.AddComponent<BaseAnchor>();

        outside.SetActive(true);

        var warning = ComponentMessages.Of("tracked images", "Outside", ComponentMessages.SourceOutsideSession);
        Assert.That(_cell.Messages.Count(message => message.Contains(warning)), Is.EqualTo(hasAnchor ? 0 : 1));
    }

    [Test]
    public void Read_PoseChangesWhileTrackingIsLimited_HasTheTimeOfItsLastTracking()
    {
        var tracked = Report(TrackingState.Tracking);
        _cell.Run(1, _session);
        var moved = _origin.InSession(Centre + Vector3.up, Turned);
        _images.Report(new XRTrackedImage(Id, "cell-7", moved, new Vector2(0.2f, 0.3f), TrackingState.Limited));

        Assert.That(ReadOne().LastSeen, Is.EqualTo(tracked.LastSeen));
    }

    [Test]
    public void Read_ComponentDisabled_ListsNoImages()
    {
        Report(TrackingState.Tracking);
        _markers.enabled = false;
        var markers = new List<MarkerSighting>();

        _markers.Read(markers);

        Assert.That(markers, Is.Empty);
    }
}
