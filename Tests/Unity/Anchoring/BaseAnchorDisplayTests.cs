using Nowpose.Anchoring;
using Nowpose.Editor.Inspectors;
using Nowpose.Editor.Messages;
using Nowpose.Editor.Setup;
using Nowpose.Kinematics;
using Nowpose.Messages;
using Nowpose.Session;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Status;
using NUnit.Framework;
using UnityEngine;
using static Nowpose.Unity.Tests.Anchoring.PlayedBaseAnchor;

namespace Nowpose.Unity.Tests.Anchoring;

/// <summary>Tests how the state of the base anchor is shown to the wearer, in the Console and in the Inspector.</summary>
public class BaseAnchorDisplayTests
{
    PlayedBaseAnchor _played;

    [SetUp]
    public void Begin() => _played = new PlayedBaseAnchor();

    [TearDown]
    public void End() => _played.Dispose();

    [Test]
    public void Words_SourceHasProblem_StateTheProblem()
    {
        _played.Markers.Problem = "no AR Session is in the scene";
        _played.Markers.IsBlind = true;
        _played.PlayOne();

        _played.Cell.Run(1, _played.Session);

        Assert.That(_played.Anchor.Words, Is.EqualTo(BaseStatusMessages.Looking(isBlind: false, _played.Markers.Problem)));
        _played.Markers.Problem = null;
        _played.Cell.Run(12, _played.Session);
        Assert.That(_played.Anchor.Words, Is.EqualTo(BaseStatusMessages.Looking(isBlind: true, problem: null)));
    }

    [Test]
    public void Words_NoSourceThatDetectsCodes_StateThatOneIsMissing()
    {
        PlayedRig.Below<HandPlacedMarker>("Hand", _played.Session.transform);
        _played.Markers.enabled = false;
        _played.PlayOne();

        _played.Cell.Run(12, _played.Session);

        Assert.That(_played.Anchor.Words, Is.EqualTo(BaseStatusMessages.Looking(isBlind: false, BaseMessages.NoMarkerSource)));
    }

    [Test]
    public void Use_AfterInvalidFields_ClearsTheProblem()
    {
        _played.Play(new AnchorMarker("", Vector3.zero, Vector3.zero));
        Assert.That(_played.Anchor.Words, Is.EqualTo(MarkerMessages.PayloadEmpty));

        _played.Anchor.Use("cell", [new BaseMarker("a", InBase)]);
        _played.Cell.Run(3, _played.Session);

        Assert.That(_played.Anchor.Words, Is.EqualTo(BaseStatusMessages.Locked(1)));
    }

    [Test]
    public void Markers_SeenObliquely_AreIgnoredWithTheReason()
    {
        _played.PlayOne();
        var pose = UnityPoses.ToWorld(Base);
        _played.Head.SetPositionAndRotation(pose.position + new Vector3(0, 0.1f, -1), Quaternion.identity);

        _played.Cell.Run(3, _played.Session);

        Assert.That(_played.Anchor.State, Is.EqualTo(BaseAnchorState.Searching));
        Assert.That(_played.Anchor.Words, Is.EqualTo(MarkerName.Of("a") + " " + BaseStatusMessages.TooOblique));
    }

    [Test]
    public void Marker_Moved_IsReportedAndNotFollowed()
    {
        _played.PlayLocked();
        var before = _played.Anchor.transform.position;
        _played.Markers.Markers["a"] = InBase * RigidTransform.FromXyzRpy(0.05, 0, 0, 0, 0, 0);

        _played.Cell.Run(1, _played.Session);

        Assert.That(_played.Anchor.State, Is.EqualTo(BaseAnchorState.Moved));
        Assert.That(
            _played.Anchor.Words, Does.Match("^" + BaseStatusMessages.Moved(1, MarkerName.Of("a"), @"(49|50|51) mm, 0\.\d°") + "$"));
        Assert.That(_played.Anchor.transform.position, Is.EqualTo(before));
        var said = _played.Cell.Player.Logs.Where(log => log.Message.Contains(MarkerName.Of("a"))).ToList();
        Assert.That(said.Select(log => log.Type), Is.EqualTo(new[] { LogType.Warning }), "once");
    }

