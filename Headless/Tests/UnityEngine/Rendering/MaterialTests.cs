using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Headless.Tests.Engine.Rendering;

public sealed class MaterialTests : PlayerFixture
{
    [Test]
    public void PropertyBlock_SetOnARenderer_IsACopy()
    {
        var renderer = Add<MeshRenderer>("a");
        var block = new MaterialPropertyBlock();
        block.SetFloat("_Fade", 0.5f);
        block.SetColor("_Tint", Color.red);
        renderer.SetPropertyBlock(block);
        block.SetFloat("_Fade", 1);

        var read = new MaterialPropertyBlock();
        renderer.GetPropertyBlock(read);
        Assert.That((read.GetFloat("_Fade"), read.GetColor("_Tint"), renderer.HasPropertyBlock()), Is.EqualTo((0.5f, Color.red, true)));

        renderer.SetPropertyBlock(null);
        Assert.That(renderer.HasPropertyBlock(), Is.False);
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
    public void Material_OfARenderer_IsACopyOfItsOwn()
    {
        var shared = new Material((Shader)null) { name = "shared", color = Color.white };
        var renderer = Add<MeshRenderer>("a");
        renderer.sharedMaterial = shared;

        renderer.material.color = Color.red;

        Assert.That((shared.color, renderer.material.name), Is.EqualTo((Color.white, "shared (Instance)")));
        Assert.That(renderer.material, Is.SameAs(renderer.sharedMaterial));
    }

    [Test]
    public void PropertyToID_SameName_IsTheSame()
    {
        Assert.That(Shader.PropertyToID("_A"), Is.EqualTo(Shader.PropertyToID("_A")).And.Not.EqualTo(Shader.PropertyToID("_B")));
    }
}
