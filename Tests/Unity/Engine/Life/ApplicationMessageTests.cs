using Nowpose.Unity.Tests.Engine.Scripts;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Engine.Life;

public sealed class ApplicationMessageTests : PlayerFixture
{
    [Test]
    public void Script_InTheFirstFrame_ReceivesPauseAndFocus()
    {
        Add<Quitter>("a");

        Assert.That(Frame(), Is.EqualTo("a.Pause(False) a.Focus(True)"));
        Assert.That(Frame(), Is.Empty);
    }

    [Test]
    public void Pause_SetRepeatedly_IsSentOncePerChange()
    {
        Add<Quitter>("a");
        Frame();

        Player.Pause(true);
        Player.Pause(true);
        Player.Pause(false);

        Assert.That(Journal.Take(), Is.EqualTo("a.Pause(True) a.Pause(False)"));
    }

    [Test]
    public void Pause_ScriptDisabled_ReceivesTheMessageIfItsObjectIsActive()
    {
        Add<Quitter>("a").enabled = false;
        Add<Quitter>("b").gameObject.SetActive(false);
        Frame();

        Player.Pause(true);

        Assert.That(Journal.Take(), Is.EqualTo("a.Pause(True)"));
    }

    [Test]
    public void Dispose_RunningPlayer_QuitsThenDisablesThenDestroys()
    {
        var a = Add<Quitter>("a");
        Add<Quitter>("c", a.transform);
        Add<Quitter>("b");
        Frame();

        Player.Dispose();

        Assert.That(Journal.Take(), Is.EqualTo(
            "a.Quit c.Quit b.Quit c.OnDisable a.OnDisable a.OnDestroy c.OnDestroy b.OnDisable b.OnDestroy"));
        Assert.That(a == null);
    }
}
