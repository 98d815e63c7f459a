using Nowpose.Session;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using Nowpose.UnityPlayer;
using NUnit.Framework;
using UnityEngine;
using static Nowpose.Unity.Tests.Rendering.PlayedMaterials;
using static Nowpose.Unity.Tests.Rendering.UserMaterials;

namespace Nowpose.Unity.Tests.Rendering;

/// <summary>Tests that the striped substitute replaces opaque materials while the pose is not current.</summary>
public sealed class SubstituteMaterialTests
{
    PlayedMaterials _played;

    [SetUp]
    public void Begin() => _played = new PlayedMaterials();

    [TearDown]
    public void End() => _played.Dispose();

    /// <summary>The shader Graphics Tools Standard has a property _Fade with the opposite meaning: at 1 the part is fully visible.</summary>
    [Test]
    public void Show_MaterialWithFadeButNoHatch_UsesTheSubstituteAndKeepsTheMaterialsFade([Values] bool several)
    {
        var brass = NewMaterial("Brass", ("_Fade", 1));
        _played.Tool.sharedMaterials = several ? [NewMaterial("Hologram", ("_Fade", 0), ("_Hatch", 0)), brass] : [brass];
        _played.BeCurrent();
        Assert.That(_played.Tool.HasPropertyBlock(), Is.False);

        _played.Hold();
        Assert.That(_played.Seen(), Does.EndWith("Substitute _Fade0.5 _Hatch1"), "the state determines _Fade, not the user's material");
        if (several) Assert.That(_played.Seen(), Does.StartWith("Hologram _Fade0.5 _Hatch1"));
        _played.Cell.IsPlantUp = true;
        _played.Run(1);
        brass.SetFloat("_Fade", 0.5f);

        Assert.That(_played.Seen(), Does.EndWith("Brass _Fade0.5"), "the material's own value of _Fade is used");
    }

    [Test]
    public void Show_SubstituteWithFade_KeepsTheFade()
    {
        _played.Substitute.SetFloat("_Fade", 0.7f);
        _played.Tool.sharedMaterial = NewMaterial("Brass", ("_Fade", 1));
        _played.BeCurrent();

        _played.Hold();

        Assert.That(_played.Seen(), Is.EqualTo("Substitute _Fade0.7 _Hatch1"));
    }

    [Test]
    public void Show_OpaqueWithUserPropertyBlocks_RestoresThem([Values] bool changed)
    {
        _played.Tool.sharedMaterials = [NewMaterial("Brass", ("_Fade", 1)), NewMaterial("Steel")];
        var (whole, single) = (new MaterialPropertyBlock(), new MaterialPropertyBlock());
        whole.SetFloat("_Fade", 0.75f);
        single.SetFloat("_Fade", 0.25f);
        _played.Tool.SetPropertyBlock(whole);
        _played.Tool.SetPropertyBlock(single, 1);
        _played.BeCurrent();

        _played.Hold();
        Assert.That(_played.Seen(), Is.EqualTo("Substitute _Fade0.5 _Hatch1 | Substitute _Fade0.5 _Hatch1"));
        if (changed) _played.Tool.sharedMaterials = [NewMaterial("Paint", ("_Fade", 1)), NewMaterial("Paint", ("_Fade", 1))];
        _played.Cell.IsPlantUp = true;
        _played.Run(1);

        var block = new MaterialPropertyBlock();
        _played.Tool.GetPropertyBlock(block);
        Assert.That(block.GetFloat("_Fade"), Is.EqualTo(0.75f));
        Assert.That(block.HasFloat(Shader.PropertyToID("_Hatch")), Is.False);
        _played.Tool.GetPropertyBlock(block, 0);
        Assert.That(block.isEmpty, Is.True);
        _played.Tool.GetPropertyBlock(block, 1);
        Assert.That(block.GetFloat("_Fade"), Is.EqualTo(0.25f));
    }

    [Test]
    public void Show_MissingMaterial_WarnsWithThePartsName([Values] bool substitute)
    {
        if (!substitute) _played.Appearance.With("_substitute", null);
        _played.BeCurrent();

        _played.Hold();

        Assert.That(_played.Seen(), Is.EqualTo(substitute ? "Substitute _Fade0.5 _Hatch1" : "nothing"));
        var said = _played.Cell.Player.Logs.Where(l => l.Message.Contains(AppearanceMessages.NoMaterial("Tool"), StringComparison.Ordinal));
        Assert.That(said.Count(), Is.EqualTo(1));
    }

