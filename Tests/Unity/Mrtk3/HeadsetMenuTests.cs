using MixedReality.Toolkit;
using MixedReality.Toolkit.UX;
using Nowpose.Latency;
using Nowpose.Mrtk3;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Mrtk3;

public sealed class HeadsetMenuTests
{
    PlayedCell _cell;
    MrilSession _session;
    CellActions _actions;
    HeadsetMenu _menu;
    PressableButton _ghost;
    Slider _opacity, _nudge;
    TextMesh _nudgeWords;

    [SetUp]
    public void Begin()
    {
        _cell = new PlayedCell();
        _session = _cell.NewSessionOf("Nowpose Robot Cell");
        var root = new GameObject("Menu");
        root.SetActive(false);
        _actions = root.AddComponent<CellActions>().With("_session", _session);
        _ghost = Child<PressableButton>(root, "Ghost");
        _ghost.ToggleMode = StatefulInteractable.ToggleType.Toggle;
        _ghost.OnClicked.AddListener(_actions.ToggleGhost);
        _opacity = Child<Slider>(root, "Opacity");
        _nudge = Child<Slider>(root, "Nudge");
        _nudge.With("minValue", -20f).With("maxValue", 20f).With("value", 0f);
        _nudgeWords = Child<TextMesh>(root, "Words");
        _menu = root.AddComponent<HeadsetMenu>().With("_ghost", _ghost).With("_opacity", _opacity).With("_nudge", _nudge)
            .With("_nudgeWords", _nudgeWords);
        _opacity.OnValueUpdated.AddListener(_menu.SlideOpacity);
        _nudge.OnValueUpdated.AddListener(_menu.SlideNudge);
        _session.gameObject.SetActive(true);
        root.SetActive(true);
        Run();
    }

    [TearDown]
    public void End() => _cell.Dispose();

    void Run() => _cell.Run(0.1, _session);

    static T Child<T>(GameObject parent, string name) where T : Component
    {
        var child = new GameObject(name);
        child.transform.SetParent(parent.transform, false);
        return child.AddComponent<T>();
    }

    static void Press(StatefulInteractable button)
    {
        button.Enter();
        button.Exit();
    }

    [Test]
    public void Toggle_Pressed_RunsTheActionAndShowsTheState()
    {
        Press(_ghost);
        Run();

        Assert.That(_actions.IsGhostShown, Is.True);
        Assert.That(_ghost.IsToggled.Active, Is.True);
    }

    [Test]
    public void Toggle_StateChangedElsewhere_ShowsTheNewState()
    {
        _actions.SetGhost(true);
        Run();

        Assert.That(_ghost.IsToggled.Active, Is.True);
    }

    [Test]
    public void Toggle_ActionFails_Reverts()
    {
        UnityEngine.Object.DestroyImmediate(_session.GetComponentInChildren<Ghost>(true).gameObject);

        Press(_ghost);
        Run();

        Assert.That(_ghost.IsToggled.Active, Is.False);
    }

    [Test]
    public void Slider_AtTheStart_ShowsTheCurrentValue()
    {
        Assert.That(_opacity.Value, Is.EqualTo(1), "the slider shows the opacity, not its own initial value 0.5");
        Assert.That(_actions.Opacity, Is.EqualTo(1));
        Assert.That(_nudgeWords.text, Is.EqualTo("L_visu 0.0 ms"));
    }

    [Test]
    public void Slider_Moved_RunsTheActionAndShowsTheValue()
    {
        _nudge.Value = -7.5f;
        _opacity.Value = 0.25f;
        Run();

        Assert.That(_actions.NudgeMs, Is.EqualTo(-7.5f));
        Assert.That(_actions.Opacity, Is.EqualTo(0.25f));
        Assert.That(_nudgeWords.text, Is.EqualTo("L_visu -7.5 ms"));
    }

    [Test]
    public void Slider_ValueBeyondItsRange_ShowsTheLimitAndKeepsTheValue()
    {
        _actions.SetNudgeMs(35);
        Run();

        Assert.That(_nudge.Value, Is.EqualTo(20));
        Assert.That(_actions.NudgeMs, Is.EqualTo(35));
        Assert.That(_nudgeWords.text, Is.EqualTo("L_visu +35.0 ms"));
    }

    [Test]
    public void Slider_RuntimePredictsDisplayTimes_ShowsThatTheNudgeHasNoEffect()
    {
        _session.Session.DisplayTimeSource = new Ahead();
        Run();

        Assert.That(_nudgeWords.text, Is.EqualTo(Mrtk3Messages.VisuByRuntime));
    }

    sealed class Ahead : IDisplayTimeSource
    {
        public HeadsetTime? LightOf(HeadsetTime frameStart) => frameStart + TimeSpan.FromMilliseconds(30);
    }

    [Test]
    public void Menu_NoActions_IsLoggedOnce()
    {
        new GameObject("Lone").AddComponent<HeadsetMenu>();
        Run();

        Assert.That(_cell.Messages.Count(m => m.Contains(Mrtk3Messages.MenuWithoutActions("Lone"))), Is.EqualTo(1));
    }

    [Test]
    public void Menu_NothingChanges_AllocatesNothing()
    {
        Run();
        void LateUpdate() => _menu.Script.Call(Message.LateUpdate, _menu);
        LateUpdate();

        var before = GC.GetAllocatedBytesForCurrentThread();
        for (var i = 0; i < 100; i++) LateUpdate();

        Assert.That(GC.GetAllocatedBytesForCurrentThread() - before, Is.Zero);
    }

    [Test]
    public void Slider_ListenerThrowsWhileItsValueIsShown_StillRunsTheAction()
    {
        _opacity.OnValueUpdated.AddListener(_ => throw new InvalidOperationException("thrown by the listener"));
        _actions.SetOpacity(0.5f);
        Run();

        _nudge.Value = -7.5f;
        Run();

        Assert.That((_actions.NudgeMs, _nudge.Value), Is.EqualTo((-7.5f, -7.5f)));
    }
}
