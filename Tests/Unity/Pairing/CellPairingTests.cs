using Nowpose.Anchoring;
using Nowpose.Network;
using Nowpose.Pairing;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Unity;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Events;

namespace Nowpose.Unity.Tests.Pairing;

/// <summary>The component in a running scene; the ports that it would connect to are closed.</summary>
public class CellPairingTests
{
    static readonly CertificatePin Pin = CertificatePin.Parse(Convert.ToBase64String(new byte[32]));

    // Port 1 is closed.
    static readonly string Desk = new CellCode("desk", "127.0.0.1", null, new MarkerOffset(0.5, 0, 0), 0.1, 1, 1).Text;
    static readonly string Press = new CellCode("press", "127.0.0.1", Pin, new MarkerOffset(0.5, 0, 0), 0.1, 1, 1).Text;

    PlayedCell _cell;
    MrilSession _session;
    CellPairing _pairing;
    BaseAnchor _anchor;
    ShownCodes _shown;
    string _folder;

    [SetUp]
    public void Start()
    {
        _folder = Directory.CreateTempSubdirectory("nowpose-pairing-").FullName;
        _cell = new PlayedCell();
        Play();
    }

    [TearDown]
    public void Stop()
    {
        _cell.Dispose();
        Directory.Delete(_folder, true);
    }

    string FilePath => Path.Combine(_folder, "cells.json");

    void Play()
    {
        _session = _cell.NewSession();
        _pairing = _session.gameObject.AddComponent<CellPairing>().With("_fileName", FilePath);
        _anchor = new GameObject("Base").AddComponent<BaseAnchor>();
        _anchor.transform.SetParent(_session.transform, false);
        _shown = ShownCodes.Below(_session);
        _session.gameObject.SetActive(true);
    }

    void RestartPlaying()
    {
        UnityEngine.Object.Destroy(_session.gameObject);
        _cell.Frame(null);
        Play();
    }

    void Frames(int count = 2)
    {
        for (var i = 0; i < count; i++)
        {
            _shown.Seen = _cell.Clock.Now;
            _cell.Frame(_session);
        }
    }

    [Test]
    public void Marker_OfAnUnknownGateway_AsksWithoutConnecting()
    {
        var before = _session.Settings;
        var asked = 0;
        _pairing.Changed += () => asked += _pairing.Question != null ? 1 : 0;
        _shown.Texts.Add(Desk);

        Frames(10);

        Assert.That(_pairing.Question, Does.Contain("'desk'").And.Contain("127.0.0.1"));
        Assert.That(_pairing.Words, Is.EqualTo(_pairing.Question));
        Assert.That(asked, Is.EqualTo(1));
        Assert.That(_session.Settings, Is.SameAs(before));
        Assert.That(_session.Session.SampleLink.State, Is.EqualTo(LinkState.Idle));
        Assert.That(_anchor.Cell, Is.Empty);
    }

    [Test]
    public void Accept_Question_ConfiguresSessionAndAnchor()
    {
        var before = _session.Settings;
        _shown.Texts.Add(Desk);
        Frames();

        _pairing.Accept();
        Frames();

        Assert.That(_pairing.Question, Is.Null);
        Assert.That(_pairing.Cell, Is.EqualTo("desk"));
        Assert.That(_session.Settings.Connection.SyncPort, Is.EqualTo(1));
        Assert.That(_session.Settings.Visualisation, Is.EqualTo(before.Visualisation), "the rest of the settings stays");
        Assert.That(_session.Session.SampleLink.State, Is.Not.EqualTo(LinkState.Idle));
        Assert.That(_anchor.Cell, Is.EqualTo("desk"));
        Assert.That(_anchor.State, Is.EqualTo(BaseAnchorState.Searching));
    }

