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

/// <summary>Tests anchors on a device that creates them only asynchronously, as a Quest with AR Foundation 6.</summary>
[TestFixture("6.2")]
[TestFixture("6.3")]
public sealed class AsynchronousAnchorTests(string arFoundation)
{
    static readonly RigidTransform Place = RigidTransform.FromXyzRpy(1.5, -0.4, 0.8, 0.1, 0.2, 0.3);

    PlayedCell _cell;
    PlayedOrigin _origin;
    XRAnchorSubsystem _device;
    ArSpatialAnchors _anchors;

    [SetUp]
    public void SetUp()
    {
        _cell = new PlayedCell();
        _origin = new PlayedOrigin();
        _origin.Device.ArFoundation = Version.Parse(arFoundation);
        _device = _origin.Device.Offer<XRAnchorSubsystem>();
        _device.IsAsynchronous = true;
        _anchors = new GameObject("Anchors").AddComponent<ArSpatialAnchors>();
        Run(0.1);
    }

    [TearDown]
    public void TearDown()
    {
        _cell.Dispose();
        _origin.Dispose();
    }

    void Run(double seconds) => _cell.Run(seconds, null);

    [Test]
    public void Hold_DeviceCreatesTheAnchorLater_IsPendingUntilThen()
    {
        var anchor = _anchors.Hold(Place);
        Run(3);
        var (before, requests) = (anchor.State, _device.RequestCount);

        _device.Respond();
        Run(0.1);

        Assert.That((before, requests), Is.EqualTo((SpatialAnchorState.Pending, 1)));
        Assert.That((anchor.State, anchor.Problem), Is.EqualTo((SpatialAnchorState.Tracking, (string)null)));
        var apart = anchor.Pose.Value.Inverse * Place;
        Assert.That(Math.Abs(apart.X) + Math.Abs(apart.Y) + Math.Abs(apart.Z), Is.LessThan(1e-5));
        Assert.That(_device.Count, Is.EqualTo(1));
    }

    // A device may refuse an anchor until it has mapped the room.
    [Test]
    public void Hold_DeviceRefusesAtFirst_AsksAgain()
    {
        _device.Accepts = false;
        var anchor = _anchors.Hold(Place);
        Run(0.1);
        _device.Respond();
        var isAgain = _device.RequestCount > 0;
        Run(2);

        _device.Accepts = true;
        _device.Respond();
        Run(0.1);

        Assert.That(isAgain, Is.False);
        Assert.That(anchor.State, Is.EqualTo(SpatialAnchorState.Tracking));
    }

    [Test]
    public void Hold_RequestEndsWithAnException_FailsAfterTheTimeoutWithTheReason()
    {
        var anchor = _anchors.Hold(Place);

        for (var second = 0; second < 11; second++)
        {
            Run(1);
            _device.Respond(new OperationCanceledException("canceled"));
        }

        Assert.That((anchor.State, anchor.Problem), Is.EqualTo((SpatialAnchorState.Failed, DeviceMessages.AnchorRefused("canceled"))));
    }

    // A runtime that ends may leave the request without a response.
    [Test]
    public void Hold_NoResponse_FailsAfterTheTimeoutAndRemovesALateAnchor()
    {
        var anchor = _anchors.Hold(Place);
        Run(11);
        var (state, problem) = (anchor.State, anchor.Problem);

        _device.Respond();
        Run(0.1);

        Assert.That((state, problem), Is.EqualTo((SpatialAnchorState.Failed, DeviceMessages.AnchorNotCreated)));
        AssertNothingRemains();
    }

    [TestCase(false)]
    [TestCase(true)]
    public void Release_BeforeTheResponse_RemovesTheAnchorLater(bool isDestroyed)
    {
        var anchor = _anchors.Hold(Place);
        Run(0.1);
        if (isDestroyed) Object.Destroy(_anchors.gameObject);
        else anchor.Dispose();
        Run(0.1);

        _device.Respond();
        Run(0.1);

        Assert.That(anchor.State, Is.EqualTo(SpatialAnchorState.Failed));
        AssertNothingRemains();
    }

    // The manager lists the anchor one frame later.
    [Test]
    public void Dispose_CreatedButNotListed_RemovesTheAnchor()
    {
        var anchor = _anchors.Hold(Place);
        Run(0.1);
        _device.Respond();

        anchor.Dispose();
        Run(0.1);

        AssertNothingRemains();
    }

    void AssertNothingRemains()
    {
        Assert.That(_device.Count, Is.Zero);
        Assert.That(Object.FindObjectOfType<ARAnchor>(), Is.Null);
    }
}
