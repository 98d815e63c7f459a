using Nowpose.Anchoring;
using Nowpose.Editor;
using Nowpose.Editor.Inspectors;
using Nowpose.Editor.Setup;
using Nowpose.Kinematics;
using Nowpose.Unity;
using Nowpose.Unity.Status;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Anchoring;

/// <summary>The base anchor in a running cell of the package, with a device that sees markers.</summary>
public class BaseAnchorTests
{
    static readonly RigidTransform Base = RigidTransform.FromXyzRpy(1, 0.3, -0.4, 0, 0, 2);
    static readonly RigidTransform InBase = RigidTransform.FromXyzRpy(0.25, 0, 0, 0, 0, 0.5);

    PlayedCell _cell;
    MrilSession _session;
    BaseAnchor _anchor;
    FakeMarkers _markers;
    Transform _head;

    [SetUp]
    public void Begin()
    {
        _cell = new PlayedCell();
        _head = new GameObject("Camera") { tag = "MainCamera" }.AddComponent<Camera>().transform;
        _session = _cell.NewSessionOf("Nowpose Robot Cell");
        _anchor = _session.GetComponentInChildren<BaseAnchor>(true);
        _markers = _session.gameObject.AddComponent<FakeMarkers>();
        _markers.Clock = _cell.Clock;
        _markers.Base = Base;
        _markers.Markers["a"] = InBase;
        LookDownAt(Base);
    }

    [TearDown]
    public void End() => _cell.Dispose();

    // Looks down from one metre above and to one side.
    void LookDownAt(in RigidTransform place)
    {
        var pose = UnityPoses.ToWorld(place);
        _head.SetPositionAndRotation(pose.position + new Vector3(0.2f, 1, 0), Quaternion.Euler(90, 0, 0));
    }

    void Play(params AnchorMarker[] markers)
    {
        _anchor.With("_markers", markers.ToList()).With("_cell", "cell 7");
        _session.gameObject.SetActive(true);
    }

    void PlayOne() => Play(new AnchorMarker("a", new Vector3(0.25f, 0, 0), new Vector3(0, 0, 0.5f * Mathf.Rad2Deg)));

    void PlayLocked()
    {
        PlayOne();
        _cell.Run(4, _session);
        Assert.That(_anchor.State, Is.EqualTo(BaseAnchorState.Locked));
    }

    (float Metres, float Degrees) OffFrom(in RigidTransform place)
    {
        var pose = UnityPoses.ToWorld(place);
        return (Vector3.Distance(_anchor.transform.position, pose.position), Quaternion.Angle(_anchor.transform.rotation, pose.rotation));
    }

    IEnumerable<string> Logged => _cell.Messages.Where(message => message.Contains("base anchor"));

    (float Fade, float Hatch, string Words) Look()
    {
        var appearance = _anchor.GetComponentInChildren<PoseAppearance>();
        var block = new MaterialPropertyBlock();
        appearance.GetComponentsInChildren<MeshRenderer>().First(r => r.sharedMaterial.HasProperty("_Hatch")).GetPropertyBlock(block);
        return (
            block.GetFloat(Shader.PropertyToID("_Fade")), block.GetFloat(Shader.PropertyToID("_Hatch")),
            appearance.GetComponentsInChildren<TextMesh>().Single(text => text.name == "Words").text);
    }

    [Test]
    public void Markers_None_KeepThePlacedPose()
    {
        _markers.Markers.Clear();
        _session.gameObject.SetActive(true);
        _anchor.Place(new Vector3(1, 2, 3), Quaternion.identity);
        _cell.Run(1, _session);
        _anchor.transform.position = new Vector3(3, 2, 1);

        _cell.Run(1, _session);

        Assert.That(_anchor.transform.position, Is.EqualTo(new Vector3(3, 2, 1)));
        Assert.That(_anchor.State, Is.EqualTo(BaseAnchorState.Placed));
        Assert.That(_anchor.Words, Is.EqualTo("placed by hand"));
        Assert.That(Logged, Is.Empty);
    }

    [Test]
    public void Words_SourceWithProblem_StateTheReason()
    {
        _markers.Problem = "no AR Session is in the scene";
        _markers.IsBlind = true;
        PlayOne();

        _cell.Run(1, _session);

        Assert.That(_anchor.Words, Is.EqualTo("looking for markers; no AR Session is in the scene"));
        _markers.enabled = false;
        _cell.Run(12, _session);
        Assert.That(_anchor.Words, Is.EqualTo("looking for markers; allow the camera if it is blocked"));
    }