    [Test]
    public void Accept_GatewayOnAnotherMachine_WaitsForItsCode()
    {
        _shown.Texts.Add(Press);
        Frames();

        _pairing.Accept();
        Frames();

        Assert.That(_pairing.Words, Does.Contain("look at the code"));
        Assert.That(_session.Session.SampleLink.State, Is.EqualTo(LinkState.Idle));
        Assert.That(_anchor.Cell, Is.EqualTo("press"), "the marker may be looked for already");
    }

    [Test]
    public void Refuse_Question_DoesNotAskAgain()
    {
        _shown.Texts.Add(Desk);
        Frames();

        _pairing.Refuse();
        Frames(10);

        Assert.That(_pairing.Question, Is.Null);
        Assert.That(_pairing.Cell, Is.Null);
    }

    [Test]
    public void Restart_PairedCell_ConnectsWithoutAMarker()
    {
        _shown.Texts.Add(Desk);
        Frames();
        _pairing.Accept();
        Frames();

        RestartPlaying();
        Frames();

        Assert.That(_pairing.Cell, Is.EqualTo("desk"));
        Assert.That(_session.Settings.Connection.SyncPort, Is.EqualTo(1));
        Assert.That(_session.Session.SampleLink.State, Is.Not.EqualTo(LinkState.Idle));
        Assert.That(_anchor.Cell, Is.EqualTo("desk"));
    }

    [Test]
    public void Session_SameCellSeenAgain_IsNotRestarted()
    {
        _shown.Texts.Add(Desk);
        Frames();
        _pairing.Accept();
        Frames();
        var running = _session.Session;

        Frames(10);
        _pairing.enabled = false;
        _pairing.enabled = true;
        Frames(10);

        Assert.That(_session.Session, Is.SameAs(running));
    }

    [Test]
    public void Forget_PairedCell_DisconnectsAndRemovesIt()
    {
        _shown.Texts.Add(Desk);
        Frames();
        _pairing.Accept();
        Frames();
        _shown.Texts.Clear();

        _pairing.Forget();
        Frames();

        Assert.That(_pairing.Cell, Is.Null);
        Assert.That(_anchor.Cell, Is.Empty);
        Assert.That(File.ReadAllText(FilePath), Does.Not.Contain("desk"));
        RestartPlaying();
        Frames();
        Assert.That(_pairing.Cell, Is.Null);
    }

    [Test]
    public void ForgetCell_OfTheActions_AsksAndForgetsIfAccepted()
    {
        var actions = _session.gameObject.AddComponent<CellActions>();
        _shown.Texts.Add(Desk);
        Frames();
        _pairing.Accept();
        Frames();
        _shown.Texts.Clear();

        actions.ForgetCell();
        Frames();
        Assert.That(_pairing.Question, Does.StartWith("Forget cell 'desk'?"));
        Assert.That(_pairing.Cell, Is.EqualTo("desk"));
        _pairing.Accept();
        Frames();

        Assert.That(_pairing.Cell, Is.Null);
        Assert.That(_session.IsConnecting, Is.False);
    }

    [Test]
    public void ForgetCell_NoPairing_IsLogged()
    {
        var actions = _session.gameObject.AddComponent<CellActions>();
        UnityEngine.Object.Destroy(_pairing);
        Frames();

        actions.ForgetCell();

        Assert.That(_cell.Messages, Has.Some.Contains("have no cell pairing; assign one"));
    }

    [Test]
    public void File_Damaged_IsReportedAndRenamed()
    {
        File.WriteAllText(FilePath, "{\"format\":");

        RestartPlaying();
        Frames();

        Assert.That(_pairing.Problem, Does.Contain(FilePath + ".bad"));
        Assert.That(_cell.Messages.Count(m => m.Contains(".bad")), Is.EqualTo(1));
        Assert.That(File.ReadAllText(FilePath + ".bad"), Is.EqualTo("{\"format\":"));
    }

