using Microsoft.MixedReality.OpenXR;
using Nowpose.Anchoring;
using Nowpose.Unity;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.XR.ARSubsystems;
using static Nowpose.Unity.Tests.Devices.PlayedAnchorStore;

namespace Nowpose.Unity.Tests.Devices;

/// <summary>Tests that anchors are saved in the store, found again, and deleted.</summary>
public sealed class OpenXrAnchorStoreTests
{
    PlayedAnchorStore _played;

    [SetUp]
    public void SetUp() => _played = new PlayedAnchorStore();

    [TearDown]
    public void TearDown() => _played.Dispose();

    [Test]
    public void IsReady_SlowStore_IsTrueOnceLoaded()
    {
        var loading = new TaskCompletionSource<XRAnchorStore>();
        XRAnchorStore.Loading = _ => loading.Task;
        _played.Run(3);
        var before = _played.Anchors.IsReady;

        loading.SetResult(_played.Storage);
        _played.Run(0.1);

        Assert.That(before, Is.False);
        Assert.That(_played.Anchors.IsReady);
        Assert.That(_played.Anchors.Problem, Is.Null);
    }

    [Test]
    public void Keep_HeldAnchor_IsStoredUnderTheUnchangedName()
    {
        _played.Run(0.1);

        var anchor = _played.Kept("Halle 3 / Zelle Ü");

        Assert.That(anchor.KeptAs, Is.EqualTo("Halle 3 / Zelle Ü"));
        Assert.That(anchor.Problem, Is.Null);
        Assert.That(_played.Storage.KeptAs("Halle 3 / Zelle Ü"), Is.Not.EqualTo(TrackableId.invalidId));
    }

    [Test]
    public void Keep_BeforeTheStoreIsLoaded_IsStoredOnceLoaded()
    {
        var loading = new TaskCompletionSource<XRAnchorStore>();
        XRAnchorStore.Loading = _ => loading.Task;
        var anchor = _played.Kept("cell");
        var before = anchor.KeptAs;

        loading.SetResult(_played.Storage);
        _played.Run(0.2);

        Assert.That(before, Is.Null);
        Assert.That(anchor.KeptAs, Is.EqualTo("cell"));
    }

    [Test]
    public void Keep_ExistingName_ReplacesTheStoredAnchor()
    {
        _played.Run(0.1);
        var first = _played.Kept("cell");
        var id = _played.Storage.KeptAs("cell");

        var second = _played.Kept("cell");

        Assert.That(_played.Storage.KeptAs("cell"), Is.Not.EqualTo(id));
        Assert.That(first.KeptAs, Is.Null);
        Assert.That(first.State, Is.EqualTo(SpatialAnchorState.Tracking), "still held");
        Assert.That(second.KeptAs, Is.EqualTo("cell"));
        Assert.That(_played.Storage.PersistedAnchorNames, Is.EqualTo(new[] { "cell" }));
    }

    [Test]
    public void Keep_ExistingNameAndStoreRefuses_KeepsTheEarlierAnchor()
    {
        _played.Run(0.1);
        _played.Kept("cell");
        var id = _played.Storage.KeptAs("cell");
        _played.Storage.Accepts = false;

        var second = _played.Kept("cell");

        Assert.That(second.KeptAs, Is.Null);
        Assert.That(_played.Storage.KeptAs("cell"), Is.EqualTo(id));
        Assert.That(_played.Storage.PersistedAnchorNames, Is.EqualTo(new[] { "cell" }));
    }

    [Test]
    public void Keep_StoreRefusesTheNameAfterItsRemoval_KeepsTheNewAnchorUnderTheSpareName()
    {
        _played.Run(0.1);
        _played.Kept("cell");
        _played.Storage.RefusedName = "cell";

        var second = _played.Kept("cell");
        var kept = _played.Storage.PersistedAnchorNames.ToArray();
        var found = _played.Anchors.Find("cell");

        Assert.That(second.KeptAs, Is.EqualTo("cell"));
        Assert.That(kept, Is.EqualTo(new[] { "cell (new)" }));
        Assert.That(found, Is.Not.Null);
    }

