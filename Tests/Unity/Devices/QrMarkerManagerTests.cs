using Microsoft.MixedReality.OpenXR;
using Microsoft.MixedReality.OpenXR.ARSubsystems;
using Nowpose.Anchoring;
using Nowpose.OpenXR;
using Nowpose.Unity.Messages;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.XR.ARSubsystems;
using Object = UnityEngine.Object;

namespace Nowpose.Unity.Tests.Devices;

/// <summary>Tests the AR Marker Manager that the component adds or uses, and the problems that the component reports.</summary>
public sealed class QrMarkerManagerTests
{
    PlayedCodes _played;

    [SetUp]
    public void SetUp() => _played = new PlayedCodes();

    [TearDown]
    public void TearDown() => _played.Dispose();

    [Test]
    public void Manager_MissingOnTheOrigin_IsAddedForQrCodesInMostStableMode()
    {
        var manager = _played.Origin.Origin.GetComponent<ARMarkerManager>();

        Assert.That(manager, Is.Not.Null);
        Assert.That(manager.enabledMarkerTypes, Is.EqualTo(new[] { ARMarkerType.QRCode }));
        Assert.That(manager.defaultTransformMode, Is.EqualTo(TransformMode.MostStable));
        Assert.That(_played.Cell.Messages, Has.None.Contains("QR markers"));
    }

    [Test]
    public void Manager_InCentreMode_IsSetToMostStableModeAndTheChangeIsLogged()
    {
        var manager = _played.Origin.Origin.GetComponent<ARMarkerManager>();
        manager.defaultTransformMode = TransformMode.Center;
        manager.enabledMarkerTypes = [];
        var second = new GameObject("Second").AddComponent<QrMarkers>();

        _played.Cell.Frame(_played.Session);

        Assert.That(second.Problem, Is.Null);
        Assert.That(manager.defaultTransformMode, Is.EqualTo(TransformMode.MostStable));
        Assert.That(manager.enabledMarkerTypes, Is.EqualTo(new[] { ARMarkerType.QRCode }));
        Assert.That(_played.Cell.Messages, Has.Exactly(1).EndsWith(DeviceMessages.MarkerMode("Second", "Center", "MostStable")));
    }

    [Test]
    public void Manager_ComponentDisabled_IsRemovedOnlyByTheComponentThatAddedIt()
    {
        var manager = Manager;
        var second = new GameObject("Second").AddComponent<QrMarkers>();
        _played.Cell.Frame(_played.Session);

        second.enabled = false;
        _played.Cell.Frame(_played.Session);
        var ofAnother = Manager;
        _played.Markers.enabled = false;
        _played.Cell.Frame(_played.Session);
        var meanwhile = Manager;
        _played.Markers.enabled = true;
        _played.Cell.Frame(_played.Session);
        _played.Report();

        Assert.That(ofAnother, Is.SameAs(manager));
        Assert.That(meanwhile == null);
        Assert.That(_played.ReadOne().Tracking, Is.EqualTo(MarkerTracking.Tracking));
    }

    // A cell may be unloaded and loaded again, while the XR Origin stays in another scene.
    [TestCase(true)]
    [TestCase(false)]
    public void Manager_ComponentThatAddedItGoes_AnotherComponentReadsCodes(bool isLoadedLater)
    {
        var second = isLoadedLater ? null : new GameObject("Second").AddComponent<QrMarkers>();
        _played.Cell.Frame(_played.Session);

        Object.Destroy(_played.Markers);
        _played.Cell.Frame(_played.Session);
        second ??= new GameObject("Second").AddComponent<QrMarkers>();
        _played.Cell.Run(4, _played.Session);
        _played.Report();
        _played.Cell.Frame(_played.Session);

        var codes = new List<MarkerSighting>();
        second.Read(codes);
        Assert.That((codes.Count, second.Problem), Is.EqualTo((1, (string)null)));
    }

