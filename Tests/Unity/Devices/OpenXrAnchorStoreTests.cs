using Microsoft.MixedReality.OpenXR;
using Nowpose.Anchoring;
using Nowpose.ArFoundation;
using Nowpose.Kinematics;
using Nowpose.OpenXR;
using Nowpose.Unity;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.XR.ARSubsystems;
using Object = UnityEngine.Object;

namespace Nowpose.Unity.Tests.Devices;

public sealed class OpenXrAnchorStoreTests
{
    static readonly RigidTransform Place = RigidTransform.FromXyzRpy(1.5, -0.4, 0.8, 0.1, 0.2, 0.3);
    static readonly TrackableId Earlier = new(7, 7);

    PlayedCell _cell;
    PlayedOrigin _origin;
    XRAnchorSubsystem _device;
    XRAnchorStore _kept;
    OpenXrAnchorStore _store;
    ArSpatialAnchors _anchors;

    [SetUp]
    public void SetUp()
    {
        _cell = new PlayedCell();
        _origin = new PlayedOrigin();
        _device = _origin.Device.Offer<XRAnchorSubsystem>();
        _kept = new XRAnchorStore();
        XRAnchorStore.Loading = _ => Task.FromResult(_kept);
        // The store adds the anchors component.
        _store = new GameObject("Anchors").AddComponent<OpenXrAnchorStore>();
        _anchors = _store.GetComponent<ArSpatialAnchors>();
    }

    [TearDown]
    public void TearDown()
    {
        _cell.Dispose();
        _origin.Dispose();
        XRAnchorStore.Loading = _ => Task.FromResult<XRAnchorStore>(null);
    }

    void Run(double seconds) => _cell.Run(seconds, null);

    ISpatialAnchor Kept(string name)
    {
        var anchor = _anchors.Hold(Place);
        anchor.Keep(name);
        Run(0.2);
        return anchor;
    }

    [Test]
    public void IsReady_SlowStore_IsTrueOnceLoaded()
    {
        var loading = new TaskCompletionSource<XRAnchorStore>();
        XRAnchorStore.Loading = _ => loading.Task;
        Run(3);
        var before = _anchors.IsReady;

        loading.SetResult(_kept);
        Run(0.1);

        Assert.That(before, Is.False);
        Assert.That(_anchors.IsReady);
        Assert.That(_anchors.Problem, Is.Null);
    }

    [Test]
    public void Keep_HeldAnchor_IsStoredUnderTheUnchangedName()
    {
        Run(0.1);

        var anchor = Kept("Halle 3 / Zelle Ü");

        Assert.That(anchor.KeptAs, Is.EqualTo("Halle 3 / Zelle Ü"));
        Assert.That(anchor.Problem, Is.Null);
        Assert.That(_kept.KeptAs("Halle 3 / Zelle Ü"), Is.Not.EqualTo(TrackableId.invalidId));
    }

    [Test]
    public void Keep_BeforeTheStoreIsLoaded_IsStoredOnceLoaded()
    {
        var loading = new TaskCompletionSource<XRAnchorStore>();
        XRAnchorStore.Loading = _ => loading.Task;
        var anchor = Kept("cell");
        var before = anchor.KeptAs;

        loading.SetResult(_kept);
        Run(0.2);

        Assert.That(before, Is.Null);
        Assert.That(anchor.KeptAs, Is.EqualTo("cell"));
    }

    [Test]
    public void Keep_ExistingName_ReplacesTheStoredAnchor()
    {
        Run(0.1);
        var first = Kept("cell");
        var id = _kept.KeptAs("cell");

        var second = Kept("cell");

        Assert.That(_kept.KeptAs("cell"), Is.Not.EqualTo(id));
        Assert.That(first.KeptAs, Is.Null);
        Assert.That(first.State, Is.EqualTo(SpatialAnchorState.Tracking), "still held");
        Assert.That(second.KeptAs, Is.EqualTo("cell"));
    }

    [Test]
    public void Keep_StoreRefusesAtFirst_IsRetried()
    {
        Run(0.1);
        _kept.Accepts = false;
        var anchor = Kept("cell");
        var meanwhile = anchor.Problem;

        _kept.Accepts = true;
        Run(1.1);

        Assert.That(meanwhile, Does.Contain("has not stored it yet"));
        Assert.That(anchor.KeptAs, Is.EqualTo("cell"));
        Assert.That(anchor.Problem, Is.Null);
    }

    [Test]
    public void Keep_StoreAlwaysRefuses_ReportsItAndStaysHeld()
    {
        Run(0.1);
        _kept.Accepts = false;

        var anchor = Kept("cell");
        Run(15);

        Assert.That(anchor.Problem, Is.EqualTo("the device could not store it as 'cell'; it is lost at the next start"));
        Assert.That(anchor.State, Is.EqualTo(SpatialAnchorState.Tracking));
    }

    [TestCase("", "without a name")]
    [TestCase("  ", "without a name")]
    [TestCase(null, "without a name")]
    [TestCase("129", "has 129 characters; the maximum is 128")]
    public void Keep_InvalidName_IsReported(string name, string expected)
    {
        Run(0.1);

        var anchor = Kept(name == "129" ? new string('x', 129) : name);

        Assert.That(anchor.Problem, Does.Contain(expected));
        Assert.That(_kept.PersistedAnchorNames, Is.Empty);
    }

