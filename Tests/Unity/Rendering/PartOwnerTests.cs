using Nowpose.Gateway.Plants;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Unity;
using NUnit.Framework;
using UnityEngine;
using static Nowpose.Unity.Tests.Hatched;
using static Nowpose.Unity.Tests.Rendering.PlayedAppearance;

namespace Nowpose.Unity.Tests.Rendering;

/// <summary>Tests that the parts of an appearance that is destroyed or disabled belong to the next one above, with the state of what moves them.</summary>
public class PartOwnerTests : PlayedParts
{
    RobotRig _lower, _upper;
    PoseAppearance _above, _below;
    Renderer _base, _arm;

    [SetUp]
    public void Build()
    {
        (_lower, _above, _base) = NewRobot(_session.transform, "");
        (_upper, _below, _arm) = NewRobot(_lower.transform, "arm2");
        Run(2, SendUpper);
        Assert.That((IsHatched(_base), IsHatched(_arm)), Is.EqualTo((false, false)));
    }

    (RobotRig Rig, PoseAppearance Appearance, Renderer Part) NewRobot(Transform parent, string robotNamespace)
    {
        var made = new GameObject("Robot" + robotNamespace);
        made.SetActive(false);
        made.transform.SetParent(parent, false);
        var rig = made.AddComponent<RobotRig>().With("_session", _session).With("_robotNamespace", robotNamespace)
            .With("_description", RobotDescriptionAsset.Create("robot", RobotFiles.LoadText("youbot")));
        var appearance = made.AddComponent<PoseAppearance>().With("_session", _session);
        var part = Part("look", made.transform);
        made.SetActive(true);
        return (rig, appearance, part);
    }

    void SendUpper(double t)
    {
        var joints = RobotFiles.Load("youbot").MovingJoints.Select(joint => joint.Name).ToArray();
        _session.Session.Listener.Received(
            new JointStateMessage(At(t), joints, joints.Select(_ => 0.003).ToArray()), HeadsetTime.FromSeconds(1000 + t + Latency), "arm2");
    }

    void Remove(bool isDestroyed)
    {
        if (isDestroyed) UnityEngine.Object.Destroy(_below);
        else _below.enabled = false;
    }

    [Test]
    public void Show_AppearanceBelowRemoved_ItsPartsLookCurrentOnlyWhileTheirRobotIs([Values] bool isDestroyed)
    {
        Remove(isDestroyed);
        Run(0.1, SendUpper);
        Assert.That((IsHatched(_arm), _arm.isVisible), Is.EqualTo((false, true)));

        Run(1);
        Assert.That((_session.Frame.State, IsHatched(_base), IsHatched(_arm)), Is.EqualTo((PoseState.Current, false, true)), "the upper joints have stopped");
        Assert.That(_above.Look.Label, Is.Not.Empty);

        Run(1, SendUpper);
        Assert.That((IsHatched(_base), IsHatched(_arm), _above.Look.Label), Is.EqualTo((false, false, "")));
    }

    [Test]
    public void Show_AppearanceBelowRemovedWhileItsRobotIsHeld_EachFrameHasStripes([Values] bool isDestroyed)
    {
        Run(1);
        Assert.That(IsHatched(_arm), Is.True);

        Remove(isDestroyed);

        Run(0.5, seen: () => Assert.That(IsHatched(_arm), Is.True));
    }

    [Test]
    public void Show_AppearanceBelowRemovedWithoutASession_ItsPartsAreNotDrawnAsCurrent([Values] bool isDestroyed)
    {
        _session.enabled = false;
        _cell.Player.Step(_cell.Now);

        Remove(isDestroyed);
        for (var i = 0; i < 3; i++) _cell.Player.Step(_cell.Now);

        Assert.That(IsHatched(_arm) || !_arm.isVisible, Is.True);
    }

    [Test]
    public void Enable_AfterTheAppearanceAboveTookOver_TheOriginalLookIsKept()
    {
        Run(1);
        _below.enabled = false;
        Run(0.1);

        _below.enabled = true;
        Run(0.1);
        Assert.That(IsHatched(_arm), Is.True);
        Run(1, SendUpper);

        Assert.That(IsHatched(_arm), Is.False, "the stripes are not its own look");
        Assert.That(_above.PartCount + _below.PartCount, Is.EqualTo(_lower.GetComponentsInChildren<Renderer>(true).Length));
    }
}
