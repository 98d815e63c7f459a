using Nowpose.Anchoring;
using Nowpose.Editor.Inspectors;
using Nowpose.Editor.Setup;
using Nowpose.Kinematics;
using Nowpose.Unity;
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

        Assert.That(_played.Anchor.Words, Is.EqualTo("looking for markers; no AR Session is in the scene"));
        _played.Markers.enabled = false;
        _played.Cell.Run(12, _played.Session);
        Assert.That(_played.Anchor.Words, Is.EqualTo("looking for markers; allow access to the camera if it is blocked"));
    }

    [Test]
    public void Use_AfterInvalidFields_ClearsTheProblem()
    {
        _played.Play(new AnchorMarker("", Vector3.zero, Vector3.zero));
        Assert.That(_played.Anchor.Words, Does.StartWith("marker"));

        _played.Anchor.Use("cell", [new BaseMarker("a", InBase)]);
        _played.Cell.Run(3, _played.Session);

        Assert.That(_played.Anchor.Words, Is.EqualTo("locked by 1 marker"));
    }

    [Test]
    public void Markers_SeenObliquely_AreIgnoredWithTheReason()
    {
        _played.PlayOne();
        var pose = UnityPoses.ToWorld(Base);
        _played.Head.SetPositionAndRotation(pose.position + new Vector3(0, 0.1f, -1), Quaternion.identity);

        _played.Cell.Run(3, _played.Session);

        Assert.That(_played.Anchor.State, Is.EqualTo(BaseAnchorState.Searching));
        Assert.That(_played.Anchor.Words, Is.EqualTo("marker 'a' is seen too obliquely: stand in front of it"));
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
            _played.Anchor.Words, Does.Match("^marker 'a' is (49|50|51) mm, 0\\.\\d° from its expected position: put it back, or lock again$"));
        Assert.That(_played.Anchor.transform.position, Is.EqualTo(before));
        var said = _played.Cell.Player.Logs.Where(log => log.Message.Contains("from its expected position")).ToList();
        Assert.That(said.Select(log => log.Type), Is.EqualTo(new[] { LogType.Warning }), "once");
    }

    [Test]
    public void Look_BaseUncertain_HasStripesAndStatesTheReason()
    {
        _played.Markers.IsBlind = true;
        _played.PlayOne();
        _played.Cell.Run(5, _played.Session);
        Assert.That(_played.Look(), Is.EqualTo((0.8f, 1f, "base not locked")));

        _played.Markers.IsBlind = false;
        _played.Cell.Run(3, _played.Session);
        Assert.That(_played.Look(), Is.EqualTo((0f, 0f, "")), "locked");
        _played.Markers.Base = Base * RigidTransform.FromXyzRpy(0.1, 0, 0, 0, 0, 0);
        _played.Cell.Run(1, _played.Session);
        Assert.That(_played.Look(), Is.EqualTo((0.5f, 1f, "base or marker moved")));
        _played.Cell.IsPlantUp = false;
        _played.Cell.Run(3, _played.Session);

        Assert.That(_played.Look().Words, Is.EqualTo("held, base or marker moved"));
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
        Assert.That(Text("Base 2"), Is.EqualTo("100 mm off"));
        Assert.That(Text("Message 0"), Does.Match("^! base: marker 'a' is (99|100|101) mm, "));
    }

    [Test]
    public void Fields_Invalid_AreLoggedOnce()
    {
        _played.Play(new AnchorMarker("a", Vector3.zero, Vector3.zero, sizeMetres: 9));
        _played.Cell.Run(1, _played.Session);
        _played.Anchor.enabled = false;
        _played.Anchor.enabled = true;
        _played.Cell.Run(1, _played.Session);

        Assert.That(_played.Anchor.Words, Is.EqualTo("marker 'a': its size: 9 m is out of range; allowed: 0.005 to 5 m"));
        Assert.That(_played.Logged.Distinct(), Is.EqualTo(new[] { "[Nowpose] base anchor 'Base Anchor': " + _played.Anchor.Words }));
        Assert.That(_played.Session.Frame, Is.Not.Null, "the session continues");
    }

    [Test]
    public void InspectorRows_BaseLocked_ShowLockDeviceAnchorAndMarkers()
    {
        _played.Session.gameObject.AddComponent<FakeSpatialAnchors>();
        _played.PlayLocked();
        _played.Markers.IsBlind = true;
        _played.Cell.Run(1, _played.Session);

        var rows = BaseRows.Of(_played.Anchor.Tracker).Select(row => row.Label + ": " + row.Value).ToList();

        Assert.That(rows, Has.Some.Match("^Spread: (0.9|1.0)\\d mm, 0.2\\d°$"));
        Assert.That(rows, Does.Contain("Held by the device: yes, kept as cell 7"));
        Assert.That(rows, Does.Contain("Moved by the newest lock: 0.00 mm, 0.00°"));
        Assert.That(rows, Does.Contain("a: ignored: too old"));
        Assert.That(rows, Has.Some.Match("^  Sightings: 1[12]\\d; ignored: 1 too old$"));
        Assert.That(rows, Has.Some.Match("^  Off by: 0\\.\\d\\d mm, 0\\.\\d\\d°$"));
    }
}
