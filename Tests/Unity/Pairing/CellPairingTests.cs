using Nowpose.Anchoring;
using Nowpose.Messages;
using Nowpose.Network;
using Nowpose.Pairing;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using NUnit.Framework;
using UnityEngine;
using static Nowpose.Unity.Tests.Pairing.PlayedPairing;

namespace Nowpose.Unity.Tests.Pairing;

/// <summary>Tests the pairing component in a running scene.</summary>
public class CellPairingTests
{
    PlayedPairing _played;

    [SetUp]
    public void Start() => _played = new PlayedPairing();

    [TearDown]
    public void Stop() => _played.Dispose();

    [Test]
    public void Marker_OfAnUnknownGateway_AsksWithoutConnecting()
    {
        var before = _played.Session.Settings;
        var asked = 0;
        _played.Pairing.Changed += () => asked += _played.Pairing.Question != null ? 1 : 0;
        _played.Shown.Texts.Add(Desk);

        _played.Frames(10);

        Assert.That(_played.Pairing.Question, Does.Contain("'desk'").And.Contain("127.0.0.1"));
        Assert.That(_played.Pairing.Words, Is.EqualTo(_played.Pairing.Question));
        Assert.That(asked, Is.EqualTo(1));
        Assert.That(_played.Session.Settings, Is.SameAs(before));
        Assert.That(_played.Session.Session.SampleLink.State, Is.EqualTo(LinkState.Idle));
        Assert.That(_played.Anchor.Cell, Is.Empty);
    }

    [Test]
    public void Accept_Question_ConfiguresSessionAndAnchor()
    {
        var before = _played.Session.Settings;
        _played.Shown.Texts.Add(Desk);
        _played.Frames();

        _played.Pairing.Accept();
        _played.Frames();

        Assert.That(_played.Pairing.Question, Is.Null);
        Assert.That(_played.Pairing.Cell, Is.EqualTo("desk"));
        Assert.That(_played.Session.Settings.Connection.SyncPort, Is.EqualTo(1));
        Assert.That(_played.Session.Settings.Visualisation, Is.EqualTo(before.Visualisation), "the other settings are unchanged");
        Assert.That(_played.Session.Session.SampleLink.State, Is.Not.EqualTo(LinkState.Idle));
        Assert.That(_played.Anchor.Cell, Is.EqualTo("desk"));
        Assert.That(_played.Anchor.State, Is.EqualTo(BaseAnchorState.Searching));
    }

    [Test]
    public void Call_WhileDisabled_IsLoggedOnce()
    {
        var calls = new Action[]
        {
            _played.Pairing.Accept, _played.Pairing.Refuse, _played.Pairing.AskToForget, _played.Pairing.Forget, () => _played.Pairing.ReadCode("code"),
        };
        foreach (var call in calls)
        {
            _played.Pairing.enabled = true;
            _played.Pairing.enabled = false;
            call();
            call();
        }

        Assert.That(_played.Cell.Messages, Has.Exactly(calls.Length).Contains(ComponentMessages.PairingDisabled));
    }

    [Test]
    public void Accept_GatewayOnAnotherMachine_WaitsForItsCode()
    {
        _played.Shown.Texts.Add(Press);
        _played.Frames();

        _played.Pairing.Accept();
        _played.Frames();

        Assert.That(_played.Pairing.Words, Is.EqualTo(PairingMessages.LookAtCode("press")));
        Assert.That(_played.Session.Session.SampleLink.State, Is.EqualTo(LinkState.Idle));
        Assert.That(_played.Anchor.Cell, Is.EqualTo("press"), "the marker may be looked for already");
    }

    [Test]
    public void Refuse_Question_DoesNotAskAgain()
    {
        _played.Shown.Texts.Add(Desk);
        _played.Frames();

        _played.Pairing.Refuse();
        _played.Frames(10);

        Assert.That(_played.Pairing.Question, Is.Null);
        Assert.That(_played.Pairing.Cell, Is.Null);
    }

    [Test]
    public void Restart_PairedCell_ConnectsWithoutAMarker()
    {
        _played.Shown.Texts.Add(Desk);
        _played.Frames();
        _played.Pairing.Accept();
        _played.Frames();

        _played.RestartPlaying();
        _played.Frames();

        Assert.That(_played.Pairing.Cell, Is.EqualTo("desk"));
        Assert.That(_played.Session.Settings.Connection.SyncPort, Is.EqualTo(1));
        Assert.That(_played.Session.Session.SampleLink.State, Is.Not.EqualTo(LinkState.Idle));
        Assert.That(_played.Anchor.Cell, Is.EqualTo("desk"));
    }

    [Test]
    public void Session_MarkerOfThePairedCellSeenAgain_IsNotRestarted()
    {
        _played.Shown.Texts.Add(Desk);
        _played.Frames();
        _played.Pairing.Accept();
        _played.Frames();
        var running = _played.Session.Session;

        _played.Frames(10);
        _played.Pairing.enabled = false;
        _played.Pairing.enabled = true;
        _played.Frames(10);

        Assert.That(_played.Session.Session, Is.SameAs(running));
    }