    [Test]
    public void Locked_DeviceLosesOrMovesTheAnchor_IsLoggedOnceAndShown()
    {
        var device = _session.gameObject.AddComponent<FakeSpatialAnchors>();
        PlayLocked();
        var texts = new BaseTexts();
        Assert.That(texts.FaultOf(_anchor), Is.Null);

        device.Problem = "the store is full";
        _cell.Run(3, _session);
        Assert.That(texts.FaultOf(_anchor), Is.EqualTo("base: locked by 1 marker; the store is full"));
        Assert.That(Logged.Count(message => message.EndsWith("; the store is full")), Is.EqualTo(1));
        device.Problem = null;
        _cell.Run(1, _session);
        Assert.That(texts.FaultOf(_anchor), Is.Null);

        device.Pose = RigidTransform.FromXyzRpy(0.012, 0, 0, 0, 0, 0) * device.Pose.Value;
        _markers.IsBlind = true;
        _cell.Run(3, _session);
        Assert.That(texts.FaultOf(_anchor), Is.EqualTo("base: locked by 1 marker; moved by the headset by 12 mm, 0.0°"));
        Assert.That(Logged.Count(message => message.Contains("moved by the headset by 12 mm")), Is.EqualTo(1));
    }

    [Test]
    public void Use_AfterInvalidFields_ClearsTheProblem()
    {
        Play(new AnchorMarker("", Vector3.zero, Vector3.zero));
        Assert.That(_anchor.Words, Does.StartWith("marker"));

        _anchor.Use("cell", [new BaseMarker("a", InBase)]);
        _cell.Run(3, _session);

        Assert.That(_anchor.Words, Is.EqualTo("locked by 1 marker"));
    }

    [Test]
    public void Markers_InView_LockTheBaseAtTheRobot()
    {
        PlayOne();
        var states = new List<BaseAnchorState>();
        _anchor.StateChanged += () => states.Add(_anchor.State);

        _cell.Run(2, _session);

        Assert.That(_anchor.State, Is.EqualTo(BaseAnchorState.Locked));
        Assert.That(OffFrom(Base).Metres, Is.LessThan(0.001));
        Assert.That(OffFrom(Base).Degrees, Is.LessThan(0.15));
        Assert.That(states[^1], Is.EqualTo(BaseAnchorState.Locked));
        Assert.That(Logged, Is.EqualTo(new[]
        {
            "[Nowpose] base anchor 'Base Anchor': looking for markers", "[Nowpose] base anchor 'Base Anchor': locked by 1 marker",
        }));
    }

    [Test]
    public void Markers_SeenObliquely_AreIgnoredWithTheReason()
    {
        PlayOne();
        var pose = UnityPoses.ToWorld(Base);
        _head.SetPositionAndRotation(pose.position + new Vector3(0, 0.1f, -1), Quaternion.identity);

        _cell.Run(3, _session);

        Assert.That(_anchor.State, Is.EqualTo(BaseAnchorState.Searching));
        Assert.That(_anchor.Words, Is.EqualTo("marker 'a' is seen too obliquely: go in front of it"));
    }

    [Test]
    public void Marker_Moved_IsReportedAndNotFollowed()
    {
        PlayLocked();
        var before = _anchor.transform.position;
        _markers.Markers["a"] = InBase * RigidTransform.FromXyzRpy(0.05, 0, 0, 0, 0, 0);

        _cell.Run(1, _session);

        Assert.That(_anchor.State, Is.EqualTo(BaseAnchorState.Moved));
        Assert.That(_anchor.Words, Does.Match("^marker 'a', (49|50|51) mm, 0\\.\\d° from its expected place: put it back, or lock again$"));
        Assert.That(_anchor.transform.position, Is.EqualTo(before));
        var said = _cell.Player.Logs.Where(log => log.Message.Contains("from its expected place")).ToList();
        Assert.That(said.Select(log => log.Type), Is.EqualTo(new[] { LogType.Warning }), "once");
    }

    [Test]
    public void Relock_BaseMoved_EasesToTheNewPose()
    {
        PlayLocked();
        var there = Base * RigidTransform.FromXyzRpy(0.1, 0, 0, 0, 0, 0);
        _markers.Base = there;
        _cell.Run(1, _session);
        _anchor.Relock();
        var last = _anchor.transform.position;
        float fastest = 0;

        _cell.Run(4, _session, () =>
        {
            fastest = Mathf.Max(fastest, Vector3.Distance(last, _anchor.transform.position));
            last = _anchor.transform.position;
        });

        Assert.That(OffFrom(there).Metres, Is.LessThan(0.001));
        Assert.That(fastest, Is.InRange(0.001f, 0.01f), "metres in a frame");
        Assert.That(_anchor.Words, Does.Match("^locked by 1 marker, moved by (99|100)\\.\\d mm, 0\\.\\d\\d°$"));
    }

