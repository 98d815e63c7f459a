using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Engine.Rendering;

public sealed class MaterialTests : PlayerFixture
{
    [Test]
    public void PropertyBlock_SetOnARenderer_IsACopy()
    {
        var renderer = Add<MeshRenderer>("a");
        var block = new MaterialPropertyBlock();
        block.SetFloat("_Fade", 0.5f);
        renderer.SetPropertyBlock(block);
        block.SetFloat("_Fade", 1);

        var read = new MaterialPropertyBlock();
        renderer.GetPropertyBlock(read);
        Assert.That(read.GetFloat("_Fade"), Is.EqualTo(0.5f));

        renderer.SetPropertyBlock(null);
        renderer.GetPropertyBlock(read);
        Assert.That(read.GetFloat("_Fade"), Is.Zero);
    }

    [Test]
    public void PropertyBlock_SetEveryFrame_AllocatesNothing()
    {
        var renderer = Add<MeshRenderer>("a");
        var block = new MaterialPropertyBlock();
        var id = Shader.PropertyToID("_Fade");
        Set();

        var before = GC.GetAllocatedBytesForCurrentThread();
        Set();

        Assert.That(GC.GetAllocatedBytesForCurrentThread() - before, Is.Zero);

        void Set()
        {
            renderer.GetPropertyBlock(block);
            block.SetFloat(id, 0.25f);
            renderer.SetPropertyBlock(block);
        }
    }

    [Test]
    public void PropertyToID_SameName_ReturnsTheSameId()
    {
        Assert.That(Shader.PropertyToID("_A"), Is.EqualTo(Shader.PropertyToID("_A")).And.Not.EqualTo(Shader.PropertyToID("_B")));
    }
}
