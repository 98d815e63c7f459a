using MixedReality.Toolkit;
using Nowpose.Mrtk3;
using Nowpose.Unity.Messages;
using Nowpose.UnityPlayer;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Mrtk3;

public sealed class VoiceCommandsTests
{
    Player _player;
    VoiceCommands _voice;
    SpokenKeywords _speech;
    double _now;
    int _heard;

    [SetUp]
    public void Begin()
    {
        _player = new Player();
        _now = 0;
        _heard = 0;
        _speech = new SpokenKeywords();
        var command = new VoiceCommand();
        command.With("_keyword", "overlay ghost");
        command.OnHeard.AddListener(() => _heard++);
        _voice = new GameObject("Voice").AddComponent<VoiceCommands>().With("_commands", new List<VoiceCommand> { command });
    }

    [TearDown]
    public void End()
    {
        XRSubsystemHelpers.Provide(null);
        _player.Dispose();
    }

    void Run(double seconds)
    {
        for (var end = _now + seconds; _now < end;) _player.Step(_now += 1 / 60.0);
    }

    [Test]
    public void Keyword_RecognitionStartsLate_IsRecognised()
    {
        Run(5);
        XRSubsystemHelpers.Provide(_speech);
        Run(0.1);

        _speech.Say("overlay ghost");

        Assert.That(_heard, Is.EqualTo(1));
        Assert.That(_voice.IsListening, Is.True);
        Assert.That(_player.Logs, Is.Empty);
    }

    [Test]
    public void Keyword_RecognitionReplaced_IsRecognisedOnce()
    {
        XRSubsystemHelpers.Provide(_speech);
        Run(0.1);
        _speech.Stop();
        Run(0.1);
        var next = new SpokenKeywords();
        XRSubsystemHelpers.Provide(next);
        Run(0.1);

        next.Say("overlay ghost");

        Assert.That(_heard, Is.EqualTo(1));
    }

    [Test]
    public void Keyword_ComponentDisabled_IsUnregistered()
    {
        XRSubsystemHelpers.Provide(_speech);
        Run(0.1);
        Assert.That(_speech.GetAllKeywords().Keys, Is.EqualTo(new[] { "overlay ghost" }));

        _voice.enabled = false;

        Assert.That(_speech.GetAllKeywords(), Is.Empty);
    }

    [Test]
    public void Keyword_SharedAndOneComponentDisabled_KeepsTheOtherListener()
    {
        var others = 0;
        _speech.CreateOrGetEventForKeyword("overlay ghost").AddListener(() => others++);
        XRSubsystemHelpers.Provide(_speech);
        Run(0.1);

        _voice.enabled = false;
        _speech.Say("overlay ghost");

        Assert.That((_heard, others), Is.EqualTo((0, 1)));
    }

    [Test]
    public void Keyword_UnregisteredByAnotherComponent_IsRegisteredAgain()
    {
        XRSubsystemHelpers.Provide(_speech);
        Run(0.1);

        _speech.RemoveKeyword("overlay ghost");
        Run(0.1);
        _speech.Say("overlay ghost");

        Assert.That(_heard, Is.EqualTo(1));
    }

    [Test]
    public void Keyword_UnsupportedPlatform_IsLoggedOnce()
    {
        _speech.IsSupported = false;
        XRSubsystemHelpers.Provide(_speech);

        Run(30);

        Assert.That(_voice.IsListening, Is.False);
        Assert.That(_speech.Calls, Is.EqualTo(1));
        Assert.That(_player.Logs.Select(l => l.Message), Is.EqualTo(new[]
        {
            "[Nowpose] " + Mrtk3Messages.VoiceNotSupported("Voice"),
        }));
    }

    [Test]
    public void Keyword_NoRecognition_IsLoggedOnceAsInformation()
    {
        Run(30);

        Assert.That(_player.Logs.Select(l => (l.Type, l.Message)), Is.EqualTo(new[]
        {
            (LogType.Log, "[Nowpose] " + Mrtk3Messages.VoiceNotRunning("Voice")),
        }));
    }
}
