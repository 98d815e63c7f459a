using Nowpose.Session;
using Nowpose.Unity.Cell;
using Nowpose.Unity.Tests.Rendering;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Events;
using static Nowpose.Unity.Tests.Hatched;

namespace Nowpose.Unity.Tests.Session;

/// <summary>Tests that an exception of a user's listener ends neither the frame nor the session.</summary>
public class ThrowingListenerTests : PlayedParts
{
    RobotRig _rig;
    PoseAppearance _appearance;
    Renderer _part;

    [SetUp]
    public void AddRobot()
    {
        _rig = Below<RobotRig>("Robot", _session.transform);
        _appearance = _rig.gameObject.AddComponent<PoseAppearance>();
        _part = PlayedAppearance.Part("part", _rig.transform);
    }

    [Test]
    public void Posed_ListenerThrowsAndSamplesStop_RobotIsStriped()
    {
        Run(1);
        Assert.That((_session.Frame.State, IsHatched(_part)), Is.EqualTo((PoseState.Current, false)));

        _rig.Posed += Throw;
        _cell.IsPlantUp = false;
        Run(1.5);

        Assert.That((_session.Frame.State, IsHatched(_part)), Is.EqualTo((PoseState.Held, true)));
        Assert.That(Exceptions, Is.GreaterThan(0));
    }

    [Test]
    public void Hidden_EarlierListenerThrows_RobotIsStripedDuringAPause()
    {
        _session.Hidden += Throw;
        Run(1);

        _cell.Player.Pause(true);

        Assert.That((_session.Session, IsHatched(_part), Exceptions), Is.EqualTo(((CompensationSession)null, true, 1)));
    }

    [Test]
    public void Bound_EarlierListenerThrows_AppearanceListsTheBuiltLinks()
    {
        _rig.Bound += Throw;
        Run(0.1);
        var known = _appearance.PartCount;
        _appearance.Refresh();

        Assert.That(known, Is.EqualTo(_appearance.PartCount).And.GreaterThan(1));
    }

    [Test]
    public void Shown_ListenerThrows_ChangesAreRaised()
    {
        var raised = new List<SessionChange>();
        _session.Shown += _ => Throw();
        _session.Changed += raised.Add;

        Run(3);

        Assert.That(raised, Is.EqualTo(new[] { SessionChange.Synchronised }));
    }

    [TestCase("Lost")]
    [TestCase("Changed")]
    [TestCase("Hidden")]
    public void Settings_SetWhileAListenerThrows_StartsASession(string raised)
    {
        var listeners = new UnityEvent();
        listeners.AddListener(Throw);
        if (raised == "Lost") _session.With("_onLost", listeners);
        else if (raised == "Changed") _session.Changed += change => { if (change == SessionChange.Lost) Throw(); };
        else _session.Hidden += Throw;
        Run(3);

        _session.Settings = PlayedCell.Offline;

        Assert.That((_session.Session != null, Exceptions), Is.EqualTo((true, 1)));
    }

    [Test]
    public void Move_OneComponentThrows_OthersMove()
    {
        var movers = new Movers();
        var moved = 0;
        movers.Add(_rig, _ => throw new InvalidOperationException("thrown by the component"));
        movers.Add(_appearance, _ => moved++);

        movers.Move(null);

        Assert.That((moved, Exceptions), Is.EqualTo((1, 1)));
    }

    int Exceptions => _cell.Player.Logs.Count(log => log.Type == LogType.Exception);

    static void Throw() => throw new InvalidOperationException("thrown by the listener");
}
