using Nowpose.Anchoring;
using Nowpose.Kinematics;
using Nowpose.Messages;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Status;
using NUnit.Framework;
using UnityEngine;
using static Nowpose.Unity.Tests.Anchoring.PlayedBaseAnchor;

namespace Nowpose.Unity.Tests.Anchoring;

/// <summary>Tests the base anchor in a running cell of the package, with a device that sees markers.</summary>
public class PlayedAnchorTests
{
    PlayedBaseAnchor _played;

    [SetUp]
    public void Begin() => _played = new PlayedBaseAnchor();

    [TearDown]
    public void End() => _played.Dispose();

    [Test]
    public void Base_NoMarkers_KeepsThePlacedPose()
    {
        _played.Markers.Markers.Clear();
        _played.Session.gameObject.SetActive(true);
        _played.Anchor.Place(new Vector3(1, 2, 3), Quaternion.identity);
        _played.Cell.Run(1, _played.Session);
        _played.Anchor.transform.position = new Vector3(3, 2, 1);

        _played.Cell.Run(1, _played.Session);

        Assert.That(_played.Anchor.transform.position, Is.EqualTo(new Vector3(3, 2, 1)));
        Assert.That(_played.Anchor.State, Is.EqualTo(BaseAnchorState.Placed));
        Assert.That(_played.Anchor.Words, Is.EqualTo(BaseStatusMessages.Placed));
        Assert.That(_played.Logged, Is.Empty);
    }

    [TestCase(true)]
    [TestCase(false)]
    public void Place_StoredPoseNotYetRestored_KeepsThePlacedPose(bool isEnabledFirst)
    {
        var device = _played.Session.gameObject.AddComponent<FakeSpatialAnchors>();
        (device.KeptAs, device.Pose) = ("cell 7", Base);
        _played.Markers.IsBlind = true;
        _played.Anchor.With("_markers", new List<AnchorMarker> { Marker }).With("_cell", "cell 7");
        _played.Session.gameObject.SetActive(isEnabledFirst);

        _played.Anchor.Place(new Vector3(1, 2, 3), Quaternion.identity);
        _played.Session.gameObject.SetActive(true);
        _played.Cell.Run(1, _played.Session);

        Assert.That(_played.Anchor.transform.position, Is.EqualTo(new Vector3(1, 2, 3)));
        Assert.That(_played.Anchor.State, Is.EqualTo(BaseAnchorState.Searching));
    }

    [Test]
    public void LockedBase_DeviceLosesOrMovesItsAnchor_IsLoggedOnceAndShown()
    {
        var device = _played.Session.gameObject.AddComponent<FakeSpatialAnchors>();
        _played.PlayLocked();
        var texts = new BaseTexts();
        Assert.That(texts.FaultOf(_played.Anchor), Is.Null);

        device.Problem = "the store is full";
        _played.Cell.Run(3, _played.Session);
        Assert.That(texts.FaultOf(_played.Anchor), Is.EqualTo("base: " + BaseStatusMessages.Locked(1) + BaseStatusMessages.Because(device.Problem)));
        Assert.That(_played.Logged.Count(message => message.EndsWith(BaseStatusMessages.Because(device.Problem))), Is.EqualTo(1));
        device.Problem = null;
        _played.Cell.Run(1, _played.Session);
        Assert.That(texts.FaultOf(_played.Anchor), Is.Null);

        device.Pose = RigidTransform.FromXyzRpy(0.012, 0, 0, 0, 0, 0) * device.Pose.Value;
        _played.Markers.IsBlind = true;
        _played.Cell.Run(3, _played.Session);
        Assert.That(texts.FaultOf(_played.Anchor), Is.EqualTo("base: " + BaseStatusMessages.Locked(1) + BaseStatusMessages.Corrected(12, "0.0")));
        Assert.That(_played.Logged.Count(message => message.Contains(BaseStatusMessages.Corrected(12, "0.0"))), Is.EqualTo(1));
    }

    [Test]
    public void Base_MarkersInView_IsLockedAtTheRobot()
    {
        _played.PlayOne();
        var states = new List<BaseAnchorState>();
        _played.Anchor.StateChanged += () => states.Add(_played.Anchor.State);

        _played.Cell.Run(2, _played.Session);

        Assert.That(_played.Anchor.State, Is.EqualTo(BaseAnchorState.Locked));
        Assert.That(_played.OffFrom(Base).Metres, Is.LessThan(0.001));
        Assert.That(_played.OffFrom(Base).Degrees, Is.LessThan(0.15));
        Assert.That(states[^1], Is.EqualTo(BaseAnchorState.Locked));
        Assert.That(_played.Logged, Is.EqualTo(
            new[] { BaseStatusMessages.Looking(isBlind: false, problem: null), BaseStatusMessages.Locked(1) }
                .Select(words => "[Nowpose] " + ComponentMessages.Of("base anchor", "Base Anchor", words))));
    }

