using MixedReality.Toolkit.UX;
using Nowpose.Unity.Tests.Pairing;
using Nowpose.Mrtk3;
using Nowpose.Pairing;
using Nowpose.Unity;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Mrtk3;

public sealed class ConsentPromptTests
{
    PlayedCell _cell;
    MrilSession _session;
    CellPairing _pairing;
    ShownCodes _codes;
    GameObject _content;
    TextMesh _question;
    PressableButton _accept, _refuse;
    string _folder;

    [SetUp]
    public void Begin()
    {
        _folder = Directory.CreateTempSubdirectory("nowpose-consent-").FullName;
        _cell = new PlayedCell();
        _session = _cell.NewSession();
        _pairing = _session.gameObject.AddComponent<CellPairing>().With("_fileName", Path.Combine(_folder, "cells.json"));
        Child(_session.gameObject, "Base").AddComponent<BaseAnchor>();
        _codes = Child(_session.gameObject, "Codes").AddComponent<ShownCodes>();
        var root = Child(_session.gameObject, "Consent");
        _content = Child(root, "Content");
        _question = Child(_content, "Question").AddComponent<TextMesh>();
        _accept = Child(_content, "Accept").AddComponent<PressableButton>();
        _refuse = Child(_content, "Refuse").AddComponent<PressableButton>();
        var prompt = root.AddComponent<ConsentPrompt>().With("_content", _content).With("_question", _question)
            .With("_accept", _accept).With("_refuse", _refuse);
        _accept.OnClicked.AddListener(prompt.Accept);
        _refuse.OnClicked.AddListener(prompt.Refuse);
        _session.gameObject.SetActive(true);
        Run();
    }

    [TearDown]
    public void End()
    {
        _cell.Dispose();
        Directory.Delete(_folder, true);
    }

    static GameObject Child(GameObject parent, string name)
    {
        var child = new GameObject(name);
        child.transform.SetParent(parent.transform, false);
        return child;
    }

    void Run(int frames = 5)
    {
        for (var i = 0; i < frames; i++)
        {
            _codes.Seen = _cell.Clock.Now;
            _cell.Frame(_session);
        }
    }

    void LookAtTheMarker()
    {
        _codes.Texts.Add(new CellCode("desk", "127.0.0.1", null, MarkerOffset.Parse("0.5,0,0", ""), 0.1, 1, 1).Text);
        Run(60);
    }

    [Test]
    public void Prompt_NoQuestion_IsHidden()
    {
        Assert.That(_content.activeSelf, Is.False);
    }

    [Test]
    public void Prompt_Question_IsShownInLinesThatFit()
    {
        LookAtTheMarker();

        Assert.That(_content.activeSelf, Is.True);
        Assert.That(_question.text.Replace('\n', ' '), Is.EqualTo(_pairing.Question));
        Assert.That(_question.text.Split('\n').Max(Status.SeenText.WidthOf), Is.LessThanOrEqualTo(30));
    }

    [Test]
    public void Prompt_Question_IsInFrontOfTheHeadInItsFirstFrame()
    {
        _content.AddComponent<BodyFollow>();
        var head = new GameObject("Camera") { tag = "MainCamera" }.AddComponent<Camera>().transform;
        head.position = new Vector3(3, 1.6f, 2);
        _codes.Texts.Add(new CellCode("desk", "127.0.0.1", null, MarkerOffset.Parse("0.5,0,0", ""), 0.1, 1, 1).Text);

        for (var frame = 0; frame < 600 && !_content.activeSelf; frame++) Run(1);

        Assert.That(_content.activeSelf);
        Assert.That(Vector3.Distance(_content.transform.position, head.position), Is.EqualTo(1.3f).Within(1e-4));
    }

    [Test]
    public void Accept_Pressed_AcceptsAndHides()
    {
        LookAtTheMarker();

        _accept.Enter();
        _accept.Exit();
        Run();

        Assert.That(_pairing.Cell, Is.EqualTo("desk"));
        Assert.That(_content.activeSelf, Is.False);
    }

    [Test]
    public void Accept_PressedTooEarly_IsIgnored()
    {
        LookAtTheMarker();
        _pairing.Refuse();
        _codes.Texts.Clear();
        _codes.Texts.Add(new CellCode("wall", "127.0.0.1", null, null, 0, 2, 2).Text);
        for (var frame = 0; frame < 600 && _pairing.Question == null; frame++) Run(1);

        _accept.Enter();
        _accept.Exit();
        Run(1);
        Assert.That(_pairing.Cell, Is.Null);
        Assert.That(_pairing.Question, Does.Contain("wall"));

        Run(60);
        _accept.Enter();
        _accept.Exit();
        Run(1);
        Assert.That(_pairing.Cell, Is.EqualTo("wall"));
    }

    [Test]
    public void Refuse_Pressed_DoesNotConnectAndHides()
    {
        LookAtTheMarker();

        _refuse.Enter();
        _refuse.Exit();
        Run();

        Assert.That(_pairing.Cell, Is.Null);
        Assert.That(_session.IsConnecting, Is.False);
        Assert.That(_content.activeSelf, Is.False);
    }

    // In MRTK3 core 3.0, the property throws until the button has been active.
    [Test]
    public void Prompt_QuestionOpen_OnlyTheSafeAnswerIsPossibleByVoice()
    {
        LookAtTheMarker();

        Assert.That(_cell.Player.Logs.Where(log => log.Exception != null), Is.Empty);
        Assert.That((_accept.AllowSelectByVoice, _refuse.AllowSelectByVoice), Is.EqualTo((false, true)));
    }
}