    [Test]
    public void Events_OfQuestionAndProblem_AreRaisedOnce()
    {
        int asked = 0, problems = 0;
        UnityEvent onAsked = new(), onProblem = new();
        onAsked.AddListener(() => asked++);
        onProblem.AddListener(() => problems++);
        _pairing.With("_onAsked", onAsked).With("_onProblem", onProblem);
        _shown.Texts.AddRange([Desk, "nowpose:cell/1?n=a"]);

        Frames(10);

        Assert.That(asked, Is.EqualTo(1));
        Assert.That(problems, Is.EqualTo(1));
    }

    [Test]
    public void Listener_DisablesThePairing_CompletesTheEvent()
    {
        var onAsked = new UnityEvent();
        onAsked.AddListener(() => _pairing.enabled = false);
        _pairing.With("_onAsked", onAsked);
        _shown.Texts.Add(Desk);

        Frames(10);

        Assert.That(_pairing.Question, Is.Null);
        Assert.That(_cell.Player.Logs.Select(log => log.Type), Has.None.EqualTo(LogType.Exception));
    }

    [Test]
    public void Listener_AnchorThrows_PairingCompletes()
    {
        var changes = 0;
        _anchor.StateChanged += () => throw new InvalidOperationException("a listener's own fault");
        _shown.Texts.Add(Desk);
        Frames();
        _pairing.Changed += () => changes++;

        _pairing.Accept();
        Frames();

        Assert.That(File.ReadAllText(FilePath), Does.Contain("desk"));
        Assert.That(changes, Is.GreaterThan(0));
        Assert.That(_session.IsConnecting, Is.True);
    }

    [Test]
    public void Listener_AnchorDisablesThePairing_PairingCompletes()
    {
        _anchor.StateChanged += () => _pairing.enabled = false;
        _shown.Texts.Add(Desk);
        Frames();

        _pairing.Accept();
        Frames();

        Assert.That(File.ReadAllText(FilePath), Does.Contain("desk"));
        Assert.That(_cell.Player.Logs.Select(log => log.Type), Has.None.EqualTo(LogType.Exception));
    }

    [Test]
    public void Code_SeenLongAgo_DoesNotAsk()
    {
        _shown.Texts.Add(Desk);
        _shown.Seen = _cell.Clock.Now - TimeSpan.FromSeconds(10);

        for (var i = 0; i < 10; i++) _cell.Frame(_session);

        Assert.That(_pairing.Question, Is.Null);
    }

    [Test]
    public void Code_NotTracked_DoesNotAsk()
    {
        _shown.Texts.Add(Desk);
        _shown.Tracking = MarkerTracking.None;

        Frames(10);

        Assert.That(_pairing.Question, Is.Null);
    }

    [Test]
    public void Code_Malformed_IsLoggedOnce()
    {
        _shown.Texts.Add("nowpose:cell/1?n=a");
        _shown.Texts.Add("https://example.org/");

        Frames(10);

        Assert.That(_cell.Messages.Where(m => m.Contains("code")), Has.Exactly(1).Items.And.All.Contains("[Nowpose] cell code: h is missing"));
    }

    [Test]
    public void Frames_WithoutChanges_DoNotAllocate()
    {
        _shown.Texts.AddRange([Desk, Press, "https://example.org/", "nowpose:cell/1?n=a"]);
        Frames();
        _pairing.Refuse();
        Frames(300);
        _pairing.Refuse();
        Frames(300);
        var with = Measured();
        _pairing.enabled = false;
        Frames(60);

        // The stand-in's own allocations are the same without the component; a search for sources reuses its list.
        Assert.That(with - Measured(), Is.LessThan(600 * 8));
    }

    long Measured() => _cell.AllocatedIn(() => Frames(600));

    [Test]
    public void Session_Missing_IsLogged()
    {
        _cell.Frame(null);

        new GameObject("Alone").AddComponent<CellPairing>();

        Assert.That(_cell.Messages, Has.Some.Contains("no session on its object or a parent"));
    }
}
