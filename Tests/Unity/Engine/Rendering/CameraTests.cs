using Nowpose.Unity.Tests.Engine.Scripts;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Engine.Rendering;

public sealed class CameraTests : PlayerFixture
{
    [Test]
    public void Main_SeveralCameras_IsTheEnabledCameraWithTheTag()
    {
        Add<Camera>("other");
        var main = Add<Camera>("main");
        main.gameObject.tag = "MainCamera";

        Assert.That(Camera.main, Is.SameAs(main));
        main.enabled = false;
        Assert.That(Camera.main == null);
    }

    [Test]
    public void RenderCallbacks_SeveralCameras_AreCalledForEachInOrderOfDepth()
    {
        Add<Camera>("second").depth = 2;
        Add<Camera>("first").depth = 1;
        Add<Camera>("off").enabled = false;
        Camera.onPreRender += c => Journal.Note($"{c.name}.pre");
        Camera.onPostRender += c => Journal.Note($"{c.name}.post");

        Assert.That(Frame(), Is.EqualTo("first.pre first.post second.pre second.post"));
    }

    [Test]
    public void CameraCallbacks_OfTwoPlayers_AreSeparate()
    {
        Camera.onPreRender += _ => { };
        Assert.That(Player.SubscriberCount, Is.EqualTo(1));

        using (var second = new Nowpose.UnityPlayer.Player())
        {
            Assert.That(Camera.onPreRender, Is.Null);
            Assert.That(second.SubscriberCount, Is.Zero);
            Assert.That(Player.SubscriberCount, Is.EqualTo(1));
        }
    }

    [Test]
    public void CameraCallback_Throws_FrameContinues()
    {
        Add<Camera>("c");
        Camera.onPreRender += _ => throw new InvalidOperationException("pre");
        Camera.onPostRender += _ => Journal.Note("post");

        Assert.That(Frame(), Is.EqualTo("post"));
        Assert.That(Player.Logs.Single().Message, Does.Contain("pre"));
    }
}
