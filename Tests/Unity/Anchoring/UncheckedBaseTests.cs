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

/// <summary>Tests a base anchor that cannot check the pose because it is disabled, or that displays it at another scale.</summary>
public class UncheckedBaseTests
{
    PlayedBaseAnchor _played;

    [SetUp]
    public void Begin() => _played = new PlayedBaseAnchor();

    [TearDown]
    public void End() => _played.Dispose();

    [TestCase(false)]
    [TestCase(true)]
    public void Component_DisabledAfterALock_BaseLooksNotLockedUntilItIsEnabled(bool isGiven)
    {
        _played.PlayLocked();
        if (isGiven) _played.Anchor.Use("cell 7", [new BaseMarker("a", InBase)]);
        var states = new List<BaseAnchorState>();
        _played.Anchor.StateChanged += () =>
        {
            if (states.LastOrDefault() != _played.Anchor.State) states.Add(_played.Anchor.State);
        };
        _played.Markers.Base = Base * RigidTransform.FromXyzRpy(0.1, 0, 0, 0, 0, 0);

        _played.Anchor.enabled = false;
        _played.Cell.Run(1, _played.Session);
        Assert.That((_played.Anchor.State, _played.Anchor.Words), Is.EqualTo((BaseAnchorState.Searching, BaseMessages.Disabled)));
        Assert.That(_played.Look(), Is.EqualTo((0.8f, 1f, BaseMessages.NotLockedLabel)));
        Assert.That(_played.Anchor.GetComponentInChildren<PoseAppearance>().Look.Reason, Is.EqualTo(BaseMessages.Disabled));
        Assert.That(new BaseTexts().FaultOf(_played.Anchor), Is.EqualTo("base: " + BaseMessages.Disabled));

        _played.Anchor.enabled = true;
        _played.Cell.Run(1, _played.Session);
        Assert.That(states, Is.EqualTo(new[] { BaseAnchorState.Searching, BaseAnchorState.Locked, BaseAnchorState.Moved }));
    }

    // Unity does not let a listener switch objects on or off at that time.
    [Test]
    public void Object_SwitchedOff_RaisesNoEvent()
    {
        _played.PlayLocked();
        var raised = 0;
        _played.Anchor.StateChanged += () => raised++;

        _played.Anchor.gameObject.SetActive(false);

        Assert.That((_played.Anchor.State, raised), Is.EqualTo((BaseAnchorState.Searching, 0)));
    }

    [Test]
    public void Component_DisabledFromTheStart_BaseLooksNotLocked()
    {
        _played.Anchor.enabled = false;
        _played.PlayOne();
        _played.Cell.Run(3, _played.Session);

        Assert.That(_played.Look(), Is.EqualTo((0.8f, 1f, BaseMessages.NotLockedLabel)));
    }

    [Test]
    public void Component_DisabledWhilePlacedByHand_StaysPlaced()
    {
        _played.PlayLocked();
        _played.Anchor.Place(new Vector3(1, 2, 3), Quaternion.identity);

        _played.Anchor.enabled = false;
        _played.Cell.Run(1, _played.Session);

        Assert.That((_played.Anchor.State, _played.Anchor.Words), Is.EqualTo((BaseAnchorState.Placed, BaseStatusMessages.Placed)));
    }

    [TestCase(1f, true, 0)]
    [TestCase(0.5f, false, 0)]
    [TestCase(0.5f, true, 1)]
    public void Scale_OfAParent_IsLoggedEachTimeItBecomesWrongIfThereAreMarkers(float scale, bool hasMarkers, int logged)
    {
        _played.Session.transform.localScale = scale * Vector3.one;
        if (hasMarkers) _played.PlayOne();
        else _played.Session.gameObject.SetActive(true);

        _played.Cell.Run(2, _played.Session);

        var words = BaseMessages.Scaled(_played.Anchor.transform.lossyScale);
        int Logged() => _played.Logged.Count(message => message.EndsWith(words));
        Assert.That(Logged(), Is.EqualTo(logged));
        _played.Session.transform.localScale = Vector3.one;
        _played.Cell.Run(1, _played.Session);
        _played.Session.transform.localScale = scale * Vector3.one;
        _played.Cell.Run(1, _played.Session);
        Assert.That(Logged(), Is.EqualTo(2 * logged));
    }
}
