using NUnit.Framework;
using UnityEngine;
using static Nowpose.Unity.Tests.Rendering.PlayedAppearance;

namespace Nowpose.Unity.Tests.Rendering;

/// <summary>Tests the look of the parts after the appearance is disabled, enabled again, refreshed or destroyed.</summary>
public class AppearanceLifeTests
{
    PlayedAppearance _played;

    [SetUp]
    public void Begin() => _played = new PlayedAppearance();

    [TearDown]
    public void End() => _played.Dispose();

    [Test]
    public void Refresh_RigBuiltAtRunTime_IncludesItsParts()
    {
        _played.Cell.IsPlantUp = false;

        _played.Play(0.5);

        var built = _played.Rig.GetComponentsInChildren<Renderer>()
            .Where(r => r != _played.Tool && r.gameObject != _played.Label.gameObject).ToList();
        Assert.That(_played.Rig.Model, Is.Not.Null);
        Assert.That(built.Select(r => r.isVisible), Is.Not.Empty.And.All.False);
    }

    [Test]
    public void OnDisable_WhileFaint_RestoresTheRenderers()
    {
        _played.Cell.IsPlantUp = false;
        _played.Play(1);

        _played.Appearance.enabled = false;

        Assert.That(_played.Tool.isVisible, Is.True);
        Assert.That(_played.Look(_played.Tool), Is.EqualTo((0f, 0f)));
        Assert.That(_played.Label.text, Is.Empty);
    }

    [Test]
    public void OnDisable_UserChangedTheLook_RestoresTheUsersLook()
    {
        var block = new MaterialPropertyBlock();
        block.SetFloat("_Fade", 0.25f);
        block.SetFloat("_Hatch", 1);
        _played.Tool.SetPropertyBlock(block);
        var hidden = Child("Hidden", _played.Rig.transform).AddComponent<MeshRenderer>();
        hidden.forceRenderingOff = true;
        var material = new Material((Shader)null);
        material.SetFloat("_Fade", 0.75f);
        material.SetFloat("_Hatch", 0);
        hidden.sharedMaterial = material;
        _played.BeCurrent();
        var current = (_played.Look(_played.Tool), hidden.forceRenderingOff);
        _played.Cell.IsPlantUp = false;
        _played.Run(1);
        var held = _played.Look(_played.Tool).Fade;

        _played.Appearance.enabled = false;

        Assert.That(current, Is.EqualTo(((0.25f, 1f), true)), "a current pose has the user's look");
        Assert.That(held, Is.EqualTo(0.5f));
        Assert.That(_played.Look(_played.Tool), Is.EqualTo((0.25f, 1f)));
        Assert.That(hidden.forceRenderingOff, Is.True);
        Assert.That(_played.Look(hidden).Fade, Is.EqualTo(0.75f));
    }

    [Test]
    public void Refresh_RendererMovedAway_IsRestored()
    {
        _played.Cell.IsPlantUp = false;
        _played.Play(0.5);
        Assert.That(_played.Tool.isVisible, Is.False);

        _played.Tool.transform.SetParent(null);
        _played.Appearance.Refresh();

        Assert.That(_played.Tool.isVisible, Is.True);
        Assert.That(_played.Look(_played.Tool), Is.EqualTo((0f, 0f)));
    }

    [Test]
    public void OnEnable_EnabledAgain_ShowsTheStateOfThePose()
    {
        _played.BeCurrent();
        _played.Cell.IsPlantUp = false;
        _played.Appearance.enabled = false;
        _played.Run(1);

        _played.Appearance.enabled = true;
        var words = _played.Label.text;

        Assert.That(words, Is.EqualTo("held"), "before the next frame");
    }

    // A listener that was not removed would draw the held pose, and then the ended session.
    [Test]
    public void OnDisable_AtAnyFrame_NoLongerChangesTheRenderers([Values(0, 1, 2, 300)] int frames, [Values] bool destroyed)
    {
        _played.Play(0);
        for (var i = 0; i < frames; i++) _played.Cell.Frame(_played.Session);
        if (destroyed) UnityEngine.Object.Destroy(_played.Appearance);
        else _played.Appearance.enabled = false;
        _played.Cell.Frame(_played.Session);

        _played.Cell.IsPlantUp = false;
        _played.Run(1);
        var held = (_played.Tool.isVisible, _played.Look(_played.Tool));
        _played.Cell.Player.Pause(true);

        Assert.That(held, Is.EqualTo((true, (0f, 0f))));
        Assert.That((_played.Tool.isVisible, _played.Look(_played.Tool)), Is.EqualTo((true, (0f, 0f))));
    }

    [Test]
    public void OnDestroy_AtAnyFrame_DoesNotThrowLater([Values(0, 1, 2, 300)] int frames, [Values] bool words)
    {
        _played.Play(0);
        for (var i = 0; i < frames; i++) _played.Cell.Frame(_played.Session);

        UnityEngine.Object.Destroy(words ? _played.Label.gameObject : _played.Appearance);
        _played.Run(1);
        _played.Cell.Player.Pause(true);
        _played.Cell.Player.Pause(false);
        _played.Cell.IsPlantUp = false;
        _played.Run(1);

        Assert.That(_played.Cell.Player.Logs.Where(l => l.Exception != null), Is.Empty);
    }
}
