using Nowpose.Unity.Tests.Engine.Scripts;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Events;

namespace Nowpose.Unity.Tests.Engine.Rendering;

public sealed class BeforeRenderTests : PlayerFixture
{
    [Test]
    public void Handlers_InAFrame_RunInOrderBetweenLateUpdatesAndCameras()
    {
        Add<Recorder>("a");
        Add<Camera>("c");
        Frame();
        Camera.onPreRender += _ => Journal.Note("camera");
        Application.onBeforeRender += Late;
        Application.onBeforeRender += Plain;
        Application.onBeforeRender += Early;

        Assert.That(Frame(), Is.EqualTo("a.Update a.LateUpdate early plain late camera"));
        Application.onBeforeRender -= Plain;
        Assert.That(Frame(), Is.EqualTo("a.Update a.LateUpdate early late camera"));
        Assert.That(Player.SubscriberCount, Is.EqualTo(3));
    }

    [Test]
    public void Handler_RemovesItself_OtherHandlersRun()
    {
        UnityAction once = null;
        once = () =>
        {
            Journal.Note("once");
            Application.onBeforeRender -= once;
        };
        Application.onBeforeRender += once;
        Application.onBeforeRender += Plain;

        Assert.That(Frame(), Is.EqualTo("once plain"));
        Assert.That(Frame(), Is.EqualTo("plain"));
    }

    [Test]
    public void Handler_Throws_OtherHandlersRun()
    {
        Application.onBeforeRender += () => throw new InvalidOperationException("before");
        Application.onBeforeRender += Plain;

        Assert.That(Frame(), Is.EqualTo("plain"));
        Assert.That(Player.Logs.Single().Message, Does.Contain("before"));
    }

    [BeforeRenderOrder(-5)]
    static void Early() => Journal.Note("early");

    static void Plain() => Journal.Note("plain");

    [BeforeRenderOrder(5)]
    static void Late() => Journal.Note("late");
}