    [Test]
    public void Find_AnchorOfAnEarlierRun_IsPendingThenAtTheDevicesPose()
    {
        _kept.Put("cell", Earlier);
        Run(0.1);

        var anchor = _anchors.Find("cell");
        Run(20);
        var (waiting, pose) = (anchor.State, anchor.Pose);
        var world = UnityPoses.ToWorld(Place);
        _device.Place(Earlier, _origin.InSession(world.position, world.rotation), TrackingState.Tracking);
        Run(0.1);

        Assert.That(waiting, Is.EqualTo(SpatialAnchorState.Pending), "it may be another room");
        Assert.That(pose, Is.Null);
        Assert.That(anchor.KeptAs, Is.EqualTo("cell"));
        Assert.That(anchor.State, Is.EqualTo(SpatialAnchorState.Tracking));
        Assert.That((anchor.Pose.Value.Inverse * Place).X, Is.EqualTo(0).Within(1e-5));
    }

    [Test]
    public void Find_DeviceNotLocalisedYet_IsLost()
    {
        _kept.Put("cell", Earlier);
        Run(0.1);
        var anchor = _anchors.Find("cell");

        _device.Place(Earlier, new Pose(Vector3.zero, Quaternion.identity), TrackingState.None);
        Run(0.1);

        Assert.That(anchor.State, Is.EqualTo(SpatialAnchorState.Lost));
        Assert.That(anchor.Pose, Is.Null);
    }

    [Test]
    public void Find_NothingStoredOrNotLoaded_IsNull()
    {
        _kept.Put("other", Earlier);

        Assert.That(_anchors.Find("other"), Is.Null, "not known yet");
        Run(0.1);

        Assert.That(_anchors.Find("cell"), Is.Null);
        Assert.That(_anchors.Find(null), Is.Null);
        Assert.That(_anchors.Find("other"), Is.Not.Null);
    }

    [Test]
    public void Find_SameAnchorTwice_StaysValidAfterTheFirstIsReleased()
    {
        _kept.Put("cell", Earlier);
        Run(0.1);
        var first = _anchors.Find("cell");
        var second = _anchors.Find("cell");
        _device.Place(Earlier, new Pose(Vector3.forward, Quaternion.identity), TrackingState.Tracking);
        Run(0.1);

        first.Dispose();
        Run(0.1);

        Assert.That(second.State, Is.EqualTo(SpatialAnchorState.Tracking));
        Assert.That(_device.Count, Is.EqualTo(1));
        Assert.That(_kept.PersistedAnchorNames, Does.Contain("cell"), "letting go forgets nothing");
    }

    [Test]
    public void Forget_StoredAnchor_IsRemovedFromTheStoreAndStaysHeld()
    {
        Run(0.1);
        var anchor = Kept("cell");

        _anchors.Forget("cell");
        _anchors.Forget("never kept");

        Assert.That(_kept.PersistedAnchorNames, Is.Empty);
        Assert.That(anchor.KeptAs, Is.Null);
        Assert.That(anchor.State, Is.EqualTo(SpatialAnchorState.Tracking));
    }

    [Test]
    public void Forget_BeforeTheStoreIsLoaded_IsRemovedOnceLoaded()
    {
        _kept.Put("cell", Earlier);

        _anchors.Forget("cell");
        Run(0.2);

        Assert.That(_anchors.IsReady);
        Assert.That(_kept.PersistedAnchorNames, Is.Empty);
    }

    [Test]
    public void Problem_RuntimeWithoutAStore_IsLoggedOnceAndRetried()
    {
        XRAnchorStore.Loading = _ => Task.FromResult<XRAnchorStore>(null);
        Run(10);
        var problem = _anchors.Problem;

        XRAnchorStore.Loading = _ => Task.FromResult(_kept);
        Run(2);

        Assert.That(problem, Is.EqualTo("the runtime has no anchor store; anchors are lost at the next start"));
        Assert.That(_cell.Messages.Count(m => m.Contains("anchor store 'Anchors'")), Is.EqualTo(1));
        Assert.That(_anchors.IsReady);
        Assert.That(_anchors.Problem, Is.Null);
    }

    [TestCase(false)]
    [TestCase(true)]
    public void Problem_LoadingFails_IsReportedWithoutException(bool isAtOnce)
    {
        XRAnchorStore.Loading = _ => isAtOnce
            ? throw new DllNotFoundException("no such library")
            : Task.FromException<XRAnchorStore>(new DllNotFoundException("no such library"));

        Run(3);

        Assert.That(_anchors.Problem, Is.EqualTo("cannot load what was kept: no such library"));
        Assert.That(_cell.Messages.Count(m => m.Contains("no such library")), Is.EqualTo(1));
        Assert.That(_cell.Player.Logs.Where(log => log.Type == LogType.Exception), Is.Empty);
        Assert.That(_anchors.Find("cell"), Is.Null);
    }

    [Test]
    public void Problem_StoreThrows_IsReportedWithoutException()
    {
        Run(0.1);
        _kept.Fault = new InvalidOperationException("the store is gone");

        var anchor = Kept("cell");
        var found = _anchors.Find("cell");
        _anchors.Forget("cell");

        Assert.That(found, Is.Null);
        Assert.That(anchor.KeptAs, Is.Null);
        Assert.That(_anchors.Problem, Does.Contain("the store is gone"));
        Assert.That(_cell.Player.Logs.Where(log => log.Type == LogType.Exception), Is.Empty);
    }

    [Test]
    public void Update_DestroyedWhileLoading_DoesNotThrow()
    {
        var loading = new TaskCompletionSource<XRAnchorStore>();
        XRAnchorStore.Loading = _ => loading.Task;
        Run(0.1);

        Object.Destroy(_store);
        Run(0.1);
        loading.SetException(new InvalidOperationException("too late"));
        Run(0.1);

        Assert.That(_anchors.IsReady, Is.False);
        Assert.That(_cell.Player.Logs.Where(log => log.Type == LogType.Exception), Is.Empty);
    }
}