    [Test]
    public void Relock_BaseMoved_EasesToTheNewPose()
    {
        _played.PlayLocked();
        var there = Base * RigidTransform.FromXyzRpy(0.1, 0, 0, 0, 0, 0);
        _played.Markers.Base = there;
        _played.Cell.Run(1, _played.Session);
        _played.Anchor.Relock();
        var last = _played.Anchor.transform.position;
        float fastest = 0;

        _played.Cell.Run(4, _played.Session, () =>
        {
            fastest = Mathf.Max(fastest, Vector3.Distance(last, _played.Anchor.transform.position));
            last = _played.Anchor.transform.position;
        });

        Assert.That(_played.OffFrom(there).Metres, Is.LessThan(0.001));
        Assert.That(fastest, Is.InRange(0.001f, 0.01f), "metres in a frame");
        Assert.That(_played.Anchor.Words, Does.Match($"^{BaseStatusMessages.Locked(1)}{BaseStatusMessages.MovedBy(@"(99|100)\.\d", @"0\.\d\d")}$"));
    }

    [Test]
    public void Nudge_DuringTheTransition_MovesFromTheNewPose()
    {
        _played.PlayLocked();
        var there = Base * RigidTransform.FromXyzRpy(0.1, 0, 0, 0, 0, 0);
        _played.Markers.Base = there;
        _played.Anchor.Relock();
        while (_played.Anchor.State != BaseAnchorState.Locked) _played.Cell.Run(0.1, _played.Session);
        Assert.That(_played.OffFrom(there).Metres, Is.GreaterThan(0.01), "the transition is not complete");

        _played.Anchor.Nudge(new Vector3(0.003f, 0, 0), 0);
        _played.Cell.Run(2, _played.Session);

        var pose = UnityPoses.ToWorld(there);
        var nudged = UnityPoses.ToRoom(pose.position + pose.rotation * new Vector3(0.003f, 0, 0), pose.rotation);
        Assert.That(_played.OffFrom(nudged).Metres, Is.LessThan(0.001));
        Assert.That(_played.Anchor.Tracker.Base.Value.DistanceTo(nudged), Is.LessThan(0.001));
    }

    [Test]
    public void Place_Locked_MovesImmediatelyAndStays()
    {
        _played.PlayLocked();

        _played.Anchor.Place(new Vector3(1, 2, 3), Quaternion.identity);
        _played.Cell.Run(3, _played.Session);

        Assert.That(_played.Anchor.transform.position, Is.EqualTo(new Vector3(1, 2, 3)));
        Assert.That(_played.Anchor.State, Is.EqualTo(BaseAnchorState.Placed));
    }

    [Test]
    public void Base_DeviceHoldsAnchors_IsAnchoredAndFollowsTheDevice()
    {
        var device = new GameObject("Anchors").AddComponent<FakeSpatialAnchors>();
        device.transform.SetParent(_played.Session.transform);
        _played.PlayLocked();
        Assert.That(device.KeptAs, Is.EqualTo("cell 7"));
        var there = RigidTransform.FromXyzRpy(0, 0.02, 0, 0, 0, 0) * device.Pose.Value;
        _played.Markers.Base = there;

        device.Pose = there;
        _played.Cell.Run(2, _played.Session);

        Assert.That(_played.OffFrom(there).Metres, Is.LessThan(1e-4));
        Assert.That(_played.Anchor.State, Is.EqualTo(BaseAnchorState.Locked));
        device.State = SpatialAnchorState.Lost;
        _played.Cell.Run(0.1, _played.Session);
        Assert.That(_played.Anchor.State, Is.EqualTo(BaseAnchorState.Lost));
        Assert.That(_played.Look().Words, Is.EqualTo(BaseMessages.LostLabel));
    }

    [Test]
    public void Base_SavedOnTheDevice_IsRestoredUntilAMarkerConfirmsIt()
    {
        var device = _played.Session.gameObject.AddComponent<FakeSpatialAnchors>();
        (device.KeptAs, device.Pose) = ("cell 7", Base);
        _played.Markers.IsBlind = true;
        _played.PlayOne();

        _played.Cell.Run(5, _played.Session);

        Assert.That(_played.Anchor.State, Is.EqualTo(BaseAnchorState.Restored));
        Assert.That(_played.OffFrom(Base).Metres, Is.LessThan(1e-6));
        Assert.That(_played.Look(), Is.EqualTo((0.2f, 1f, BaseMessages.NotConfirmedLabel)));
        _played.Markers.IsBlind = false;
        _played.Cell.Run(3, _played.Session);
        Assert.That(_played.Anchor.State, Is.EqualTo(BaseAnchorState.Locked));
    }