    [Test]
    public void Place_Locked_MovesImmediatelyAndStays()
    {
        PlayLocked();

        _anchor.Place(new Vector3(1, 2, 3), Quaternion.identity);
        _cell.Run(3, _session);

        Assert.That(_anchor.transform.position, Is.EqualTo(new Vector3(1, 2, 3)));
        Assert.That(_anchor.State, Is.EqualTo(BaseAnchorState.Placed));
    }

    [Test]
    public void Device_HoldsAnchors_ReceivesTheLockAndIsFollowed()
    {
        var device = new GameObject("Anchors").AddComponent<FakeSpatialAnchors>();
        device.transform.SetParent(_session.transform);
        PlayLocked();
        Assert.That(device.KeptAs, Is.EqualTo("cell 7"));
        var there = RigidTransform.FromXyzRpy(0, 0.02, 0, 0, 0, 0) * device.Pose.Value;
        _markers.Base = there;

        device.Pose = there;
        _cell.Run(2, _session);

        Assert.That(OffFrom(there).Metres, Is.LessThan(1e-4));
        Assert.That(_anchor.State, Is.EqualTo(BaseAnchorState.Locked));
        device.State = SpatialAnchorState.Lost;
        _cell.Run(0.1, _session);
        Assert.That(_anchor.State, Is.EqualTo(BaseAnchorState.Lost));
        Assert.That(Look().Words, Is.EqualTo("base lost"));
    }

    [Test]
    public void Device_KeptTheBase_IsRestoredUntilAMarkerConfirms()
    {
        var device = _session.gameObject.AddComponent<FakeSpatialAnchors>();
        (device.KeptAs, device.Pose) = ("cell 7", Base);
        _markers.IsBlind = true;
        PlayOne();

        _cell.Run(5, _session);

        Assert.That(_anchor.State, Is.EqualTo(BaseAnchorState.Restored));
        Assert.That(OffFrom(Base).Metres, Is.LessThan(1e-6));
        Assert.That(Look(), Is.EqualTo((0.2f, 1f, "base not confirmed")));
        _markers.IsBlind = false;
        _cell.Run(3, _session);
        Assert.That(_anchor.State, Is.EqualTo(BaseAnchorState.Locked));
    }

    [Test]
    public void Look_BaseUncertain_IsStripedWithWords()
    {
        _markers.IsBlind = true;
        PlayOne();
        _cell.Run(5, _session);
        Assert.That(Look(), Is.EqualTo((0.8f, 1f, "base not locked")));

        _markers.IsBlind = false;
        _cell.Run(3, _session);
        Assert.That(Look(), Is.EqualTo((0f, 0f, "")), "locked");
        _markers.Base = Base * RigidTransform.FromXyzRpy(0.1, 0, 0, 0, 0, 0);
        _cell.Run(1, _session);
        Assert.That(Look(), Is.EqualTo((0.5f, 1f, "base or marker moved")));
        _cell.IsPlantUp = false;
        _cell.Run(3, _session);

        Assert.That(Look().Words, Is.EqualTo("held, base or marker moved"));
    }

    [Test]
    public void Panel_OfTheCell_ShowsTheBase()
    {
        PlayLocked();
        var texts = _session.GetComponentInChildren<StatusPanel>().GetComponentsInChildren<TextMesh>();
        string Text(string name) => texts.Single(text => text.name == name).text;

        Assert.That(Text("Base 0"), Is.EqualTo("Base"));
        Assert.That(Text("Base 1"), Is.EqualTo("locked"));
        Assert.That(Text("Base 2"), Does.Match("^spread (0\\.9|1\\.0) mm 0\\.2°$"));
        _markers.Base = Base * RigidTransform.FromXyzRpy(0.1, 0, 0, 0, 0, 0);
        _cell.Run(2, _session);

        Assert.That(Text("Base 1"), Is.EqualTo("! moved"));
        Assert.That(Text("Base 2"), Is.EqualTo("100 mm off"));
        Assert.That(Text("Message 0"), Does.Match("^! base: marker 'a', (99|100|101) mm, "));
    }

    [Test]
    public void Hand_MovesAMarker_BaseFollowsAndLocksOnRelease()
    {
        _markers.Markers.Clear();
        var hand = new GameObject("Hand").AddComponent<HandPlacedMarker>();
        hand.transform.SetParent(_session.transform);
        _session.gameObject.SetActive(true);
        _cell.Run(5, _session);
        Assert.That(_anchor.State, Is.EqualTo(BaseAnchorState.Placed), "it has not been moved");

        hand.BeginMove();
        hand.transform.SetPositionAndRotation(new Vector3(0.4f, 1, 2), Quaternion.Euler(0, 30, 0));
        _cell.Run(0.1, _session);
        Assert.That(_anchor.transform.position, Is.EqualTo(new Vector3(0.4f, 1, 2)).Using<Vector3>((a, b) => Vector3.Distance(a, b) < 1e-5));
        Assert.That(Look(), Is.EqualTo((0.2f, 1f, "being placed")));
        hand.EndMove();
        _cell.Run(0.1, _session);

        Assert.That(_anchor.State, Is.EqualTo(BaseAnchorState.Locked));
        Assert.That(Quaternion.Angle(_anchor.transform.rotation, Quaternion.Euler(0, 30, 0)), Is.LessThan(0.01));
        Assert.That(Look(), Is.EqualTo((0f, 0f, "")));
    }

