using Nowpose.Session;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Tests.Rendering;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests;

/// <summary>Tests parts of the cell that get another session, and parts without a session.</summary>
public class ChangedSessionTests : PlayedParts
{
    static readonly Type[] Kinds = [typeof(TrackedObject), typeof(StationaryObject), typeof(CellSignal), typeof(ActuatedPart)];

    [Test]
    public void Part_OtherSession_IsPartOfThatSessionOnly([ValueSource(nameof(Kinds))] Type kind, [Values] bool isMoved)
    {
        var other = _cell.Play();
        var part = NewPart(kind, _session.transform);
        Run(0.1);
        var before = UseOf(_session, part);

        Give(part, other, isMoved);
        Run(0.1);

        Assert.That(before.Parts, Is.EqualTo(1));
        Assert.That((UseOf(_session, part), UseOf(other, part)), Is.EqualTo(((0, false), before)));
    }

    [Test]
    public void Rig_OtherSession_IsMovedByThatSessionOnly([Values] bool isMoved)
    {
        var other = _cell.Play();
        var rig = Below<RobotRig>("Robot", _session.transform);
        Run(0.1);

        Give(rig, other, isMoved);

        bool Moves(MrilSession session) => session.Movers.HasAny(mover => mover == rig);
        Assert.That((Moves(_session), Moves(other)), Is.EqualTo((false, true)));
    }

    [Test]
    public void Appearance_PartsSessionChanges_ShowsWhetherThePartIsCurrentInThatSession([Values] bool isMoved, [Values] bool isRig)
    {
        var other = _cell.Play();
        var part = NewPart(isRig ? typeof(RobotRig) : typeof(ActuatedPart), _session.transform);
        var appearance = part.gameObject.AddComponent<PoseAppearance>();
        var look = PlayedAppearance.Part("look", part.transform);
        appearance.Refresh();
        Run(1);
        SendSignal("part", _cell.Now - 1, 1);
        Run(0.5);
        Assert.That(Hatched.IsHatched(look), Is.False, appearance.Look.Reason);

        Give(part, other, isMoved);
        Run(0.5);

        Assert.That(look.isVisible && !Hatched.IsHatched(look), Is.False, "the other session has no clock");
    }

    [Test]
    public void Fault_PartWithoutASession_StatesThatItHasNone([ValueSource(nameof(Kinds))] Type kind)
    {
        var part = NewPart(kind, null);
        Run(0.1);

        Assert.That(FaultOf(part), Is.EqualTo(StatusMessages.NoSession));
    }

    static MonoBehaviour NewPart(Type type, Transform parent)
    {
        var made = new GameObject("part");
        made.transform.SetParent(parent, false);
        return (MonoBehaviour)made.AddComponent(type);
    }

    static void Give(MonoBehaviour part, MrilSession session, bool isMoved)
    {
        if (isMoved) part.transform.SetParent(session.transform, false);
        else if (part is TrackedObject tracked) tracked.Follow(session);
        else if (part is StationaryObject placed) placed.Follow(session);
        else if (part is CellSignal signal) signal.Follow(session);
        else if (part is ActuatedPart actuated) actuated.Follow(session);
        else ((RobotRig)part).Follow(session);
    }

    static (int Parts, bool IsMover) UseOf(MrilSession session, MonoBehaviour part) =>
        (session.Parts.Count, session.Movers.HasAny(mover => mover == part));

    static string FaultOf(MonoBehaviour part) => part switch
    {
        TrackedObject tracked => tracked.Fault,
        StationaryObject placed => placed.Fault,
        CellSignal signal => signal.Fault,
        _ => ((ActuatedPart)part).Fault,
    };
}
