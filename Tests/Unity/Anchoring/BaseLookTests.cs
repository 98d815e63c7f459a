using Nowpose.Anchoring;
using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Protocol.Cell;
using Nowpose.Session;
using Nowpose.Unity.Messages;
using NUnit.Framework;
using UnityEngine;
using static Nowpose.Unity.Tests.Anchoring.PlayedBaseAnchor;

namespace Nowpose.Unity.Tests.Anchoring;

/// <summary>Tests which parts show the state of the base: those that the base places.</summary>
public class BaseLookTests
{
    PlayedBaseAnchor _played;

    [SetUp]
    public void Begin() => _played = new PlayedBaseAnchor();

    [TearDown]
    public void End() => _played.Dispose();

    [TestCase(typeof(CellSignal))]
    [TestCase(typeof(ActuatedPart))]
    public void Label_SignalBesideTheBase_DoesNotStateTheBase(Type component)
    {
        var lamp = PlayedRig.Below<PoseAppearance>("lamp", _played.Session.transform);
        lamp.gameObject.AddComponent(component);
        PlaySearching();
        Assert.That(lamp.Look.Label, Is.Empty);

        lamp.transform.SetParent(_played.Anchor.transform, false);
        _played.Cell.Run(0.1, _played.Session);

        Assert.That(lamp.Look.Label, Does.Contain(BaseMessages.NotLockedLabel));
    }

    [Test]
    public void Label_RigBesideTheBase_StatesTheBaseOnceAFramePlacesTheRig()
    {
        var rig = PlayedRig.Below<RobotRig>("beside", _played.Session.transform);
        var appearance = rig.gameObject.AddComponent<PoseAppearance>();
        PlaySearching();
        Assert.That(appearance.Look.Label, Is.Empty);

        _played.Session.Session.Listener.FramesReceived(
            new TransformsMessage(Base.ToTransform(default, "world", _played.Session.Robot.Links[0].Name)), true, _played.Cell.Clock.Now);
        _played.Cell.Run(0.1, _played.Session);

        Assert.That(appearance.Look.Label, Is.EqualTo(BaseMessages.NotLockedLabel));
    }

    [Test]
    public void Label_AppearanceAboveTheBase_StatesTheBaseForItsPartsBelow([Values] bool isObject)
    {
        var look = _played.Session.gameObject.AddComponent<PoseAppearance>();
        var part = PlayedRig.Below<MeshRenderer>("table", _played.Anchor.transform);
        if (isObject)
        {
            part.gameObject.AddComponent<TrackedObject>();
            part.GetComponent<PoseAppearance>().enabled = false;
        }
        look.Refresh();

        PlaySearching();

        Assert.That(look.Look.Label, Does.Contain(BaseMessages.NotLockedLabel));
    }

    [Test]
    public void Label_BaseAnchorReplaced_StatesTheNewBaseThatTheObjectFollows()
    {
        var box = PlayedRig.Below<TrackedObject>("box", _played.Session.transform);
        string Label() => box.GetComponent<PoseAppearance>().Look.Label;
        _played.PlayLocked();
        Assert.That(Label(), Does.Not.Contain(BaseMessages.NotLockedLabel));
        UnityEngine.Object.Destroy(_played.Anchor.gameObject);
        _played.Cell.Run(0.1, _played.Session);
        _played.Markers.IsBlind = true;
        PlayedRig.Below<BaseAnchor>("second", _played.Session.transform).Use("second", [new BaseMarker("b", InBase)]);
        _played.Cell.Run(0.1, _played.Session);

        box.enabled = false;
        box.enabled = true;
        _played.Cell.Run(0.1, _played.Session);

        Assert.That(Label(), Does.EndWith(", " + BaseMessages.NotLockedLabel));
    }

    [Test]
    public void Label_BaseAnchorComponentReplaced_StatesTheNewBase()
    {
        _played.PlayLocked();
        var place = _played.Anchor.gameObject;
        UnityEngine.Object.Destroy(_played.Anchor);
        _played.Cell.Run(0.1, _played.Session);

        place.AddComponent<BaseAnchor>().Use("second", [new BaseMarker("b", InBase)]);
        _played.Cell.Run(0.1, _played.Session);

        Assert.That(place.GetComponentInChildren<PoseAppearance>().Look.Label, Is.EqualTo(BaseMessages.NotLockedLabel));
    }

    void PlaySearching()
    {
        _played.Markers.IsBlind = true;
        _played.PlayOne();
        _played.Cell.Run(5, _played.Session);
        Assert.That(_played.Anchor.State, Is.EqualTo(BaseAnchorState.Searching));
    }
}
