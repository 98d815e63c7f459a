using Microsoft.MixedReality.OpenXR;
using Microsoft.MixedReality.OpenXR.ARSubsystems;
using Nowpose.Anchoring;
using Nowpose.Kinematics;
using Nowpose.OpenXR;
using Nowpose.Unity;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.XR.ARSubsystems;
using Object = UnityEngine.Object;

namespace Nowpose.Unity.Tests.Devices;

public sealed class QrMarkersTests
{
    static readonly TrackableId Id = new(0xAB, 0xCD);
    static readonly Vector3 Corner = new(2, 1, 3);

    // The print is tilted and turned, so none of its axes is parallel to an axis of the room.
    static readonly Quaternion Turned = Quaternion.Euler(20, 50, 10);

    PlayedCell _cell;
    PlayedOrigin _origin;
    XRMarkerSubsystem _codes;
    MrilSession _session;
    QrMarkers _markers;

    [SetUp]
    public void SetUp()
    {
        _cell = new PlayedCell();
        _origin = new PlayedOrigin();
        _codes = _origin.Device.Offer<XRMarkerSubsystem>();
        _session = _cell.NewSession();
        _markers = _session.gameObject.AddComponent<QrMarkers>();
        _session.gameObject.SetActive(true);
        _cell.Frame(_session);
        _cell.Frame(_session);
    }

    [TearDown]
    public void TearDown()
    {
        _cell.Dispose();
        _origin.Dispose();
    }

    void Report(float lastSeenAgo = 0.02f, TrackingState state = TrackingState.Tracking, TransformMode mode = TransformMode.MostStable, TrackableId? id = null)
    {
        _codes.Report(new XRMarker
        {
            trackableId = id ?? Id,
            pose = _origin.InSession(Corner, Turned),
            center = new Vector2(0.06f, 0.06f),
            size = new Vector2(0.12f, 0.12f),
            lastSeenTime = (float)_cell.Now - lastSeenAgo,
            trackingState = state,
            transformMode = mode,
            markerType = ARMarkerType.QRCode,
        });
    }

    List<MarkerSighting> Read()
    {
        var markers = new List<MarkerSighting>();
        _markers.Read(markers);
        return markers;
    }

    MarkerSighting ReadOne()
    {
        _cell.Frame(_session);
        var markers = Read();
        Assert.That(markers, Has.Count.EqualTo(1));
        return markers[0];
    }

    // Converts a point in the marker frame (right, up, out of the print) to the world.
    static Vector3 World(in RigidTransform marker, double right, double up, double outwards)
    {
        var point = marker * RigidTransform.FromXyzRpy(right, up, outwards, 0, 0, 0);
        return UnityPoses.ToWorld(point).position;
    }

    [Test]
    public void Read_TiltedCode_HasItsCentreAndAxesOnThePrint()
    {
        _codes.Texts[Id] = "nowpose:cell";
        Report();

        var marker = ReadOne();

        // In the plugin's frame x is to the right, y is down and z is out of the print.
        var right = Turned * Vector3.right;
        var up = Turned * Vector3.down;
        var outwards = Turned * Vector3.forward;
        var centre = Corner + 0.06f * right - 0.06f * up;
        Assert.That(Vector3.Distance(World(marker.Pose, 0, 0, 0), centre), Is.LessThan(1e-5));
        Assert.That(Vector3.Distance(World(marker.Pose, 0.1, 0, 0), centre + 0.1f * right), Is.LessThan(1e-5));
        Assert.That(Vector3.Distance(World(marker.Pose, 0, 0.1, 0), centre + 0.1f * up), Is.LessThan(1e-5));
        Assert.That(Vector3.Distance(World(marker.Pose, 0, 0, 0.1), centre + 0.1f * outwards), Is.LessThan(1e-5));
        Assert.That(marker.SizeMetres, Is.EqualTo(0.12).Within(1e-6));
        Assert.That(marker.Payload, Is.EqualTo("nowpose:cell"));
        Assert.That(marker.Id, Is.EqualTo(Id.ToString()));
    }

