using Nowpose.Frames;
using Nowpose.Protocol.Cell;
using Nowpose.Session;
using Nowpose.Unity.Messages;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests;

public class PlayedStationaryObjectTests : PlayedParts
{
    [Test]
    public void StationaryObject_InvalidName_IsReportedOnceAndKeepsTheSavedPlaces()
    {
        var file = Path.Combine(_folder, "stationary-objects.json");
        StationaryFrameFile.Save(file, new TransformsMessage(Along(2).ToTransform(default, "world", "other")));
        var before = File.ReadAllText(file);
        var wrong = Below<StationaryObject>(new string('x', 129), _session.transform);
        Run(0.5);

        wrong.BeginMove();
        Run(0.5);
        wrong.EndMove();

        Assert.That(File.ReadAllText(file), Is.EqualTo(before));
        Assert.That(wrong.Fault, Is.EqualTo(ObjectMessages.InvalidFrame(wrong.name)));
        Assert.That(_cell.Player.Logs.Count(log => log.Type == LogType.Error), Is.EqualTo(1));
    }

    [Test]
    public void StationaryObject_RenamedAtRunTime_IsSavedUnderTheNameOfItsFrame()
    {
        var fixture = Below<StationaryObject>("fixture", _session.transform).With("_fileName", "");
        Run(0.5);
        fixture.name = "renamed";

        fixture.BeginMove();
        Run(0.1);
        fixture.EndMove();

        Assert.That(fixture.Frame, Is.EqualTo("fixture"));
        Assert.That(StationaryFrameFile.Load(Path.Combine(_folder, "stationary-objects.json"))[0].Child, Is.EqualTo("fixture"));
    }

    // Each would replace the saved place of the other.
    [TestCase("", "", 1)]
    [TestCase("conveyor", "", 0)]
    [TestCase("", "other.json", 0)]
    public void StationaryObjects_SameFrameInTheSameFile_AreReportedOnce(string frame, string file, int expected)
    {
        Below<StationaryObject>("fixture", _session.transform);
        var other = Below<FrameProbe>("fixture", _session.transform).gameObject;
        other.SetActive(false);
        other.AddComponent<StationaryObject>().With("_frame", frame).With("_fileName", file);
        other.SetActive(true);
        Run(0.5);

        Assert.That(_cell.Messages, Has.Exactly(expected).Contains(ObjectMessages.SameFrame("fixture", "fixture")));
    }

    [Test]
    public void StationaryObject_FrameOfATrackedObject_IsNotReported()
    {
        Below<TrackedObject>("fixture", _session.transform);
        Below<StationaryObject>("fixture", _session.transform);
        Run(0.5);

        Assert.That(_cell.Messages, Has.None.Contains(ObjectMessages.SameFrame("fixture", "fixture")), "a tracked object has no saved place");
    }

    [Test]
    public void StationaryObject_PlacedByHand_StaysSavedAndCarriesItsChildren()
    {
        var anchor = Below<BaseAnchor>("Base Anchor", _session.transform);
        anchor.transform.position = new Vector3(1, 2, 3);
        var fixture = Below<StationaryObject>("fixture", anchor.transform);
        var lid = Below<TrackedObject>("lid", anchor.transform);
        void Send(double t) => SendPose("fixture", "lid", t, Along(0.05));
        Run(1, Send);
        Assert.That(FaultsNow(), Does.Contain("object fixture: " + ObjectMessages.NotPlaced));
        var look = fixture.GetComponent<PoseAppearance>().Look;
        Assert.That((look.Label, look.IsDrawn, look.IsHatched), Is.EqualTo((StatusMessages.NotPlaced, true, true)));

        fixture.BeginMove();
        fixture.transform.SetPositionAndRotation(new Vector3(2, 2.5f, 3), Quaternion.Euler(0, 30, 0));
        Run(0.5, Send);
        fixture.EndMove();
        Run(0.5, Send);

        Assert.That((fixture.State, fixture.IsMoving, lid.State), Is.EqualTo((PoseState.Current, false, PoseState.Current)));
        Assert.That(Vector3.Distance(fixture.transform.position, new Vector3(2, 2.5f, 3)), Is.LessThan(1e-5));
        AssertAt(lid.transform, fixture.transform, Along(0.05));
        Assert.That(fixture.GetComponent<PoseAppearance>().Look.IsHatched, Is.False);

        // Simulates a new run of the application, with the base in another place.
        var place = anchor.transform.InverseTransformPoint(fixture.transform.position);
        _cell.Dispose();
        Begin();
        anchor = Below<BaseAnchor>("Base Anchor", _session.transform);
        anchor.transform.position = new Vector3(-4, 0, 1);
        fixture = Below<StationaryObject>("fixture", anchor.transform);
        Run(0.5);
        Assert.That(fixture.State, Is.EqualTo(PoseState.Current));
        Assert.That(Vector3.Distance(anchor.transform.InverseTransformPoint(fixture.transform.position), place), Is.LessThan(1e-5));
    }

