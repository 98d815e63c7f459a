using MixedReality.Toolkit;
using MixedReality.Toolkit.SpatialManipulation;
using MixedReality.Toolkit.UX;
using Nowpose.Mrtk3;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using Nowpose.UnityPlayer;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.XR.Interaction.Toolkit;

namespace Nowpose.Unity.Tests.Mrtk3;

public sealed class GraspableTests
{
    Player _player;
    GameObject _object;
    ObjectManipulator _manipulator;

    [SetUp]
    public void Begin()
    {
        _player = new Player();
        _object = new GameObject("Held");
        _object.SetActive(false);
        _manipulator = _object.AddComponent<ObjectManipulator>();
    }

    [TearDown]
    public void End() => _player.Dispose();

    HandPlacedMarker Marker(bool withHandles = false)
    {
        var marker = _object.AddComponent<HandPlacedMarker>();
        if (withHandles) _object.AddComponent<BoundsControl>();
        _object.AddComponent<GraspableMarker>();
        _object.SetActive(true);
        return marker;
    }

    [Test]
    public void Marker_HeldByTwoHands_MovesFromTheFirstGraspToTheLastRelease()
    {
        var marker = Marker();
        var moving = new List<bool> { marker.IsMoving };

        _manipulator.Enter();
        moving.Add(marker.IsMoving);
        _manipulator.Enter();
        _manipulator.Exit();
        moving.Add(marker.IsMoving);
        _manipulator.Exit();
        moving.Add(marker.IsMoving);

        Assert.That(moving, Is.EqualTo(new[] { false, true, true, false }));
    }

    [Test]
    public void Marker_TurnedByAHandleWhileHeld_MovesUntilBothAreReleased()
    {
        var marker = Marker(withHandles: true);
        var handles = _object.GetComponent<BoundsControl>();

        _manipulator.Enter();
        handles.ManipulationStarted.Invoke(new SelectEnterEventArgs());
        _manipulator.Exit();
        var between = marker.IsMoving;
        handles.ManipulationEnded.Invoke(new SelectExitEventArgs());

        Assert.That((between, marker.IsMoving), Is.EqualTo((true, false)));
    }

    [Test]
    public void Marker_DisabledWhileHeld_IsReleased()
    {
        var marker = Marker();
        _manipulator.Enter();

        _object.GetComponent<GraspableMarker>().enabled = false;

        Assert.That(marker.IsMoving, Is.False);
    }

    [Test]
    public void Marker_GraspedWhileDisabled_DoesNotMove([Values] bool isByHandle)
    {
        var marker = Marker(withHandles: true);
        _object.GetComponent<GraspableMarker>().enabled = false;

        if (isByHandle) _object.GetComponent<BoundsControl>().ManipulationStarted.Invoke(new SelectEnterEventArgs());
        else _manipulator.Enter();

        Assert.That(marker.IsMoving, Is.False);
    }

    [Test]
    public void Marker_MissingReferences_LogsThem()
    {
        new GameObject("Lone").AddComponent<GraspableMarker>();

        Assert.That(_player.Logs.Select(l => l.Message), Has.Some.Contains(Mrtk3Messages.MarkerWithoutMarker("Lone")));
        Assert.That(_player.Logs.Select(l => l.Message), Has.Some.Contains(Mrtk3Messages.MarkerWithoutManipulator("Lone")));
    }

    [Test]
    public void Panel_PinnedBeforeItIsFirstActive_Stays()
    {
        var follow = _object.AddComponent<BodyFollow>();
        var panel = _object.AddComponent<GraspablePanel>();

        panel.SetPinned(true);
        _object.SetActive(true);

        Assert.That((follow.enabled, panel.IsPinned), Is.EqualTo((false, true)));
    }

    [Test]
    public void Panel_Grasped_StaysUntilFollowIsPressed()
    {
        var follow = _object.AddComponent<BodyFollow>();
        var pin = new GameObject("Pin").AddComponent<PressableButton>();
        pin.ToggleMode = StatefulInteractable.ToggleType.Toggle;
        var panel = _object.AddComponent<GraspablePanel>().With("_pin", pin);
        pin.OnClicked.AddListener(panel.TogglePinned);
        _object.SetActive(true);

        _manipulator.Enter();
        _manipulator.Exit();
        _player.Step(0.1);
        var grasped = (follow.enabled, pin.IsToggled.Active);
        pin.Enter();
        pin.Exit();
        _player.Step(0.2);

        Assert.That(grasped, Is.EqualTo((false, true)));
        Assert.That((follow.enabled, pin.IsToggled.Active), Is.EqualTo((true, false)));
    }
}