    [TestCase(TrackingState.Tracking, MarkerTracking.Tracking)]
    [TestCase(TrackingState.Limited, MarkerTracking.Limited)]
    [TestCase(TrackingState.None, MarkerTracking.None)]
    public void Read_TrackingState_IsPassedOn(TrackingState state, MarkerTracking expected)
    {
        Report(state: state);

        Assert.That(ReadOne().Tracking, Is.EqualTo(expected));
    }

    [TestCase(TransformMode.MostStable, 0)]
    [TestCase(TransformMode.Center, 0)]
    [TestCase(TransformMode.Center, 0.06f)]
    public void Read_AtTheSessionsOrigin_IsNotTracked(TransformMode mode, float shift)
    {
        _codes.Report(new XRMarker
        {
            trackableId = Id, pose = new Pose(new Vector3(shift, shift, 0), Quaternion.identity), center = new Vector2(0.06f, 0.06f),
            size = new Vector2(0.12f, 0.12f), lastSeenTime = (float)_cell.Now, trackingState = TrackingState.Tracking, transformMode = mode,
            markerType = ARMarkerType.QRCode,
        });

        Assert.That(ReadOne().Tracking, Is.EqualTo(MarkerTracking.None));
    }

    [Test]
    public void Read_LastSeen_IsOnTheSessionsClock()
    {
        Report(lastSeenAgo: 0.5f);

        var marker = ReadOne();

        // The frame after the report reads it, which adds 1/60 s.
        Assert.That((_cell.Clock.Read - marker.LastSeen).TotalSeconds, Is.EqualTo(0.5 + 1 / 60.0).Within(1e-3));
    }

    [Test]
    public void Read_StalePoseMarkedAsTracked_KeepsItsTime()
    {
        Report();
        var first = ReadOne().LastSeen;

        for (var i = 0; i < 30; i++) Assert.That(ReadOne().LastSeen, Is.EqualTo(first));

        Report();
        Assert.That(ReadOne().LastSeen, Is.GreaterThan(first));
    }

    [Test]
    public void Read_TimeInTheFuture_IsNow()
    {
        Report(lastSeenAgo: -1);

        Assert.That(ReadOne().LastSeen, Is.EqualTo(_cell.Clock.Read));
    }

    [Test]
    public void Read_TextAvailableLater_IsRequestedUntilItIsKnown()
    {
        Report();
        Assert.That(ReadOne().Payload, Is.Null);
        _codes.Texts[Id] = "late";
        Report();
        Assert.That(ReadOne().Payload, Is.EqualTo("late"));
        var asked = _codes.TextsAsked;

        for (var i = 0; i < 10; i++)
        {
            Report();
            ReadOne();
        }

        Assert.That(_codes.TextsAsked, Is.EqualTo(asked));
    }

    [Test]
    public void Read_CodeRemovedByTheDevice_IsNotReturned()
    {
        Report();
        ReadOne();

        _codes.Remove(Id);
        _cell.Frame(_session);

        Assert.That(Read(), Is.Empty);
    }

    [Test]
    public void Read_OnceWarm_AllocatesNothing()
    {
        _codes.Texts[Id] = "text";
        Report();
        Report(id: new TrackableId(1, 2));
        _cell.Frame(_session);
        var markers = new List<MarkerSighting>(8);
        _markers.Read(markers);

        markers.Clear();
        var before = GC.GetAllocatedBytesForCurrentThread();
        _markers.Read(markers);
        var allocated = GC.GetAllocatedBytesForCurrentThread() - before;

        Assert.That(markers, Has.Count.EqualTo(2));
        Assert.That(allocated, Is.Zero);
    }

    [Test]
    public void Manager_NoneOnTheOrigin_IsAddedForCodesInCornerMode()
    {
        var manager = _origin.Origin.GetComponent<ARMarkerManager>();

        Assert.That(manager, Is.Not.Null);
        Assert.That(manager.enabledMarkerTypes, Is.EqualTo(new[] { ARMarkerType.QRCode }));
        Assert.That(manager.defaultTransformMode, Is.EqualTo(TransformMode.MostStable));
        Assert.That(_cell.Messages, Has.None.Contains("QR markers"));
    }

