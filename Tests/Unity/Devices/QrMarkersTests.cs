using Microsoft.MixedReality.OpenXR;
using Microsoft.MixedReality.OpenXR.ARSubsystems;
using Nowpose.Anchoring;
using Nowpose.Kinematics;
using Nowpose.OpenXR;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.XR.ARSubsystems;
using static Nowpose.Unity.Tests.Devices.PlayedCodes;

namespace Nowpose.Unity.Tests.Devices;

/// <summary>Tests the sightings that the component returns for codes.</summary>
public sealed class QrMarkersTests
{
    PlayedCodes _played;

    [SetUp]
    public void SetUp() => _played = new PlayedCodes();

    [TearDown]
    public void TearDown() => _played.Dispose();

    // Converts a point in the marker frame, given as right, up and out of the print, to the world.
    static Vector3 World(in RigidTransform marker, double right, double up, double outwards)
    {
        var point = marker * RigidTransform.FromXyzRpy(right, up, outwards, 0, 0, 0);
        return UnityPoses.ToWorld(point).position;
    }

    [Test]
    public void Read_TiltedCode_HasItsCentreAndAxesOnThePrint()
    {
        _played.Codes.Texts[Id] = "nowpose:cell";
        _played.Report();

        var marker = _played.ReadOne();

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
    public void Read_AnyTrackingState_ReturnsTheCorrespondingState(TrackingState state, MarkerTracking expected)
    {
        _played.Report(state: state);

        Assert.That(_played.ReadOne().Tracking, Is.EqualTo(expected));
    }

    [TestCase(TransformMode.MostStable, 0)]
    [TestCase(TransformMode.Center, 0)]
    [TestCase(TransformMode.Center, 0.06f)]
    public void Read_CodeAtTheSessionsOrigin_IsNotTracked(TransformMode mode, float shift)
    {
        _played.Codes.Report(new XRMarker
        {
            trackableId = Id, pose = new Pose(new Vector3(shift, shift, 0), Quaternion.identity), center = new Vector2(0.06f, 0.06f),
            size = new Vector2(0.12f, 0.12f), lastSeenTime = (float)_played.Cell.Now, trackingState = TrackingState.Tracking, transformMode = mode,
            markerType = ARMarkerType.QRCode,
        });

        Assert.That(_played.ReadOne().Tracking, Is.EqualTo(MarkerTracking.None));
    }

    [Test]
    public void Read_CodeSeen_HasTheTimeOfTheSessionsClock()
    {
        _played.Report(lastSeenAgo: 0.5f);

        var marker = _played.ReadOne();

        // The component reads the report one frame later, which adds 1/60 s.
        Assert.That((_played.Cell.Clock.Read - marker.LastSeen).TotalSeconds, Is.EqualTo(0.5 + 1 / 60.0).Within(1e-3));
    }

    [Test]
    public void Read_StalePoseMarkedAsTracked_KeepsItsTime()
    {
        _played.Report();
        var first = _played.ReadOne().LastSeen;

        for (var i = 0; i < 30; i++) Assert.That(_played.ReadOne().LastSeen, Is.EqualTo(first));

        _played.Report();
        Assert.That(_played.ReadOne().LastSeen, Is.GreaterThan(first));
    }

    [Test]
    public void Read_LastSeenInTheFuture_ReturnsTheCurrentTime()
    {
        _played.Report(lastSeenAgo: -1);

        Assert.That(_played.ReadOne().LastSeen, Is.EqualTo(_played.Cell.Clock.Read));
    }

    [Test]
    public void Read_TextNotDecodedYet_IsRequestedUntilItIsKnown()
    {
        _played.Report();
        Assert.That(_played.ReadOne().Payload, Is.Null);
        _played.Codes.Texts[Id] = "late";
        _played.Report();
        Assert.That(_played.ReadOne().Payload, Is.EqualTo("late"));
        var asked = _played.Codes.TextsAsked;

        for (var i = 0; i < 10; i++)
        {
            _played.Report();
            _played.ReadOne();
        }

        Assert.That(_played.Codes.TextsAsked, Is.EqualTo(asked));
    }

    [Test]
    public void Read_CodeRemovedByTheDevice_IsNotReturned()
    {
        _played.Report();
        _played.ReadOne();

        _played.Codes.Remove(Id);
        _played.Cell.Frame(_played.Session);

        Assert.That(_played.Read(), Is.Empty);
    }

    [Test]
    public void Read_AfterWarmUp_AllocatesNothing()
    {
        _played.Codes.Texts[Id] = "text";
        _played.Report();
        _played.Report(id: new TrackableId(1, 2));
        _played.Cell.Frame(_played.Session);
        var markers = new List<MarkerSighting>(8);
        _played.Markers.Read(markers);

        markers.Clear();
        var before = GC.GetAllocatedBytesForCurrentThread();
        _played.Markers.Read(markers);
        var allocated = GC.GetAllocatedBytesForCurrentThread() - before;

        Assert.That(markers, Has.Count.EqualTo(2));
        Assert.That(allocated, Is.Zero);
    }

    [Test]
    public void Read_CodeInCentreMode_HasThePluginsPose()
    {
        _played.Report(mode: TransformMode.Center);

        Assert.That(Vector3.Distance(World(_played.ReadOne().Pose, 0, 0, 0), Corner), Is.LessThan(1e-5));
    }

    [Test]
    public void Read_Disabled_ReturnsNothing()
    {
        _played.Report();
        _played.ReadOne();

        _played.Markers.enabled = false;

        Assert.That(_played.Read(), Is.Empty);
    }

    [TestCase(false)]
    [TestCase(true)]
    public void OnEnable_OutsideTheSession_LogsAWarningUnlessABaseAnchorSearchesThere(bool hasAnchor)
    {
        var outside = new GameObject("Outside");
        outside.SetActive(false);
        outside.AddComponent<QrMarkers>().With("_session", _played.Session);
        if (hasAnchor) outside.AddComponent<BaseAnchor>();

        outside.SetActive(true);

        var warning = ComponentMessages.Of("QR markers", "Outside", ComponentMessages.SourceOutsideSession);
        Assert.That(_played.Cell.Messages.Count(message => message.Contains(warning)), Is.EqualTo(hasAnchor ? 0 : 1));
    }
}
