using Nowpose.Anchoring;
using Nowpose.Kinematics;
using Nowpose.Unity;
using Nowpose.Unity.Anchoring;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Status;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Anchoring;

/// <summary>Tests a session with several robots, each of which has its own base anchor.</summary>
public class SeveralBasesTests
{
    PlayedBaseAnchor _played;

    [SetUp]
    public void Begin() => _played = new PlayedBaseAnchor();

    [TearDown]
    public void End() => _played.Dispose();

    // Otherwise two robots would be displayed at the same place.
    [TestCase(true)]
    [TestCase(false)]
    public void HandPlacedMarker_WithoutPayload_PlacesOneBase(bool isAssigned)
    {
        var other = PlayedRig.Below<BaseAnchor>("Other base", _played.Session.transform);
        other.transform.position = new Vector3(3, 0, 0);
        var hand = PlayedRig.Below<HandPlacedMarker>("Hand", _played.Session.transform).With("_anchor", isAssigned ? other : null);
        _played.Play();
        _played.Cell.Run(1.1, _played.Session);
        var before = _played.Anchor.transform.position;

        hand.BeginMove();
        hand.transform.position = new Vector3(1, 0, 1);
        _played.Cell.Run(1, _played.Session);
        hand.EndMove();
        _played.Cell.Run(1, _played.Session);

        var (placed, still) = isAssigned ? (other, _played.Anchor) : (_played.Anchor, other);
        Assert.That((placed.State, still.State), Is.EqualTo((BaseAnchorState.Locked, BaseAnchorState.Placed)));
        Assert.That(Vector3.Distance(placed.transform.position, new Vector3(1, 0, 1)), Is.LessThan(1e-3));
        Assert.That(hand.transform.position, Is.EqualTo(placed.transform.position));
        Assert.That(still.transform.position, Is.EqualTo(isAssigned ? before : new Vector3(3, 0, 0)));
    }

    [Test]
    public void Panel_SecondBaseNotLocked_ReportsItAndLocksBothAgain()
    {
        var other = PlayedRig.Below<BaseAnchor>("Other base", _played.Session.transform)
            .With("_markers", new List<AnchorMarker> { new("b", Vector3.zero, Vector3.zero) });
        var actions = _played.Session.gameObject.AddComponent<CellActions>();
        _played.PlayLocked();
        Assert.That(new SessionBases().WorstOf(_played.Session), Is.SameAs(other));
        var panel = _played.Session.GetComponentInChildren<StatusPanel>();
        Assert.That(panel.Texts.ValueOf(StatusRow.Base), Is.EqualTo(StatusMessages.Of(BaseAnchorState.Searching)));
        _played.Markers.Markers["b"] = RigidTransform.Identity;
        _played.Cell.Run(4, _played.Session);
        Assert.That((other.State, new SessionBases().WorstOf(_played.Session).State), Is.EqualTo((BaseAnchorState.Locked, BaseAnchorState.Locked)));

        actions.LockBase();

        Assert.That((_played.Anchor.State, other.State), Is.EqualTo((BaseAnchorState.Searching, BaseAnchorState.Searching)));
    }

    // Another base must not take over a place that was set for one that has gone.
    [Test]
    public void HandPlacedMarker_ItsBaseIsDestroyed_DoesNotPlaceAnother()
    {
        var other = PlayedRig.Below<BaseAnchor>("Other base", _played.Session.transform);
        other.transform.position = new Vector3(3, 0, 0);
        var hand = PlayedRig.Below<HandPlacedMarker>("Hand", _played.Session.transform);
        _played.Play();
        _played.Cell.Run(1.1, _played.Session);
        hand.BeginMove();
        _played.Cell.Run(0.1, _played.Session);
        hand.EndMove();

        UnityEngine.Object.DestroyImmediate(_played.Anchor);
        _played.Cell.Run(2, _played.Session);

        Assert.That((other.State, other.transform.position), Is.EqualTo((BaseAnchorState.Placed, new Vector3(3, 0, 0))));
    }

    [Test]
    public void UseFields_LockedBaseOfTheSameName_ReturnsToItsFormerPose()
    {
        _played.Play();
        _played.Cell.Run(1.1, _played.Session);
        var before = _played.Anchor.transform.position;
        _played.Anchor.Use("cell 7", new[] { new BaseMarker("a", PlayedBaseAnchor.InBase, 0) });
        _played.Cell.Run(4, _played.Session);
        Assert.That(_played.Anchor.State, Is.EqualTo(BaseAnchorState.Locked));

        _played.Anchor.UseFields();
        _played.Cell.Run(1, _played.Session);

        Assert.That((_played.Anchor.State, _played.Anchor.transform.position), Is.EqualTo((BaseAnchorState.Placed, before)));
    }

    [Test]
    public void LockBase_ListenerOfTheFirstBaseThrows_SearchesForAllBases()
    {
        var other = PlayedRig.Below<BaseAnchor>("Other base", _played.Session.transform)
            .With("_markers", new List<AnchorMarker> { new("b", Vector3.zero, Vector3.zero) });
        _played.Markers.Markers["b"] = RigidTransform.Identity;
        var actions = _played.Session.gameObject.AddComponent<CellActions>();
        _played.PlayLocked();
        Assert.That(other.State, Is.EqualTo(BaseAnchorState.Locked));
        _played.Anchor.StateChanged += () => throw new InvalidOperationException("thrown by the listener");

        actions.LockBase();

        Assert.That((_played.Anchor.State, other.State), Is.EqualTo((BaseAnchorState.Searching, BaseAnchorState.Searching)));
    }

    [Test]
    public void Place_ListenerThrows_OtherListenersAreCalled()
    {
        _played.Play();
        var moved = 0;
        _played.Anchor.Moved += () => throw new InvalidOperationException("thrown by the listener");
        _played.Anchor.Moved += () => moved++;

        _played.Anchor.Place(Vector3.one, Quaternion.identity);

        Assert.That(moved, Is.EqualTo(1));
    }

    [Test]
    public void LockBase_BaseAssigned_SearchesForThatBaseOnly()
    {
        var other = PlayedRig.Below<BaseAnchor>("Other base", _played.Session.transform)
            .With("_markers", new List<AnchorMarker> { new("b", Vector3.zero, Vector3.zero) });
        _played.Markers.Markers["b"] = RigidTransform.Identity;
        var actions = _played.Session.gameObject.AddComponent<CellActions>().With("_anchor", other);
        _played.PlayLocked();

        actions.LockBase();

        Assert.That((_played.Anchor.State, other.State), Is.EqualTo((BaseAnchorState.Locked, BaseAnchorState.Searching)));
    }
}
