using Nowpose.Latency;
using Nowpose.Session;
using Nowpose.UnityPlayer;
using NUnit.Framework;
using UnityEngine;
using static Nowpose.Unity.Tests.Rendering.PlayedMaterials;
using static Nowpose.Unity.Tests.Rendering.UserMaterials;

namespace Nowpose.Unity.Tests.Rendering;

/// <summary>Tests that parts with the user's own materials look different while the pose is not current, with each kind of shader.</summary>
public sealed class PoseOwnMaterialTests
{
    PlayedMaterials _played;

    [SetUp]
    public void Begin() => _played = new PlayedMaterials();

    [TearDown]
    public void End() => _played.Dispose();

    const string Materials = RepositoryFiles.Package + "/Runtime/Materials/";

    [Test]
    public void Show_AnyMaterial_LooksDifferentOnlyWhileNotCurrent([Values] Sort sort, [Values] bool substitute)
    {
        _played.Tool.sharedMaterials = Of(sort);
        if (!substitute) _played.Appearance.With("_substitute", null);
        _played.BeCurrent();
        var (current, materials) = (_played.Seen(), _played.Tool.sharedMaterials);

        _played.Hold();
        var held = _played.Seen();
        _played.Cell.IsPlantUp = true;
        _played.Run(1);

        Assert.That(held, Is.Not.EqualTo(current));
        if (substitute) Assert.That(held, Is.Not.EqualTo("nothing"));
        Assert.That(_played.Seen(), Is.EqualTo(current));
        Assert.That(_played.Tool.sharedMaterials, Is.EqualTo(materials));
    }

    [Test]
    public void OnDisable_WhileNotCurrent_RestoresTheMaterials([Values] Sort sort)
    {
        _played.Tool.sharedMaterials = Of(sort);
        _played.BeCurrent();
        var current = _played.Seen();
        _played.Hold();

        _played.Appearance.enabled = false;

        Assert.That(_played.Seen(), Is.EqualTo(current));
    }

    [TestCase("_Color")]
    [TestCase("_BaseColor")]
    public void Show_Blended_LowersTheAlphaAndKeepsTheColour(string colour)
    {
        _played.Tool.sharedMaterial = Blended(colour, 0.8f);
        _played.BeCurrent();

        _played.Hold();

        var block = new MaterialPropertyBlock();
        _played.Tool.GetPropertyBlock(block);
        Assert.That(block.GetColor(colour), Is.EqualTo(new Color(1, 0.5f, 0.25f, 0.8f * (1 - 0.8f * 0.5f))));
    }

    [Test]
    public void Show_FaintestStripedLook_LosesAtLeastFortyPercentOfTheAlpha()
    {
        _played.Tool.sharedMaterial = Blended("_Color", 1);
        _played.BeCurrent();

        for (var i = 0; i < 20; i++) _played.Session.Session.Rendered(TimeSpan.FromMilliseconds(25), RenderTimeSourceKind.DisplayGpuTime);
        _played.Cell.Frame(_played.Session);
        Assert.That(_played.Session.Frame.State, Is.EqualTo(PoseState.OutsideRange));
        Assert.That(_played.Appearance.Look.Fade, Is.LessThan(0.5f));

        var block = new MaterialPropertyBlock();
        _played.Tool.GetPropertyBlock(block);

        Assert.That(block.GetColor("_Color").a, Is.EqualTo(0.6f).Within(1e-6));
    }

    [TestCase(1f, 1f, 0.6f)]
    [TestCase(0.8f, 0.84f, 0.504f)]
    [TestCase(0.5f, 0.6f, 0.36f)]
    [TestCase(0f, 0.2f, 0.12f)]
    public void Opacity_BlendedPart_IsFainterWhileNotCurrentAtAnyOpacity(float opacity, float current, float held)
    {
        _played.Tool.sharedMaterial = Blended("_Color", 1);
        _played.Appearance.Opacity = opacity;
        var block = new MaterialPropertyBlock();
        float Alpha()
        {
            _played.Tool.GetPropertyBlock(block);
            return block.HasColor(Shader.PropertyToID("_Color")) ? block.GetColor("_Color").a : 1;
        }
        _played.BeCurrent();
        Assert.That(Alpha(), Is.EqualTo(current).Within(1e-6));

        _played.Hold();
        Assert.That(Alpha(), Is.EqualTo(held).Within(1e-6));
        _played.Cell.Player.Pause(true);
        Assert.That(Alpha(), Is.EqualTo(Math.Max(0.36f * current, 0.1f)).Within(1e-6), "no session");
    }

    [TestCase(1f, 0f, 0.5f)]
    [TestCase(0.5f, 0.5f, 0.8f)]
    [TestCase(0f, 1f, 1f)]
    public void Opacity_PatternedPart_IsStripedAndNotBrighterWhileNotCurrent(float opacity, float current, float held)
    {
        _played.Tool.sharedMaterials = Of(Sort.Patterned);
        _played.Appearance.Opacity = opacity;
        var block = new MaterialPropertyBlock();
        (float Fade, float Hatch) Look()
        {
            _played.Tool.GetPropertyBlock(block);
            return (block.GetFloat(Shader.PropertyToID("_Fade")), block.GetFloat(Shader.PropertyToID("_Hatch")));
        }
        _played.BeCurrent();
        Assert.That(Look().Fade, Is.EqualTo(current).Within(1e-6));
        Assert.That(Look().Hatch, Is.EqualTo(0));

        _played.Hold();
        Assert.That(Look().Fade, Is.EqualTo(held).Within(1e-6));
        Assert.That(Look().Hatch, Is.EqualTo(1));
    }