    [Test]
    public void Show_Opaque_IsDrawnWithTheStripedSubstituteAndLogsOnce()
    {
        _played.Tool.sharedMaterial = NewMaterial("Steel");
        _played.BeCurrent();

        _played.Hold();
        _played.Appearance.Refresh();

        Assert.That(_played.Seen(), Is.EqualTo("Substitute _Fade0.5 _Hatch1"));
        var said = _played.Cell.Player.Logs.Where(l => l.Message.Contains("'Steel'", StringComparison.Ordinal)).ToList();
        Assert.That(said, Has.Count.EqualTo(1));
        Assert.That(said[0].Type, Is.EqualTo(LogType.Log));
        Assert.That(said[0].Message, Does.Contain("'Substitute'").And.Contain("NowposePose.hlsl"));
    }

    // Several materials also include those that are replaced only because a property block sets the alpha of all of them.
    [Test]
    public void Show_UnsuitableMaterialAssignedLater_LogsOnce([Values] bool current, [Values] bool substitute, [Values] bool several)
    {
        List<PlayerLogEntry> Said() => [.. _played.Cell.Player.Logs.Where(l => l.Message.Contains("of 'Tool'", StringComparison.Ordinal))];
        if (!substitute) _played.Appearance.With("_substitute", null);
        _played.Tool.sharedMaterial = NewMaterial("Hologram", ("_Fade", 0), ("_Hatch", 0));
        _played.BeCurrent();
        if (!current) _played.Hold();

        _played.Tool.sharedMaterials = several ? [Blended("_Color", 0.8f), Blended("_Color", 0.8f)] : [NewMaterial("Steel")];
        if (current) _played.Hold();
        else _played.Cell.Frame(_played.Session);
        var said = Said();
        _played.Appearance.Refresh();

        Assert.That(said.Select(l => l.Type), Is.EqualTo(new[] { substitute ? LogType.Log : LogType.Warning }));
        Assert.That(said[0].Message, Does.Contain(several ? "'Glass'" : "'Steel'"));
        Assert.That(Said(), Has.Count.EqualTo(1));
    }

    // The LateUpdate of the appearance has already run, so only the computation right before rendering can mark the material in the same frame.
    [Test]
    public void Show_MaterialAssignedAfterLateUpdate_IsMarkedBeforeRendering()
    {
        _played.Session.Settings = new SessionSettings(
            PlayedCell.Offline.Connection, PlayedCell.Offline.Visualisation, rewriteBeforeRender: true);
        _played.Tool.sharedMaterial = NewMaterial("Steel");
        _played.BeCurrent();
        _played.Hold();

        _played.Tool.gameObject.AddComponent<LatePainter>().Assigned = NewMaterial("Brass");
        _played.Cell.Frame(_played.Session);

        Assert.That(_played.Tool.sharedMaterial, Is.SameAs(_played.Substitute));
    }

    [Test]
    public void Show_OpaqueWithoutASubstitute_IsHiddenAndWarnsOnce()
    {
        _played.Appearance.With("_substitute", null);
        _played.Tool.sharedMaterial = NewMaterial("Steel");
        _played.BeCurrent();
        Assert.That(_played.Tool.isVisible, Is.True);

        _played.Hold();

        Assert.That(_played.Tool.isVisible, Is.False);
        var warnings = _played.Cell.Player.Logs.Where(l => l.Type == LogType.Warning && l.Message.Contains("'Steel'", StringComparison.Ordinal));
        Assert.That(warnings.Count(), Is.EqualTo(1));
    }

    [Test]
    public void Show_SubstituteWithoutAPattern_IsNotUsed()
    {
        _played.Appearance.With("_substitute", NewMaterial("Paint"));
        _played.Tool.sharedMaterial = NewMaterial("Steel");
        _played.BeCurrent();

        _played.Hold();

        Assert.That(_played.Tool.isVisible, Is.False);
    }

    [DefaultExecutionOrder(MrilSession.ExecutionOrder + 2)]
    sealed class LatePainter : MonoBehaviour
    {
        public Material Assigned { get; set; }

        void LateUpdate() => GetComponent<Renderer>().sharedMaterial = Assigned;
    }
}
