using NUnit.Framework;
using UnityEngine;
using static Nowpose.Unity.Tests.Rendering.UserMaterials;

namespace Nowpose.Unity.Tests.Rendering;

/// <summary>Tests the colour that a part leaves in the property block of the user after its pose was not current.</summary>
public sealed class BlockColourTests
{
    PlayedMaterials _played;

    [SetUp]
    public void Begin() => _played = new PlayedMaterials();

    [TearDown]
    public void End() => _played.Dispose();

    // The colour of the former material in the property block would replace that of the new one.
    [TestCase(false, false)]
    [TestCase(true, false)]
    [TestCase(true, true)]
    public void Show_OpaqueMaterialAssignedWhileNotCurrent_HasItsOwnOrTheUsersColour(bool hasBlock, bool hasColour)
    {
        var id = Shader.PropertyToID("_Color");
        var block = new MaterialPropertyBlock();
        if (hasBlock) block.SetFloat("_Glow", 1);
        if (hasColour) block.SetColor(id, Color.red);
        if (hasBlock) _played.Tool.SetPropertyBlock(block);
        _played.Tool.sharedMaterial = Blended("_Color", 0.8f);
        _played.BeCurrent();
        _played.Hold();

        _played.Tool.sharedMaterials = Of(Sort.OpaqueWithColour);
        _played.Cell.IsPlantUp = true;
        _played.Run(1);

        _played.Tool.GetPropertyBlock(block);
        var seen = block.HasColor(id) ? block.GetColor(id) : _played.Tool.sharedMaterial.GetColor(id);
        Assert.That((block.isEmpty, seen), Is.EqualTo((!hasBlock, hasColour ? Color.red : Color.white)));
    }

    [Test]
    public void Show_UsersColourIsThatOfTheFormerMaterial_IsKeptWithAnotherMaterial()
    {
        var id = Shader.PropertyToID("_Color");
        _played.Tool.sharedMaterial = Blended("_Color", 0.8f);
        var colour = _played.Tool.sharedMaterial.GetColor(id);
        _played.BeCurrent();
        _played.Hold();
        BeCurrentAgain();
        var block = new MaterialPropertyBlock();
        block.SetColor(id, colour);
        _played.Tool.SetPropertyBlock(block);
        _played.Hold();

        _played.Tool.sharedMaterials = Of(Sort.OpaqueWithColour);
        BeCurrentAgain();

        Assert.That(ColourInBlock(), Is.EqualTo(colour));
    }

    [Test]
    public void Show_TwoMaterialsAssignedWhileNotCurrent_HasTheColourOfTheLast()
    {
        var block = new MaterialPropertyBlock();
        block.SetFloat("_Glow", 1);
        _played.Tool.SetPropertyBlock(block);
        _played.Tool.sharedMaterial = Blended("_Color", 0.8f);
        _played.BeCurrent();
        _played.Hold();

        _played.Tool.sharedMaterials = Of(Sort.OpaqueWithColour);
        _played.Run(0.1);
        var last = Blended("_Color", 0.5f);
        last.SetColor("_Color", Color.green);
        _played.Tool.sharedMaterial = last;
        _played.Run(0.1);
        BeCurrentAgain();

        Assert.That(ColourInBlock(), Is.EqualTo(Color.green));
    }

    void BeCurrentAgain()
    {
        _played.Cell.IsPlantUp = true;
        _played.Run(1);
    }

    Color ColourInBlock()
    {
        var block = new MaterialPropertyBlock();
        _played.Tool.GetPropertyBlock(block);
        return block.GetColor(Shader.PropertyToID("_Color"));
    }
}