    [Test]
    public void StationaryObject_BaseAnchorDestroyedDuringAMove_IsHeldAndNotSaved()
    {
        var anchor = Below<BaseAnchor>("Base Anchor", _session.transform);
        var fixture = Loose<StationaryObject>("fixture");
        fixture.Follow(_session);
        Run(0.5);
        fixture.BeginMove();
        Run(0.5);

        UnityEngine.Object.Destroy(anchor.gameObject);
        Run(0.5);
        fixture.EndMove();
        Run(0.5);

        Assert.That((fixture.State, fixture.Fault, File.Exists(fixture.SavedPath)), Is.EqualTo((PoseState.Held, BaseMessages.Destroyed, false)));
        Assert.That(_cell.Player.Logs.Where(log => log.Exception != null), Is.Empty);
    }

    [Test]
    public void StationaryObject_SourcePublishesItsFrame_ReplacesTheHandPlacedPose()
    {
        StationaryFrameFile.Save(Path.Combine(_folder, "stationary-objects.json"), new TransformsMessage(
            Along(1).ToTransform(default, "world", "fixture"), Along(2).ToTransform(default, "world", "other")));
        var fixture = Below<StationaryObject>("fixture", _session.transform);
        Run(0.5);
        AssertAt(fixture.transform, _session.transform, Along(1));

        _session.Session.Listener.FramesReceived(
            new TransformsMessage(Along(3).ToTransform(default, "world", "fixture")), true, HeadsetTime.FromSeconds(1000 + _cell.Now));
        Run(0.5);
        AssertAt(fixture.transform, _session.transform, Along(3));

        fixture.BeginMove();
        fixture.transform.position = new Vector3(7, 0, 0);
        Run(0.2);
        fixture.EndMove();
        Run(0.2);
        Assert.That(fixture.transform.position.x, Is.EqualTo(7).Within(1e-5));
        var saved = StationaryFrameFile.Load(fixture.SavedPath);
        Assert.That(new[] { saved[0].Child, saved[1].Child }, Is.EqualTo(new[] { "other", "fixture" }), "the places of other objects are kept");
    }

    [Test]
    public void StationaryObject_MovedByItsSource_CannotBePlaced()
    {
        var fixture = Below<StationaryObject>("box", _session.transform);
        Run(2, t => SendPose("world", "box", t, Along(0.1 * t)));

        fixture.BeginMove();

        Assert.That(fixture.IsMoving, Is.False);
        Assert.That(_cell.Messages, Has.Exactly(1).Contains(ObjectMessages.NotPlaceable("box")));
    }

    [Test]
    public void StationaryObject_InvalidFile_IsRenamedAndReported()
    {
        var path = Path.Combine(_folder, "stationary-objects.json");
        File.WriteAllText(path, "{");
        Below<StationaryObject>("fixture", _session.transform);

        Run(0.1);

        Assert.That(_cell.Messages, Has.Exactly(1).Matches(ObjectMessages.PlacesLost("stationary-objects.json, line 1: .*", ".*")));
        Assert.That((File.Exists(path), File.Exists(path + ".bad")), Is.EqualTo((false, true)));
    }