    [Test]
    public void Forget_PairedCell_DisconnectsAndRemovesIt()
    {
        _played.Shown.Texts.Add(Desk);
        _played.Frames();
        _played.Pairing.Accept();
        _played.Frames();
        _played.Shown.Texts.Clear();

        _played.Pairing.Forget();
        _played.Frames();

        Assert.That(_played.Pairing.Cell, Is.Null);
        Assert.That(_played.Anchor.Cell, Is.Empty);
        Assert.That(File.ReadAllText(_played.FilePath), Does.Not.Contain("desk"));
        _played.RestartPlaying();
        _played.Frames();
        Assert.That(_played.Pairing.Cell, Is.Null);
    }

    [Test]
    public void Forget_PairedCell_PlacesTheBaseAsBefore()
    {
        var before = _played.Anchor.transform.position;
        _played.Shown.Texts.Add(Desk);
        _played.Frames();
        _played.Pairing.Accept();
        _played.Frames();
        _played.Anchor.transform.position = Vector3.one;

        _played.Pairing.Forget();
        _played.Frames();

        Assert.That(_played.Anchor.transform.position, Is.EqualTo(before));
        Assert.That(_played.Anchor.State, Is.EqualTo(BaseAnchorState.Placed));
    }

    [Test]
    public void Accept_SettingsThatPublishNothing_StillPublishNothing()
    {
        _played.Session.Settings = _played.Session.Settings.With(new ConnectionSettings("127.0.0.1", 1, 1, publishesDisplayed: false));
        _played.Shown.Texts.Add(Desk);
        _played.Frames();

        _played.Pairing.Accept();
        _played.Frames();

        Assert.That(_played.Pairing.Cell, Is.EqualTo("desk"));
        Assert.That(_played.Session.Settings.Connection.PublishesDisplayed, Is.False);
    }

    [Test]
    public void File_Damaged_IsReportedAndRenamed()
    {
        File.WriteAllText(_played.FilePath, "{\"format\":");

        _played.RestartPlaying();
        _played.Frames();

        Assert.That(_played.Pairing.Problem, Does.Contain(_played.FilePath + ".bad"));
        Assert.That(_played.Cell.Messages.Count(m => m.Contains(".bad")), Is.EqualTo(1));
        Assert.That(File.ReadAllText(_played.FilePath + ".bad"), Is.EqualTo("{\"format\":"));
    }

    [Test]
    public void Frames_WithoutChanges_DoNotAllocate()
    {
        _played.Shown.Texts.AddRange([Desk, Press, "https://example.org/", "nowpose:cell/1?n=a"]);
        _played.Frames();
        _played.Pairing.Refuse();
        _played.Frames(300);
        _played.Pairing.Refuse();
        _played.Frames(300);
        var with = Measured();
        _played.Pairing.enabled = false;
        _played.Frames(60);

        // Subtracts the allocations of the stand-in engine, which are the same without the component. The rest is the search for marker sources.
        Assert.That(with - Measured(), Is.LessThan(600 * 8));
    }

    long Measured() => _played.Cell.AllocatedIn(() => _played.Frames(600));

    [Test]
    public void Session_Missing_IsLogged()
    {
        _played.Cell.Frame(null);

        new GameObject("Alone").AddComponent<CellPairing>();

        Assert.That(_played.Cell.Messages, Has.Some.Contains(ComponentMessages.NoSession));
    }

    [Test]
    public void Code_SecondOfThePairedCell_IsAlsoAMarkerOfTheBase()
    {
        var second = new CellCode("desk", "127.0.0.1", null, MarkerOffset.Parse("0.7,0,0", ""), 0.1, 1, 1).Text;
        _played.Shown.Texts.Add(Desk);
        _played.Frames();
        _played.Pairing.Accept();
        _played.Frames();
        Assert.That(_played.Anchor.Tracker.Has(second), Is.False);

        _played.Shown.Texts.Add(second);
        _played.Frames();

        Assert.That((_played.Anchor.Tracker.Has(Desk), _played.Anchor.Tracker.Has(second)), Is.EqualTo((true, true)));
    }

    [Test]
    public void Forget_PairedCell_RestoresTheSettingsUntilItIsPairedAgain()
    {
        var asset = ScriptableObject.CreateInstance<SessionSettingsAsset>();
        _played.Session.With("_settings", asset);
        var port = asset.ToSettings().Connection.SyncPort;
        int Port() => _played.Session.Settings.Connection.SyncPort;
        void Pair()
        {
            // A text that is repeated at once is the code that is still in view.
            _played.Frames(300);
            _played.Pairing.ReadCode(Desk);
            _played.Frames();
            _played.Pairing.Accept();
            _played.Frames();
        }
        Pair();

        _played.Pairing.Forget();
        _played.Frames();
        Assert.That((Port(), _played.Session.IsConnecting), Is.EqualTo((port, false)));

        Pair();
        Assert.That((Port(), _played.Session.IsConnecting), Is.EqualTo((1, true)));
    }
}