    [Test]
    public void Find_AnchorOfAnEarlierRun_IsPendingThenAtTheDevicesPose()
    {
        _played.Storage.Put("cell", Earlier);
        _played.Run(0.1);

        var anchor = _played.Anchors.Find("cell");
        _played.Run(20);
        var (waiting, pose) = (anchor.State, anchor.Pose);
        var world = UnityPoses.ToWorld(Place);
        _played.Device.Place(Earlier, _played.Origin.InSession(world.position, world.rotation), TrackingState.Tracking);
        _played.Run(0.1);

        Assert.That(waiting, Is.EqualTo(SpatialAnchorState.Pending), "the headset may be in another room");
        Assert.That(pose, Is.Null);
        Assert.That(anchor.KeptAs, Is.EqualTo("cell"));
        Assert.That(anchor.State, Is.EqualTo(SpatialAnchorState.Tracking));
        Assert.That((anchor.Pose.Value.Inverse * Place).X, Is.EqualTo(0).Within(1e-5));
    }

    [Test]
    public void Find_DeviceNotLocalisedYet_IsLost()
    {
        _played.Storage.Put("cell", Earlier);
        _played.Run(0.1);
        var anchor = _played.Anchors.Find("cell");

        _played.Device.Place(Earlier, new Pose(Vector3.zero, Quaternion.identity), TrackingState.None);
        _played.Run(0.1);

        Assert.That(anchor.State, Is.EqualTo(SpatialAnchorState.Lost));
        Assert.That(anchor.Pose, Is.Null);
    }

    [Test]
    public void Find_NothingStoredOrStoreNotLoaded_ReturnsNull()
    {
        _played.Storage.Put("other", Earlier);

        Assert.That(_played.Anchors.Find("other"), Is.Null, "not known yet");
        _played.Run(0.1);

        Assert.That(_played.Anchors.Find("cell"), Is.Null);
        Assert.That(_played.Anchors.Find(null), Is.Null);
        Assert.That(_played.Anchors.Find("other"), Is.Not.Null);
    }

    [Test]
    public void Find_SameAnchorTwice_SecondStaysValidAfterTheFirstIsReleased()
    {
        _played.Storage.Put("cell", Earlier);
        _played.Run(0.1);
        var first = _played.Anchors.Find("cell");
        var second = _played.Anchors.Find("cell");
        _played.Device.Place(Earlier, new Pose(Vector3.forward, Quaternion.identity), TrackingState.Tracking);
        _played.Run(0.1);

        first.Dispose();
        _played.Run(0.1);

        Assert.That(second.State, Is.EqualTo(SpatialAnchorState.Tracking));
        Assert.That(_played.Device.Count, Is.EqualTo(1));
        Assert.That(_played.Storage.PersistedAnchorNames, Does.Contain("cell"), "releasing an anchor does not delete the stored one");
    }

    [Test]
    public void Forget_StoredAnchor_IsRemovedFromTheStoreButStaysHeld()
    {
        _played.Run(0.1);
        var anchor = _played.Kept("cell");

        _played.Anchors.Forget("cell");
        _played.Anchors.Forget("never kept");

        Assert.That(_played.Storage.PersistedAnchorNames, Is.Empty);
        Assert.That(anchor.KeptAs, Is.Null);
        Assert.That(anchor.State, Is.EqualTo(SpatialAnchorState.Tracking));
    }

    [Test]
    public void Forget_BeforeTheStoreIsLoaded_IsRemovedOnceLoaded()
    {
        _played.Storage.Put("cell", Earlier);

        _played.Anchors.Forget("cell");
        _played.Run(0.2);

        Assert.That(_played.Anchors.IsReady);
        Assert.That(_played.Storage.PersistedAnchorNames, Is.Empty);
    }
}