    // The place is relative to the base of the cell, so it is wrong for another robot.
    [Test]
    public void StationaryObject_PlacedByHandInOneCell_IsNotPlacedInAnother()
    {
        var anchor = Below<BaseAnchor>("Base", _session.transform).With("_cell", "desk 1");
        var belt = Below<StationaryObject>("belt", anchor.transform);
        Run(0.5);
        belt.BeginMove();
        belt.transform.position = new Vector3(1, 0, 2);
        Run(0.1);
        belt.EndMove();
        Run(0.1);
        Assert.That(belt.State, Is.EqualTo(PoseState.Current));

        anchor.Use("press/2", System.Array.Empty<Nowpose.Anchoring.BaseMarker>());
        _session.Restart();
        Run(0.5);
        Assert.That((belt.State, belt.Fault, Path.GetFileName(belt.SavedPath)),
            Is.EqualTo((PoseState.Incomplete, ObjectMessages.NotPlaced, "stationary-objects-press%2F2.json")));

        anchor.Use("desk 1", System.Array.Empty<Nowpose.Anchoring.BaseMarker>());
        _session.Restart();
        Run(0.5);
        Assert.That(belt.State, Is.EqualTo(PoseState.Current));
    }

    [Test]
    public void StationaryObject_FileNotReadable_KeepsTheSavedPlaces()
    {
        var file = Path.Combine(_folder, "stationary-objects.json");
        StationaryFrameFile.Save(file, new TransformsMessage(Along(2).ToTransform(default, "world", "other")));
        var before = File.ReadAllText(file);
        var belt = Below<StationaryObject>("belt", _session.transform);
        using (new FileStream(file, FileMode.Open, FileAccess.ReadWrite, FileShare.None))
        {
            Run(0.5);
            belt.BeginMove();
            Run(0.1);
            belt.EndMove();
        }

        Assert.That(File.ReadAllText(file), Is.EqualTo(before));
        Assert.That(_cell.Messages, Has.Exactly(1).EqualTo("[Nowpose] " + ObjectMessages.PlaceNotSaved("belt", file)));
    }

    // Two cells of one gateway: the connection stays, but the base is another one.
    [Test]
    public void StationaryObject_OtherCellOfTheGateway_IsNotPlaced()
    {
        static string Code(string cell) =>
            new Nowpose.Pairing.CellCode(cell, "127.0.0.1", null, Nowpose.Pairing.MarkerOffset.Parse("0.5,0,0", ""), 0.1, 1, 1).Text;
        var pairing = _session.gameObject.AddComponent<CellPairing>();
        var anchor = Below<BaseAnchor>("Base", _session.transform);
        var belt = Below<StationaryObject>("belt", anchor.transform);
        void Pair(string cell)
        {
            pairing.ReadCode(Code(cell));
            Run(0.1);
            pairing.Accept();
            Run(1.5);
            Assert.That((pairing.Cell, anchor.Cell), Is.EqualTo((cell, cell)));
        }
        Run(0.1);
        Pair("desk");
        belt.BeginMove();
        Run(0.1);
        belt.EndMove();
        Run(0.1);

        Pair("press");

        Assert.That(belt.Fault, Is.EqualTo(ObjectMessages.NotPlaced));
    }

    // Unity disables the parents first.
    [Test]
    public void StationaryObject_SwitchedOffDuringAMove_IsSavedForItsCell()
    {
        var anchor = Below<BaseAnchor>("Base", _session.transform).With("_cell", "desk");
        var belt = Below<StationaryObject>("belt", anchor.transform);
        Run(0.5);
        belt.BeginMove();
        Run(0.1);

        _session.gameObject.SetActive(false);

        Assert.That(Directory.GetFiles(_folder).Select(Path.GetFileName), Is.EqualTo(new[] { "stationary-objects-desk.json" }));
    }

    [Test]
    public void StationaryObject_FileCannotBeWritten_IsLoggedAndStaysPlaced()
    {
        Directory.CreateDirectory(Path.Combine(_folder, "stationary-objects.json"));
        var fixture = Below<StationaryObject>("fixture", _session.transform);
        Run(0.5);

        fixture.BeginMove();
        fixture.transform.position = new Vector3(7, 0, 0);
        Run(0.1);
        fixture.EndMove();
        Run(0.1);

        Assert.That(_cell.Player.Logs.Count(log => log.Type == LogType.Error), Is.EqualTo(1));
        Assert.That((fixture.State, fixture.transform.position.x), Is.EqualTo((PoseState.Current, 7f)));
    }
}