    [Test]
    public void Manager_UsersCentreMode_IsChangedAndLogged()
    {
        var manager = _origin.Origin.GetComponent<ARMarkerManager>();
        manager.defaultTransformMode = TransformMode.Center;
        manager.enabledMarkerTypes = [];
        var second = new GameObject("Second").AddComponent<QrMarkers>();

        _cell.Frame(_session);

        Assert.That(second.Problem, Is.Null);
        Assert.That(manager.defaultTransformMode, Is.EqualTo(TransformMode.MostStable));
        Assert.That(manager.enabledMarkerTypes, Is.EqualTo(new[] { ARMarkerType.QRCode }));
        Assert.That(_cell.Messages.Count(m => m.Contains("'Second': the marker manager's mode was Center")), Is.EqualTo(1));
    }

    [Test]
    public void Read_CodeInCentreMode_HasThePluginsPose()
    {
        Report(mode: TransformMode.Center);

        Assert.That(Vector3.Distance(World(ReadOne().Pose, 0, 0, 0), Corner), Is.LessThan(1e-5));
    }

    [Test]
    public void Read_Disabled_ReturnsNothing()
    {
        Report();
        ReadOne();

        _markers.enabled = false;

        Assert.That(Read(), Is.Empty);
    }

    [Test]
    public void Manager_Disabled_StopsUnlessUserOwned()
    {
        var manager = _origin.Origin.GetComponent<ARMarkerManager>();
        var second = new GameObject("Second").AddComponent<QrMarkers>();
        _cell.Frame(_session);

        second.enabled = false;
        var ofAnother = manager.enabled;
        _markers.enabled = false;
        var meanwhile = manager.enabled;
        _markers.enabled = true;
        Report();

        Assert.That(ofAnother);
        Assert.That(meanwhile, Is.False);
        Assert.That(ReadOne().Tracking, Is.EqualTo(MarkerTracking.Tracking));
    }

    [Test]
    public void Problem_DeviceWithoutCodes_IsLoggedOnceAfterATimeout()
    {
        _origin.Device.Dispose();
        var manager = _origin.Origin.GetComponent<ARMarkerManager>();
        manager.enabled = false;
        manager.enabled = true;

        _cell.Run(2, _session);
        var early = _markers.Problem;
        _cell.Run(10, _session);

        Assert.That(early, Is.Null, "everything may still start");
        Assert.That(_markers.Problem, Does.Contain("WebCam"));
        Assert.That(_cell.Messages.Count(m => m.StartsWith("[Nowpose] QR markers 'Cell': the device's XR runtime does not offer it", StringComparison.Ordinal)), Is.EqualTo(1));
        Assert.That(Read(), Is.Empty);
    }

    [Test]
    public void Problem_NoArSession_IsReported()
    {
        _origin.Device.SessionState = 0;

        _cell.Run(4, _session);

        Assert.That(_markers.Problem, Does.StartWith("there is no AR Session in the scene"));
    }

    [Test]
    public void Problem_NoOrigin_IsReportedUntilThereIsOne()
    {
        Object.Destroy(_origin.Origin.GetComponent<ARMarkerManager>());
        _origin.Head.SetParent(null, false);
        _cell.Run(4, _session);
        var problem = _markers.Problem;

        _origin.Head.SetParent(_origin.Origin.transform, false);
        _cell.Run(1, _session);

        Assert.That(problem, Does.StartWith("there is no XR Origin above the main camera"));
        Assert.That(_markers.Problem, Is.Null);
        Assert.That(_origin.Origin.GetComponent<ARMarkerManager>(), Is.Not.Null);
    }

    [Test]
    public void Manager_XrStartsLater_IsEnabledAgainOnce()
    {
        _origin.Device.Dispose();
        var manager = _origin.Origin.GetComponent<ARMarkerManager>();
        manager.enabled = false;
        manager.enabled = true;
        _cell.Run(1, _session);

        using var device = new ArDevice();
        var codes = device.Offer<XRMarkerSubsystem>();
        _cell.Run(1, _session);
        var before = manager.subsystem;
        _cell.Player.ReportGpuTime(TimeSpan.FromMilliseconds(5));
        _cell.Run(1, _session);

        Assert.That(before, Is.Null, "nothing tells of it before a display runs");
        Assert.That(manager.subsystem, Is.SameAs(codes));
        Assert.That(_markers.Problem, Is.Null);
    }
}
