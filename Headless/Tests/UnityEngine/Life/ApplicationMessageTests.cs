using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Headless.Tests.Engine.Life;

public sealed class ApplicationMessageTests : PlayerFixture
{
    [Test]
    public void FirstFrame_TellsEveryScriptHowThingsAre()
    {
        Add<Quitter>("a");

        Assert.That(Frame(), Is.EqualTo("a.Pause(False) a.Focus(True)"));
        Assert.That(Frame(), Is.Empty);
    }

    [Test]
    public void Pause_IsToldOncePerChange()
    {
        Add<Quitter>("a");
        Frame();

        Player.Pause(true);
        Player.Pause(true);
        Player.Pause(false);

        Assert.That(Journal.Take(), Is.EqualTo("a.Pause(True) a.Pause(False)"));
    }

    [Test]
    public void Focus_Lost_IsToldAndShows()
    {
        Add<Quitter>("a");
        Frame();
        var heard = new List<bool>();
        Application.focusChanged += heard.Add;

        Player.Focus(false);

        Assert.That(Journal.Take(), Is.EqualTo("a.Focus(False)"));
        Assert.That(Application.isFocused, Is.False);
        Assert.That(heard, Is.EqualTo(new[] { false }));
        Application.focusChanged -= heard.Add;
    }

    [Test]
    public void Pause_DisabledScript_HearsItButNotThatOfAnInactiveObject()
    {
        Add<Quitter>("a").enabled = false;
        Add<Quitter>("b").gameObject.SetActive(false);
        Frame();

        Player.Pause(true);

        Assert.That(Journal.Take(), Is.EqualTo("a.Pause(True)"));
    }

    [Test]
    public void Dispose_Quits_ThenDisablesThenDestroys()
    {
        var a = Add<Quitter>("a");
        Add<Quitter>("c", a.transform);
        Add<Quitter>("b");
        Application.quitting += () => Journal.Note("quitting");
        Frame();

        Player.Dispose();

        Assert.That(Journal.Take(), Is.EqualTo(
            "a.Quit c.Quit b.Quit quitting c.OnDisable a.OnDisable a.OnDestroy c.OnDestroy b.OnDisable b.OnDestroy"));
        Assert.That(a == null);
    }
}