    [Test]
    public void Look_BaseUncertain_HasStripesAndStatesTheReason()
    {
        _played.Markers.IsBlind = true;
        _played.PlayOne();
        _played.Cell.Run(5, _played.Session);
        Assert.That(_played.Look(), Is.EqualTo((0.8f, 1f, BaseMessages.NotLockedLabel)));

        _played.Markers.IsBlind = false;
        _played.Cell.Run(3, _played.Session);
        Assert.That(_played.Look(), Is.EqualTo((0f, 0f, "")), "locked");
        _played.Markers.Base = Base * RigidTransform.FromXyzRpy(0.1, 0, 0, 0, 0, 0);
        _played.Cell.Run(1, _played.Session);
        Assert.That(_played.Look(), Is.EqualTo((0.5f, 1f, BaseMessages.MovedLabel)));
        _played.Cell.IsPlantUp = false;
        _played.Cell.Run(3, _played.Session);

        Assert.That(_played.Look().Words, Is.EqualTo($"{PoseMessages.Of(PoseState.Held)}, {BaseMessages.MovedLabel}"));
    }

    [Test]
    public void Look_ObjectElsewhereInTheHierarchy_ShowsThatTheBaseIsUncertain()
    {
        var box = new GameObject("box").AddComponent<TrackedObject>();
        box.Follow(_played.Session);
        string Label() => box.GetComponent<PoseAppearance>().Look.Label;
        _played.Markers.IsBlind = true;
        _played.PlayOne();
        _played.Cell.Run(1, _played.Session);
        Assert.That(Label(), Does.EndWith(", " + BaseMessages.NotLockedLabel));

        _played.Markers.IsBlind = false;
        _played.Cell.Run(3, _played.Session);
        Assert.That(Label(), Is.EqualTo(PoseMessages.Of(PoseState.Incomplete)), "locked");
        _played.Markers.Base = Base * RigidTransform.FromXyzRpy(0.1, 0, 0, 0, 0, 0);
        _played.Cell.Run(1, _played.Session);

        Assert.That(Label(), Does.EndWith(", " + BaseMessages.MovedLabel));
    }

    [Test]
    public void StatusPanel_CellWithLockedBase_ShowsTheStateOfTheBase()
    {
        _played.PlayLocked();
        var texts = _played.Session.GetComponentInChildren<StatusPanel>().GetComponentsInChildren<TextMesh>();
        string Text(string name) => texts.Single(text => text.name == name).text;

        Assert.That(Text("Base 0"), Is.EqualTo("Base"));
        Assert.That(Text("Base 1"), Is.EqualTo("locked"));
        Assert.That(Text("Base 2"), Does.Match("^spread (0\\.9|1\\.0) mm 0\\.2°$"));
        _played.Markers.Base = Base * RigidTransform.FromXyzRpy(0.1, 0, 0, 0, 0, 0);
        _played.Cell.Run(2, _played.Session);

        Assert.That(Text("Base 1"), Is.EqualTo("! moved"));
        Assert.That(Text("Base 2"), Is.EqualTo("100" + StatusMessages.OffsetSuffix));
        Assert.That(Text("Message 0"), Does.Match("^! base: .*'a'.* (99|100|101) mm, "));
    }

    [Test]
    public void Fields_Invalid_AreLoggedOnce()
    {
        _played.Play(new AnchorMarker("a", Vector3.zero, Vector3.zero, sizeMetres: 9));
        _played.Cell.Run(1, _played.Session);
        _played.Anchor.enabled = false;
        _played.Anchor.enabled = true;
        _played.Cell.Run(1, _played.Session);

        var fault = Assert.Throws<InputException>(() => _ = new BaseMarker("a", RigidTransform.Identity, sizeMetres: 9));
        Assert.That(_played.Anchor.Words, Is.EqualTo(fault.Message));
        Assert.That(_played.Logged.Distinct(), Is.EqualTo(new[] { "[Nowpose] " + ComponentMessages.Of("base anchor", "Base Anchor", _played.Anchor.Words) }));
        Assert.That(_played.Session.Frame, Is.Not.Null, "the session continues");
    }

    [TestCase("", 0, 0, 1)]
    [TestCase("a", 350, 0, 1)]
    [TestCase("a", 0, 9, 1)]
    [TestCase("a", 0, 0, 2)]
    public void Fields_Invalid_RobotLooksNotLockedAndThePanelStatesTheReason(string payload, float x, float size, int count)
    {
        _played.Play([.. Enumerable.Repeat(new AnchorMarker(payload, new Vector3(x, 0, 0), Vector3.zero, size), count)]);

        _played.Cell.Run(3, _played.Session);

        Assert.That((_played.Anchor.State, _played.Anchor.Tracker), Is.EqualTo((BaseAnchorState.Searching, (BaseTracker)null)));
        Assert.That(_played.Look(), Is.EqualTo((0.8f, 1f, BaseMessages.NotLockedLabel)));
        Assert.That(new BaseTexts().FaultOf(_played.Anchor), Is.EqualTo("base: " + _played.Anchor.Words));
    }