    [Test]
    public void Hand_NotHeld_IsAtTheMarkersPlace()
    {
        var hand = new GameObject("Hand").AddComponent<HandPlacedMarker>().With("_payload", "a");
        hand.transform.SetParent(_session.transform);

        PlayLocked();

        var expected = UnityPoses.ToWorld(Base * InBase);
        Assert.That(Vector3.Distance(hand.transform.position, expected.position), Is.LessThan(0.001));
        hand.BeginMove();
        _cell.Run(0.1, _session);
        hand.EndMove();
        _cell.Run(0.1, _session);
        Assert.That(OffFrom(Base).Metres, Is.LessThan(0.001), "it was not moved");
        Assert.That(_anchor.Tracker.Lock.Markers, Is.EqualTo(0), "by hand");
    }

    [Test]
    public void Source_AddedOrRemoved_IsUsedOrReleased()
    {
        UnityEngine.Object.DestroyImmediate(_markers);
        PlayOne();
        _cell.Run(2, _session);
        var late = new GameObject("Late").AddComponent<FakeMarkers>();
        late.transform.SetParent(_session.transform);
        (late.Clock, late.Base) = (_cell.Clock, Base);
        late.Markers["a"] = InBase;

        _cell.Run(3.2, _session);
        Assert.That(_anchor.State, Is.EqualTo(BaseAnchorState.Locked));
        UnityEngine.Object.Destroy(late.gameObject);
        _cell.Run(2, _session);

        Assert.That(_anchor.State, Is.EqualTo(BaseAnchorState.Locked));
        Assert.That(_cell.Player.Logs.Where(log => log.Type == LogType.Exception), Is.Empty);
    }

    [Test]
    public void Fields_Invalid_AreLoggedOnce()
    {
        Play(new AnchorMarker("a", Vector3.zero, Vector3.zero, sizeMetres: 9));
        _cell.Run(1, _session);
        _anchor.enabled = false;
        _anchor.enabled = true;
        _cell.Run(1, _session);

        Assert.That(_anchor.Words, Is.EqualTo("marker 'a': its size: 9 m is out of range; allowed are 0.005 to 5 m"));
        Assert.That(Logged.Distinct(), Is.EqualTo(new[] { "[Nowpose] base anchor 'Base Anchor': " + _anchor.Words }));
        Assert.That(_session.Frame, Is.Not.Null, "all else goes on");
    }

    [Test]
    public void Rows_OfTheInspector_ShowLockDeviceAndMarkers()
    {
        _session.gameObject.AddComponent<FakeSpatialAnchors>();
        PlayLocked();
        _markers.IsBlind = true;
        _cell.Run(1, _session);

        var rows = BaseRows.Of(_anchor.Tracker).Select(row => row.Label + ": " + row.Value).ToList();

        Assert.That(rows, Has.Some.Match("^Spread: (0.9|1.0)\\d mm, 0.2\\d°$"));
        Assert.That(rows, Does.Contain("Held by the device: yes, kept as cell 7"));
        Assert.That(rows, Does.Contain("Moved by the newest lock: 0.00 mm, 0.00°"));
        Assert.That(rows, Does.Contain("a: ignored: too old"));
        Assert.That(rows, Has.Some.Match("^  Sightings: 1[12]\\d; ignored: 1 too old$"));
        Assert.That(rows, Has.Some.Match("^  Off by: 0\\.\\d\\d mm, 0\\.\\d\\d°$"));
    }

    [Test]
    public void Frame_LockedWithMarkersInView_AllocatesNothing([Values] bool isMoved)
    {
        _session.gameObject.AddComponent<FakeSpatialAnchors>();
        PlayLocked();
        if (isMoved) _markers.Markers["a"] = InBase * RigidTransform.FromXyzRpy(0, 0, 0.05, 0, 0, 0);
        _cell.Run(25, _session);

        var allocated = _cell.AllocatedIn(() => _cell.Run(10, _session));

        Assert.That(_anchor.State, Is.EqualTo(isMoved ? BaseAnchorState.Moved : BaseAnchorState.Locked));
        Assert.That(allocated, isMoved ? Is.LessThan(5000) : Is.EqualTo(0), "bytes in 10 s; a text with another number costs some");
    }
}