    [Test]
    public void Manager_OfTheUser_StaysWhenTheComponentIsDisabled()
    {
        Object.Destroy(_played.Markers);
        _played.Cell.Frame(_played.Session);
        var manager = _played.Origin.Origin.gameObject.AddComponent<ARMarkerManager>();
        var markers = new GameObject("Second").AddComponent<QrMarkers>();
        _played.Cell.Frame(_played.Session);

        markers.enabled = false;
        _played.Cell.Frame(_played.Session);

        Assert.That(manager != null && manager.enabled);
    }

    ARMarkerManager Manager => _played.Origin.Origin.GetComponent<ARMarkerManager>();

    [Test]
    public void Problem_DeviceWithoutCodes_IsLoggedOnceAfterATimeout()
    {
        _played.Origin.Device.Dispose();
        var manager = _played.Origin.Origin.GetComponent<ARMarkerManager>();
        manager.enabled = false;
        manager.enabled = true;

        _played.Cell.Run(2, _played.Session);
        var early = _played.Markers.Problem;
        _played.Cell.Run(10, _played.Session);

        Assert.That(early, Is.Null, "no problem is reported while components may still start");
        Assert.That(_played.Markers.Problem, Does.Contain("WebCam"));
        Assert.That(_played.Cell.Messages, Has.Exactly(1).EqualTo(
            "[Nowpose] " + ComponentMessages.Of("QR markers", "Cell", DeviceMessages.NotOffered("ARMarkerManager", DeviceMessages.QrCodeNeeds))));
        Assert.That(_played.Read(), Is.Empty);
    }

    [Test]
    public void Problem_NoArSession_IsReported()
    {
        _played.Origin.Device.SessionState = 0;

        _played.Cell.Run(4, _played.Session);

        Assert.That(_played.Markers.Problem, Is.EqualTo(DeviceMessages.NoArSession));
    }

    [Test]
    public void Problem_NoOrigin_IsReportedUntilAnOriginExists()
    {
        Object.Destroy(_played.Origin.Origin.GetComponent<ARMarkerManager>());
        _played.Origin.Head.SetParent(null, false);
        _played.Cell.Run(4, _played.Session);
        var problem = _played.Markers.Problem;

        _played.Origin.Head.SetParent(_played.Origin.Origin.transform, false);
        _played.Cell.Run(1, _played.Session);

        Assert.That(problem, Is.EqualTo(DeviceMessages.NoOrigin));
        Assert.That(_played.Markers.Problem, Is.Null);
        Assert.That(_played.Origin.Origin.GetComponent<ARMarkerManager>(), Is.Not.Null);
    }

    [Test]
    public void Manager_XrStartsLater_IsEnabledAgainOnce()
    {
        _played.Origin.Device.Dispose();
        var manager = _played.Origin.Origin.GetComponent<ARMarkerManager>();
        manager.enabled = false;
        manager.enabled = true;
        _played.Cell.Run(1, _played.Session);

        using var device = new ArDevice();
        var codes = device.Offer<XRMarkerSubsystem>();
        _played.Cell.Run(1, _played.Session);
        var before = manager.subsystem;
        _played.Cell.Player.ReportGpuTime(TimeSpan.FromMilliseconds(5));
        _played.Cell.Run(1, _played.Session);

        Assert.That(before, Is.Null, "no problem is reported before a display runs");
        Assert.That(manager.subsystem, Is.SameAs(codes));
        Assert.That(_played.Markers.Problem, Is.Null);
    }

    [Test]
    public void Manager_ComponentDisabled_ObjectsOfItsCodesAreDestroyed()
    {
        _played.Report();
        _played.Cell.Frame(_played.Session);
        var code = Object.FindObjectsOfType<ARMarker>().Single();

        _played.Markers.enabled = false;
        _played.Cell.Frame(_played.Session);

        Assert.That(code == null);
    }
}
