using Nowpose.Anchoring;
using Nowpose.Samples;
using Nowpose.Unity;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.InputSystem;

namespace Nowpose.Unity.Tests.Samples;

/// <summary>Tests how the sample's controller moves the base of the robot.</summary>
public sealed class CarriedMarkerTests : AnyOpenXrHeadsetFixture
{
    const string Hand = "<XRController>{RightHand}/device", Grip = "<XRController>{RightHand}/{GripButton}";
    const string Tracked = "<XRController>{RightHand}/isTracked";

    static void MoveHand(Vector3 position, Quaternion rotation)
    {
        Controls.Set(Hand + "Position", position);
        Controls.Set(Hand + "Rotation", rotation);
        Controls.Set(Tracked, true);
    }

    void PlaceBase(Vector3 hand)
    {
        MoveHand(hand, Quaternion.identity);
        Run(0.1);
        Press(Grip);
    }

    [Test]
    public void Grip_Held_CarriesTheMarkerWithTheHand()
    {
        var before = Marker.transform.position;
        MoveHand(new Vector3(0.3f, 1, 0.5f), Quaternion.identity);
        Controls.Set(Grip, true);
        Run(0.1);
        Assert.That(Marker.IsMoving);
        Assert.That((Marker.transform.position - before).magnitude, Is.LessThan(1e-5f), "the marker does not jump when it is grasped");

        // Turns the hand by 90° to the right, and raises it by 10 cm.
        MoveHand(new Vector3(0.3f, 1.1f, 0.5f), Quaternion.Euler(0, 90, 0));
        Run(0.1);
        Controls.Set(Grip, false);
        Run(0.1);

        var arm = before - new Vector3(0.3f, 1, 0.5f);
        var expected = new Vector3(0.3f, 1.1f, 0.5f) + new Vector3(arm.z, arm.y, -arm.x);
        Assert.That((Marker.transform.position - expected).magnitude, Is.LessThan(1e-4f));
        Assert.That(Quaternion.Angle(Marker.transform.rotation, Quaternion.Euler(0, 90, 0)), Is.LessThan(0.1f));
        Assert.That(Marker.IsMoving, Is.False);
        var placed = _session.GetComponentInChildren<BaseAnchor>();
        Assert.That((placed.transform.position - expected).magnitude, Is.LessThan(1e-4f), "the robot's base is where the marker was put");
        Assert.That(Quaternion.Angle(placed.transform.rotation, Quaternion.Euler(0, 90, 0)), Is.LessThan(0.1f));
        Assert.That(placed.State, Is.EqualTo(BaseAnchorState.Locked));
    }

    [Test]
    public void Grip_HeldByAnUntrackedHand_DoesNotMoveTheMarker()
    {
        var before = Marker.transform.position;
        Controls.Set(Grip, true);

        Run(0.2);

        Assert.That(Marker.transform.position, Is.EqualTo(before));
        Assert.That(Marker.IsMoving, Is.False);
    }

    // A headset estimates the pose of a controller that it does not see, or reports the origin.
    [Test]
    public void Hand_LosesTrackingWhileCarrying_TheMarkerWaitsForIt()
    {
        MoveHand(new Vector3(0.3f, 1, 0.5f), Quaternion.identity);
        Controls.Set(Grip, true);
        Run(0.1);
        var before = Marker.transform.position;

        MoveHand(Vector3.zero, Quaternion.identity);
        Controls.Set(Tracked, false);
        Run(0.1);
        Assert.That(Marker.transform.position, Is.EqualTo(before));

        MoveHand(new Vector3(0.3f, 1.1f, 0.5f), Quaternion.identity);
        Run(0.1);
        Assert.That((Marker.transform.position - before - 0.1f * Vector3.up).magnitude, Is.LessThan(1e-5f));
    }

    // The middle finger rests on the grip button.
    [TestCase(0.6f, 0)]
    [TestCase(0.4f, 0.1f)]
    public void Grip_HeldNearALockedBase_MovesItOnlyWithinReach(float metres, float expected)
    {
        PlaceBase(new Vector3(0.3f, 1, 0.5f));
        var before = Marker.transform.position;
        var hand = before + metres * Vector3.back;
        MoveHand(hand, Quaternion.identity);
        Controls.Set(Grip, true);
        Run(0.1);

        MoveHand(hand + 0.1f * Vector3.up, Quaternion.identity);
        Run(0.1);

        Assert.That(Marker.transform.position.y - before.y, Is.EqualTo(expected).Within(1e-5));
    }

    [Test]
    public void Hand_ComesNearALockedBaseWithTheGripHeld_DoesNotMoveIt()
    {
        PlaceBase(new Vector3(0.3f, 1, 0.5f));
        var before = Marker.transform.position;
        Controls.Set(Grip, true);
        Run(0.1);

        MoveHand(before, Quaternion.identity);
        Run(0.1);

        Assert.That(Marker.IsMoving, Is.False);
    }

    [Test]
    public void App_PausedAfterTheBaseWasPlaced_StickConfirmsOrAnyDistanceMovesTheBase()
    {
        PlaceBase(new Vector3(0.3f, 1, 0.5f));
        var anchor = _session.GetComponentInChildren<BaseAnchor>();
        Pause();
        Assert.That(anchor.State, Is.EqualTo(BaseAnchorState.Restored));
        Assert.That(anchor.Words, Does.Contain("pause").And.Not.Contain("marker"));
        Assert.That(anchor.GetComponentInChildren<PoseAppearance>().Look.Reason, Does.Not.Contain("marker"));

        Press("<XRController>{RightHand}/{Primary2DAxisClick}");
        Assert.That(anchor.State, Is.EqualTo(BaseAnchorState.Locked));

        Pause();
        Controls.Set(Grip, true);
        Run(0.1);
        Assert.That(Marker.IsMoving);
    }

    void Pause()
    {
        _cell.Player.Pause(true);
        _cell.Player.Pause(false);
        Run(0.2);
    }

    [Test]
    public void Scripts_DisabledWhileCarrying_ReleaseTheMarker()
    {
        MoveHand(new Vector3(0.3f, 1, 0.5f), Quaternion.identity);
        Controls.Set(Grip, true);
        Run(0.1);

        Marker.GetComponent<CarriedMarker>().enabled = false;

        Assert.That(Marker.IsMoving, Is.False);
    }

    [Test]
    public void Scripts_EnabledWhileTheHandIsTracked_GripCarriesTheMarker()
    {
        MoveHand(new Vector3(0.3f, 1, 0.5f), Quaternion.identity);
        Run(0.1);
        var carried = Marker.GetComponent<CarriedMarker>();
        carried.enabled = false;
        carried.enabled = true;

        Controls.Set(Grip, true);
        Run(0.1);

        Assert.That(Marker.IsMoving);
    }
}
