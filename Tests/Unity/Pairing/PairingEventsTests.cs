using Nowpose.Anchoring;
using Nowpose.Messages;
using Nowpose.Pairing;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Events;
using static Nowpose.Unity.Tests.Pairing.PlayedPairing;

namespace Nowpose.Unity.Tests.Pairing;

/// <summary>Tests listeners of the pairing, the action that forgets the cell, and codes that must not start a pairing.</summary>
public class PairingEventsTests
{
    PlayedPairing _played;

    [SetUp]
    public void Start() => _played = new PlayedPairing();

    [TearDown]
    public void Stop() => _played.Dispose();

    [Test]
    public void ForgetCell_CellPaired_AsksAndForgetsIfAccepted()
    {
        var actions = _played.Session.gameObject.AddComponent<CellActions>();
        _played.Shown.Texts.Add(Desk);
        _played.Frames();
        _played.Pairing.Accept();
        _played.Frames();
        _played.Shown.Texts.Clear();

        actions.ForgetCell();
        _played.Frames();
        Assert.That(_played.Pairing.Question, Is.EqualTo(PairingMessages.Forget(CellCode.Parse(Desk))));
        Assert.That(_played.Pairing.Cell, Is.EqualTo("desk"));
        _played.Pairing.Accept();
        _played.Frames();

        Assert.That(_played.Pairing.Cell, Is.Null);
        Assert.That(_played.Session.IsConnecting, Is.False);
    }

    [Test]
    public void ForgetCell_NoPairing_IsLogged()
    {
        var actions = _played.Session.gameObject.AddComponent<CellActions>();
        UnityEngine.Object.Destroy(_played.Pairing);
        _played.Frames();

        actions.ForgetCell();

        Assert.That(_played.Cell.Messages, Has.Some.Contains(ComponentMessages.NoAction(actions.name, "cell pairing")));
    }

    [Test]
    public void Events_QuestionOrProblem_AreRaisedOnce()
    {
        int asked = 0, problems = 0;
        UnityEvent onAsked = new(), onProblem = new();
        onAsked.AddListener(() => asked++);
        onProblem.AddListener(() => problems++);
        _played.Pairing.With("_onAsked", onAsked).With("_onProblem", onProblem);
        _played.Shown.Texts.AddRange([Desk, "nowpose:cell/1?n=a"]);

        _played.Frames(10);

        Assert.That(asked, Is.EqualTo(1));
        Assert.That(problems, Is.EqualTo(1));
    }

    [TestCase("accepted")]
    [TestCase("refused")]
    [TestCase("disabled")]
    public void OnQuestion_QuestionAppearsAndEnds_PassesItsTextAndThenAnEmptyString(string end)
    {
        var shown = new List<string>();
        var onQuestion = new UnityEvent<string>();
        onQuestion.AddListener(shown.Add);
        _played.Pairing.With("_onQuestion", onQuestion);
        _played.Shown.Texts.Add(Desk);
        _played.Frames(10);
        var question = _played.Pairing.Question;

        if (end == "accepted") _played.Pairing.Accept();
        else if (end == "refused") _played.Pairing.Refuse();
        else _played.Pairing.enabled = false;
        _played.Frames(10);

        Assert.That(question, Is.Not.Empty);
        Assert.That(shown, Is.EqualTo(new[] { question, "" }));
    }

    [Test]
    public void Listener_DisablesThePairing_EventCompletes()
    {
        var onAsked = new UnityEvent();
        onAsked.AddListener(() => _played.Pairing.enabled = false);
        _played.Pairing.With("_onAsked", onAsked);
        _played.Shown.Texts.Add(Desk);

        _played.Frames(10);

        Assert.That(_played.Pairing.Question, Is.Null);
        Assert.That(_played.Cell.Player.Logs.Select(log => log.Type), Has.None.EqualTo(LogType.Exception));
    }

    [Test]
    public void AnchorListener_Throws_PairingCompletes()
    {
        var changes = 0;
        _played.Anchor.StateChanged += () => throw new InvalidOperationException("a listener's own fault");
        _played.Shown.Texts.Add(Desk);
        _played.Frames();
        _played.Pairing.Changed += () => changes++;

        _played.Pairing.Accept();
        _played.Frames();

        Assert.That(File.ReadAllText(_played.FilePath), Does.Contain("desk"));
        Assert.That(changes, Is.GreaterThan(0));
        Assert.That(_played.Session.IsConnecting, Is.True);
    }

    [Test]
    public void AnchorListener_DisablesThePairing_PairingCompletes()
    {
        _played.Anchor.StateChanged += () => _played.Pairing.enabled = false;
        _played.Shown.Texts.Add(Desk);
        _played.Frames();

        _played.Pairing.Accept();
        _played.Frames();

        Assert.That(File.ReadAllText(_played.FilePath), Does.Contain("desk"));
        Assert.That(_played.Cell.Player.Logs.Select(log => log.Type), Has.None.EqualTo(LogType.Exception));
    }

    [Test]
    public void Code_SeenLongAgo_DoesNotAsk()
    {
        _played.Shown.Texts.Add(Desk);
        _played.Shown.Seen = _played.Cell.Clock.Now - TimeSpan.FromSeconds(10);

        for (var i = 0; i < 10; i++) _played.Cell.Frame(_played.Session);

        Assert.That(_played.Pairing.Question, Is.Null);
    }

    [Test]
    public void Code_NotTracked_DoesNotAsk()
    {
        _played.Shown.Texts.Add(Desk);
        _played.Shown.Tracking = MarkerTracking.None;

        _played.Frames(10);

        Assert.That(_played.Pairing.Question, Is.Null);
    }

    [Test]
    public void Code_Malformed_IsLoggedOnce()
    {
        _played.Shown.Texts.Add("nowpose:cell/1?n=a");
        _played.Shown.Texts.Add("https://example.org/");

        _played.Frames(10);

        Assert.That(_played.Cell.Messages.Where(m => m.Contains("code")),
            Is.EqualTo(new[] { "[Nowpose] cell code: " + PairingCodeMessages.FieldMissing('h') }));
    }
}