    [Test]
    public void HandPlacedMarker_Moved_BaseFollowsAndLocksOnRelease()
    {
        _played.Markers.Markers.Clear();
        var hand = new GameObject("Hand").AddComponent<HandPlacedMarker>();
        hand.transform.SetParent(_played.Session.transform);
        _played.Session.gameObject.SetActive(true);
        _played.Cell.Run(5, _played.Session);
        Assert.That(_played.Anchor.State, Is.EqualTo(BaseAnchorState.Placed), "the object has not been moved");

        hand.BeginMove();
        hand.transform.SetPositionAndRotation(new Vector3(0.4f, 1, 2), Quaternion.Euler(0, 30, 0));
        _played.Cell.Run(0.1, _played.Session);
        Assert.That(_played.Anchor.transform.position, Is.EqualTo(new Vector3(0.4f, 1, 2)).Using<Vector3>((a, b) => Vector3.Distance(a, b) < 1e-5));
        Assert.That(_played.Look(), Is.EqualTo((0.2f, 1f, BaseMessages.BeingPlacedLabel)));
        hand.EndMove();
        _played.Cell.Run(0.1, _played.Session);

        Assert.That(_played.Anchor.State, Is.EqualTo(BaseAnchorState.Locked));
        Assert.That(Quaternion.Angle(_played.Anchor.transform.rotation, Quaternion.Euler(0, 30, 0)), Is.LessThan(0.01));
        Assert.That(_played.Look(), Is.EqualTo((0f, 0f, "")));
    }

    [Test]
    public void HandPlacedMarker_BelowTheBase_HasNoEffectAndIsLoggedOnce()
    {
        _played.Session.gameObject.SetActive(true);
        var hand = PlayedRig.Below<HandPlacedMarker>("Hand", _played.Anchor.transform);
        hand.transform.localPosition = new Vector3(0.5f, 0, 0);
        var before = _played.Anchor.transform.position;
        _played.Cell.Run(1.1, _played.Session);

        for (var i = 0; i < 3; i++)
        {
            hand.BeginMove();
            _played.Cell.Run(0.1, _played.Session);
        }

        Assert.That((hand.IsMoving, _played.Anchor.transform.position), Is.EqualTo((false, before)));
        var error = ComponentMessages.MarkerBelowBase("Hand");
        Assert.That(_played.Cell.Player.Logs.Count(log => log.Type == LogType.Error && log.Message.EndsWith(error)), Is.EqualTo(1));
    }

    [Test]
    public void HandPlacedMarker_NotHeld_IsAtThePoseOfItsMarker()
    {
        var hand = new GameObject("Hand").AddComponent<HandPlacedMarker>().With("_payload", "a");
        hand.transform.SetParent(_played.Session.transform);

        _played.PlayLocked();

        var expected = UnityPoses.ToWorld(Base * InBase);
        Assert.That(Vector3.Distance(hand.transform.position, expected.position), Is.LessThan(0.001));
        hand.BeginMove();
        _played.Cell.Run(0.1, _played.Session);
        hand.EndMove();
        _played.Cell.Run(0.1, _played.Session);
        Assert.That(_played.OffFrom(Base).Metres, Is.LessThan(0.001), "the base was not moved");
        Assert.That(_played.Anchor.Tracker.Lock.Markers, Is.EqualTo(0), "by hand");
    }

    [Test]
    public void MarkerSource_AddedOrRemoved_IsUsedOrReleased()
    {
        UnityEngine.Object.DestroyImmediate(_played.Markers);
        _played.PlayOne();
        _played.Cell.Run(2, _played.Session);
        var late = new GameObject("Late").AddComponent<FakeMarkers>();
        late.transform.SetParent(_played.Session.transform);
        (late.Clock, late.Base) = (_played.Cell.Clock, Base);
        late.Markers["a"] = InBase;

        _played.Cell.Run(3.2, _played.Session);
        Assert.That(_played.Anchor.State, Is.EqualTo(BaseAnchorState.Locked));
        UnityEngine.Object.Destroy(late.gameObject);
        _played.Cell.Run(2, _played.Session);

        Assert.That(_played.Anchor.State, Is.EqualTo(BaseAnchorState.Locked));
        Assert.That(_played.Cell.Player.Logs.Where(log => log.Type == LogType.Exception), Is.Empty);
    }

    [Test]
    public void Frame_LockedWithMarkersInView_AllocatesNothing([Values] bool isMoved)
    {
        _played.Session.gameObject.AddComponent<FakeSpatialAnchors>();
        _played.PlayLocked();
        if (isMoved) _played.Markers.Markers["a"] = InBase * RigidTransform.FromXyzRpy(0, 0, 0.05, 0, 0, 0);
        _played.Cell.Run(25, _played.Session);

        var allocated = _played.Cell.AllocatedIn(() => _played.Cell.Run(10, _played.Session));

        Assert.That(_played.Anchor.State, Is.EqualTo(isMoved ? BaseAnchorState.Moved : BaseAnchorState.Locked));
        Assert.That(allocated, isMoved ? Is.LessThan(5000) : Is.EqualTo(0), "bytes in 10 s; a message with another number allocates some");
    }
}