    [TestCase(false)]
    [TestCase(true)]
    public void HandPlacedMarker_UnknownPayload_IsOnThePanelAndLoggedOnce(bool isLocked)
    {
        if (isLocked) _played.PlayLocked();
        else _played.Session.gameObject.SetActive(true);
        var hand = PlayedRig.Below<HandPlacedMarker>("Hand", _played.Session.transform).With("_payload", "b");
        _played.Cell.Run(1.1, _played.Session);

        hand.BeginMove();
        _played.Cell.Run(1, _played.Session);
        hand.EndMove();
        _played.Cell.Run(1, _played.Session);

        var words = BaseStatusMessages.NotOfThisBase(MarkerName.Of("b"));
        Assert.That(_played.Anchor.State, Is.EqualTo(isLocked ? BaseAnchorState.Locked : BaseAnchorState.Placed));
        Assert.That(new BaseTexts().FaultOf(_played.Anchor), Is.EqualTo("base: " + words));
        Assert.That(_played.Logged.Count(message => message.EndsWith(words)), Is.EqualTo(1));
    }

    [Test]
    public void HandPlacedMarker_OfAnotherBase_PlacesOnlyThatBase()
    {
        var other = PlayedRig.Below<BaseAnchor>("Other base", _played.Session.transform)
            .With("_markers", new List<AnchorMarker> { new("b", Vector3.zero, Vector3.zero) });
        var hand = PlayedRig.Below<HandPlacedMarker>("Hand", _played.Session.transform).With("_payload", "b");
        _played.PlayLocked();

        hand.BeginMove();
        _played.Cell.Run(1, _played.Session);
        hand.EndMove();
        _played.Cell.Run(1, _played.Session);

        Assert.That((_played.Anchor.State, new BaseTexts().FaultOf(_played.Anchor)), Is.EqualTo((BaseAnchorState.Locked, (string)null)));
        Assert.That(other.State, Is.EqualTo(BaseAnchorState.Locked));
    }

    [Test]
    public void Fields_InvalidAfterALock_BaseIsLockedWhenTheyAreValidAgain()
    {
        _played.PlayLocked();
        void Enter(params AnchorMarker[] markers)
        {
            _played.Anchor.enabled = false;
            _played.Anchor.With("_markers", markers.ToList());
            _played.Anchor.enabled = true;
            _played.Cell.Run(4, _played.Session);
        }

        Enter(Marker, Marker);
        Assert.That(_played.Anchor.State, Is.EqualTo(BaseAnchorState.Searching));
        Enter(Marker);

        Assert.That(_played.Anchor.State, Is.EqualTo(BaseAnchorState.Locked));
    }

    [Test]
    public void InspectorRows_BaseLocked_ShowLockDeviceAnchorAndMarkers()
    {
        _played.Session.gameObject.AddComponent<FakeSpatialAnchors>();
        _played.PlayLocked();
        _played.Markers.IsBlind = true;
        _played.Cell.Run(3, _played.Session);

        var rows = BaseRows.Of(_played.Anchor.Tracker).Select(row => row.Label + ": " + row.Value).ToList();

        Assert.That(rows, Has.Some.Match($@"^{InspectorTexts.LockSpread}: (0.9|1.0)\d mm, 0.2\d°$"));
        Assert.That(rows, Does.Contain($"{InspectorTexts.HeldByDevice}: {InspectorTexts.Held("cell 7")}"));
        Assert.That(rows, Does.Contain(InspectorTexts.MovedByLock + ": 0.00 mm, 0.00°"));
        var old = InspectorTexts.Of(SightingFault.Old);
        Assert.That(rows, Does.Contain("a: " + InspectorTexts.Ignored(old)));
        Assert.That(rows, Has.Some.Match($@"^{InspectorTexts.Sightings}: 1[12]\d; {InspectorTexts.Ignored("1 " + old)}$"));
        Assert.That(rows, Has.Some.Match($@"^{InspectorTexts.OffBy}: 0\.\d\d mm, 0\.\d\d°$"));
    }

    // The distance between the two markers differs from that of the fields, so one of the three is wrong.
    [Test]
    public void Markers_InConflict_AreLoggedOnce()
    {
        _played.Markers.Markers["b"] = InBase * RigidTransform.FromXyzRpy(0.2, 0, 0, 0, 0, 0);
        _played.Play(Marker, new AnchorMarker("b", new Vector3(0.6f, 0, 0), Vector3.zero));

        _played.Cell.Run(4, _played.Session);

        Assert.That(_played.Anchor.Tracker.Conflict, Is.Not.Null);
        var text = MessagePattern.Of(BaseStatusMessages.Conflict(MessagePattern.Any, MessagePattern.Any, MessagePattern.Any));
        Assert.That(_played.Cell.Player.Logs.Select(log => log.Message), Has.Exactly(1).Match(text));
    }
}