    [Test]
    public void Show_PatternReplacedByAnOppositeFade_DoesNotChangeTheNewMaterial()
    {
        _played.Tool.sharedMaterial = NewMaterial("Hologram", ("_Fade", 0), ("_Hatch", 0));
        _played.BeCurrent();

        _played.Tool.sharedMaterial = NewMaterial("Brass", ("_Fade", 1));
        _played.Hold();
        _played.Cell.IsPlantUp = true;
        _played.Run(1);

        Assert.That(_played.Seen(), Is.EqualTo("Brass _Fade1"));
    }

    [Test]
    public void Show_BlendedWithoutUserPropertyBlock_RemovesThePackagesBlock()
    {
        var material = Blended("_Color", 1);
        _played.Tool.sharedMaterial = material;
        _played.BeCurrent();
        _played.Hold();
        Assert.That(_played.Tool.HasPropertyBlock(), Is.True);

        _played.Cell.IsPlantUp = true;
        _played.Run(1);

        Assert.That(_played.Tool.HasPropertyBlock(), Is.False, "the part has its material's colour again");
    }

    [Test]
    public void Show_BlendedWithUserPropertyBlock_RestoresItsColour()
    {
        _played.Tool.sharedMaterial = Blended("_Color", 1);
        var block = new MaterialPropertyBlock();
        block.SetColor(Shader.PropertyToID("_Color"), new Color(0, 1, 0, 0.5f));
        _played.Tool.SetPropertyBlock(block);
        _played.BeCurrent();

        _played.Hold();
        _played.Tool.GetPropertyBlock(block);
        var held = block.GetColor("_Color");
        _played.Cell.IsPlantUp = true;
        _played.Run(1);
        _played.Tool.GetPropertyBlock(block);

        Assert.That(held, Is.EqualTo(new Color(0, 1, 0, 0.5f * 0.6f)));
        Assert.That(block.GetColor("_Color"), Is.EqualTo(new Color(0, 1, 0, 0.5f)));
    }

    [Test]
    public void Show_MaterialChangedWhileNotCurrent_KeepsTheNewMaterial()
    {
        _played.Tool.sharedMaterial = NewMaterial("Steel");
        _played.BeCurrent();
        _played.Hold();
        var brass = NewMaterial("Brass");

        _played.Tool.sharedMaterial = brass;
        _played.Cell.IsPlantUp = true;
        _played.Run(1);
        var current = _played.Tool.sharedMaterial;
        _played.Hold();

        Assert.That(current, Is.SameAs(brass));
        Assert.That(_played.Tool.sharedMaterial, Is.SameAs(_played.Substitute));
    }

    // A signal may assign a material for each of its values.
    [Test]
    public void Show_MaterialChangedWhileNotCurrent_MarksTheNewMaterialAtOnce(
        [Values(Sort.Patterned, Sort.Blended, Sort.BlendedUniversal, Sort.Opaque, Sort.Several)] Sort before,
        [Values(Sort.Patterned, Sort.Blended, Sort.BlendedUniversal, Sort.Opaque, Sort.Missing)] Sort after)
    {
        var materials = Of(after);
        _played.Tool.sharedMaterials = materials;
        _played.BeCurrent();
        var current = _played.Seen();
        _played.Hold();
        var marked = _played.Seen();
        _played.Cell.IsPlantUp = true;
        _played.Run(1);
        _played.Tool.sharedMaterials = Of(before);
        _played.Hold();

        _played.Tool.sharedMaterials = materials;
        _played.Cell.Frame(_played.Session);
        var changed = _played.Seen();
        _played.Cell.IsPlantUp = true;
        _played.Run(1);

        Assert.That((changed, _played.Seen()), Is.EqualTo((marked, current)));
        Assert.That(_played.Tool.sharedMaterials, Is.EqualTo(materials));
    }

    [Test]
    public void Show_MaterialChangedAfterTheSessionEnded_MarksTheNewMaterialAtOnce()
    {
        _played.Tool.sharedMaterial = NewMaterial("Steel");
        _played.BeCurrent();
        _played.Session.enabled = false;

        _played.Tool.sharedMaterial = NewMaterial("Brass");
        _played.Cell.Frame(_played.Session);

        Assert.That(_played.Tool.sharedMaterial, Is.SameAs(_played.Substitute));
    }

    [TestCase("Occluder.mat", "Occluder")]
    [TestCase("Solid.mat", "Solid _Fade0.5 _Hatch1")]
    [TestCase("Text.mat", "Text")]
    public void Show_MaterialOfThePackage_KeepsIt(string file, string expected)
    {
        _played.Tool.sharedMaterial = RepositoryAssets.NewLibrary().Load<Material>(Materials + file);
        _played.BeCurrent();

        _played.Hold();

        Assert.That(_played.Seen(), Is.EqualTo(expected));
        Assert.That(_played.Cell.Player.Logs.Where(l => l.Message.Contains("of 'Tool'", StringComparison.Ordinal)), Is.Empty);
    }

    [Test]
    public void Show_ChangingStates_AllocatesNothing([Values(Sort.Blended, Sort.Opaque, Sort.Several, Sort.SeveralOppositeFade)] Sort sort)
    {
        _played.Tool.sharedMaterials = Of(sort);
        _played.Session.gameObject.SetActive(true);
        var frame = 0;
        void Cycle() => _played.Cell.Run(40, _played.Session, () => _played.Cell.IsPlantUp = frame++ % 40 < 12);
        Cycle();

        var allocated = _played.Cell.AllocatedIn(Cycle);

        Assert.That(allocated, Is.EqualTo(0));
    }
}
