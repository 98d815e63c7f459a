using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Session;
using Nowpose.Unity;
using Nowpose.UnityPlayer;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Rendering;

/// <summary>Parts with the user's own materials look different while the pose is not current, with every kind of shader.</summary>
public sealed class PoseOwnMaterialTests
{
    const string Materials = RepositoryFiles.Package + "/Runtime/Materials/";

    /// <summary>Values of <c>_SrcBlend</c>.</summary>
    const int One = 1, SourceAlpha = 5;

    PlayedCell _cell;
    MrilSession _session;
    PoseAppearance _appearance;
    Renderer _tool;
    Material _substitute;

    /// <summary>Kinds of users' shaders: the package's own with a pattern, blended ones, opaque ones.</summary>
    public enum Sort
    {
        Patterned, Blended, BlendedUniversal, Premultiplied, BlendedUnknown, OpaqueDrawnLate, Opaque, OpaqueWithColour, OppositeFade, Several,
        SeveralOppositeFade, Missing,
    }

    [SetUp]
    public void Begin()
    {
        _cell = new PlayedCell();
        _session = _cell.NewSession(settings: new SessionSettings(
            new ConnectionSettings("127.0.0.1"), VisualisationLatency.FromMilliseconds(40),
            range: new ConstantLatencyRange(15, RenderTimeSourceKind.DisplayGpuTime), outsideRange: OutsideRangeResponse.GoOn));
        var rig = Child("Robot", _session.transform).AddComponent<RobotRig>();
        _tool = Child("Tool", rig.transform).AddComponent<MeshRenderer>();
        _substitute = NewMaterial("Substitute", ("_Fade", 0), ("_Hatch", 0));
        _appearance = rig.gameObject.AddComponent<PoseAppearance>().With("_substitute", _substitute);
    }

    [TearDown]
    public void End() => _cell.Dispose();

    static GameObject Child(string name, Transform parent)
    {
        var child = new GameObject(name);
        child.transform.SetParent(parent, false);
        return child;
    }

    static Material NewMaterial(string name, params (string Name, float Value)[] floats)
    {
        var material = new Material((Shader)null) { name = name, renderQueue = 2000 };
        foreach (var (property, value) in floats) material.SetFloat(property, value);
        return material;
    }

    static Material Blended(string colour, float alpha, int? sourceBlend = SourceAlpha)
    {
        var material = NewMaterial("Glass");
        material.renderQueue = 3000;
        if (sourceBlend.HasValue) material.SetFloat("_SrcBlend", sourceBlend.Value);
        material.SetColor(colour, new Color(1, 0.5f, 0.25f, alpha));
        return material;
    }

    static Material[] Of(Sort sort)
    {
        var coloured = NewMaterial("Steel");
        coloured.SetColor("_Color", Color.white);
        switch (sort)
        {
            case Sort.Patterned: return [NewMaterial("Hologram", ("_Fade", 0), ("_Hatch", 0))];
            case Sort.Blended: return [Blended("_Color", 0.8f)];
            case Sort.BlendedUniversal: return [Blended("_BaseColor", 0.8f)];
            case Sort.Premultiplied: return [Blended("_Color", 0.8f, One)];
            case Sort.BlendedUnknown: return [Blended("_Color", 0.8f, null)];
            case Sort.OpaqueDrawnLate: return [Blended("_Color", 1, One)];
            case Sort.OppositeFade: return [NewMaterial("Brass", ("_Fade", 1))];
            case Sort.SeveralOppositeFade: return [NewMaterial("Hologram", ("_Fade", 0), ("_Hatch", 0)), NewMaterial("Brass", ("_Fade", 1))];
            case Sort.Missing: return [null];
            case Sort.Opaque: return [NewMaterial("Steel")];
            case Sort.OpaqueWithColour: return [coloured];
            default: return [coloured, Blended("_Color", 1), NewMaterial("Hologram", ("_Fade", 0), ("_Hatch", 0))];
        }
    }

    void BeCurrent()
    {
        _session.gameObject.SetActive(true);
        Run(5);
        Assert.That(_session.Frame.State, Is.EqualTo(PoseState.Current));
    }

    void Run(double seconds) => _cell.Run(seconds, _session, () => { });

    void Hold()
    {
        _cell.IsPlantUp = false;
        Run(1);
        Assert.That(_session.Frame.State, Is.EqualTo(PoseState.Held));
    }

    /// <summary>Describes the drawn result: nothing, or each material with the changes of the property block.</summary>
    string Seen()
    {
        if (!_tool.isVisible) return "nothing";
        return string.Join(" | ", _tool.sharedMaterials.Select(Seen));
    }

    string Seen(Material material, int index)
    {
        if (material == null) return "magenta";
        // A property block of one material replaces that of the renderer.
        var block = new MaterialPropertyBlock();
        _tool.GetPropertyBlock(block, index);
        if (block.isEmpty) _tool.GetPropertyBlock(block);
        return Seen(material, block);
    }

    static string Seen(Material material, MaterialPropertyBlock block)
    {
        var seen = material.name;
        foreach (var name in new[] { "_Fade", "_Hatch" })
            if (material.HasProperty(name)) seen += " " + name + (block.HasFloat(name) ? block.GetFloat(name) : material.GetFloat(name));
        foreach (var name in new[] { "_Color", "_BaseColor" })
        {
            // A lower alpha is visible only with a material that blends by alpha.
            if (!material.HasProperty(name) || !material.HasProperty("_SrcBlend") || material.GetFloat("_SrcBlend") != SourceAlpha) continue;
            seen += " " + (block.HasColor(Shader.PropertyToID(name)) ? block.GetColor(name) : material.GetColor(name));
        }
        return seen;
    }

    [Test]
    public void Show_AnyMaterial_LooksDifferentOnlyWhileNotCurrent([Values] Sort sort, [Values] bool substitute)
    {
        _tool.sharedMaterials = Of(sort);
        if (!substitute) _appearance.With("_substitute", null);
        BeCurrent();
        var (current, materials) = (Seen(), _tool.sharedMaterials);

        Hold();
        var held = Seen();
        _cell.IsPlantUp = true;
        Run(1);

        Assert.That(held, Is.Not.EqualTo(current));
        if (substitute) Assert.That(held, Is.Not.EqualTo("nothing"));
        Assert.That(Seen(), Is.EqualTo(current));
        Assert.That(_tool.sharedMaterials, Is.EqualTo(materials));
    }

    [Test]
    public void OnDisable_WhileNotCurrent_RestoresTheMaterials([Values] Sort sort)
    {
        _tool.sharedMaterials = Of(sort);
        BeCurrent();
        var current = Seen();
        Hold();

        _appearance.enabled = false;

        Assert.That(Seen(), Is.EqualTo(current));
    }

    [TestCase("_Color")]
    [TestCase("_BaseColor")]
    public void Show_Blended_LowersTheAlphaAndKeepsTheColour(string colour)
    {
        _tool.sharedMaterial = Blended(colour, 0.8f);
        BeCurrent();

        Hold();

        var block = new MaterialPropertyBlock();
        _tool.GetPropertyBlock(block);
        Assert.That(block.GetColor(colour), Is.EqualTo(new Color(1, 0.5f, 0.25f, 0.8f * (1 - 0.8f * 0.5f))));
    }

    [Test]
    public void Show_FaintestStripedLook_LosesAtLeastFortyPercentOfTheAlpha()
    {
        _tool.sharedMaterial = Blended("_Color", 1);
        BeCurrent();

        for (var i = 0; i < 20; i++) _session.Session.Rendered(TimeSpan.FromMilliseconds(25), RenderTimeSourceKind.DisplayGpuTime);
        _cell.Frame(_session);
        Assert.That(_session.Frame.State, Is.EqualTo(PoseState.OutsideRange));
        Assert.That(_appearance.Look.Fade, Is.LessThan(0.5f));

        var block = new MaterialPropertyBlock();
        _tool.GetPropertyBlock(block);

        Assert.That(block.GetColor("_Color").a, Is.EqualTo(0.6f).Within(1e-6));
    }

    /// <summary>Graphics Tools Standard has a property _Fade with the opposite meaning of this package's: 1 is fully visible.</summary>
    [Test]
    public void Show_FadeWithoutHatch_IsUnchanged([Values] bool several)
    {
        var brass = NewMaterial("Brass", ("_Fade", 1));
        _tool.sharedMaterials = several ? [NewMaterial("Hologram", ("_Fade", 0), ("_Hatch", 0)), brass] : [brass];
        BeCurrent();
        Assert.That(_tool.HasPropertyBlock(), Is.False);

        Hold();
        Assert.That(Seen(), Does.EndWith("Substitute _Fade0.5 _Hatch1"), "as faint as the state says, not as the user's _Fade");
        if (several) Assert.That(Seen(), Does.StartWith("Hologram _Fade0.5 _Hatch1"));
        _cell.IsPlantUp = true;
        Run(1);
        brass.SetFloat("_Fade", 0.5f);

        Assert.That(Seen(), Does.EndWith("Brass _Fade0.5"), "the material's own value counts");
    }

    [Test]
    public void Show_SubstituteWithFade_KeepsTheFade()
    {
        _substitute.SetFloat("_Fade", 0.7f);
        _tool.sharedMaterial = NewMaterial("Brass", ("_Fade", 1));
        BeCurrent();

        Hold();

        Assert.That(Seen(), Is.EqualTo("Substitute _Fade0.7 _Hatch1"));
    }

    [Test]
    public void Show_OpaqueWithUserPropertyBlocks_RestoresThem([Values] bool changed)
    {
        _tool.sharedMaterials = [NewMaterial("Brass", ("_Fade", 1)), NewMaterial("Steel")];
        var (whole, single) = (new MaterialPropertyBlock(), new MaterialPropertyBlock());
        whole.SetFloat("_Fade", 0.75f);
        single.SetFloat("_Fade", 0.25f);
        _tool.SetPropertyBlock(whole);
        _tool.SetPropertyBlock(single, 1);
        BeCurrent();

        Hold();
        Assert.That(Seen(), Is.EqualTo("Substitute _Fade0.5 _Hatch1 | Substitute _Fade0.5 _Hatch1"));
        if (changed) _tool.sharedMaterials = [NewMaterial("Paint", ("_Fade", 1)), NewMaterial("Paint", ("_Fade", 1))];
        _cell.IsPlantUp = true;
        Run(1);

        var block = new MaterialPropertyBlock();
        _tool.GetPropertyBlock(block);
        Assert.That(block.GetFloat("_Fade"), Is.EqualTo(0.75f));
        Assert.That(block.HasFloat(Shader.PropertyToID("_Hatch")), Is.False);
        _tool.GetPropertyBlock(block, 0);
        Assert.That(block.isEmpty, Is.True);
        _tool.GetPropertyBlock(block, 1);
        Assert.That(block.GetFloat("_Fade"), Is.EqualTo(0.25f));
    }

    [Test]
    public void Show_PatternReplacedByAnOppositeFade_DoesNotChangeTheNewMaterial()
    {
        _tool.sharedMaterial = NewMaterial("Hologram", ("_Fade", 0), ("_Hatch", 0));
        BeCurrent();

        _tool.sharedMaterial = NewMaterial("Brass", ("_Fade", 1));
        Hold();
        _cell.IsPlantUp = true;
        Run(1);

        Assert.That(Seen(), Is.EqualTo("Brass _Fade1"));
    }

    [Test]
    public void Show_MissingMaterial_WarnsWithThePartsName([Values] bool substitute)
    {
        if (!substitute) _appearance.With("_substitute", null);
        BeCurrent();

        Hold();

        Assert.That(Seen(), Is.EqualTo(substitute ? "Substitute _Fade0.5 _Hatch1" : "nothing"));
        var said = _cell.Player.Logs.Where(l => l.Message.Contains("a material of 'Tool' is missing", StringComparison.Ordinal));
        Assert.That(said.Count(), Is.EqualTo(1));
    }

    [Test]
    public void Show_BlendedWithoutUserPropertyBlock_RemovesThePackagesBlock()
    {
        var material = Blended("_Color", 1);
        _tool.sharedMaterial = material;
        BeCurrent();
        Hold();
        Assert.That(_tool.HasPropertyBlock(), Is.True);

        _cell.IsPlantUp = true;
        Run(1);

        Assert.That(_tool.HasPropertyBlock(), Is.False, "the material's colour counts again");
    }

    [Test]
    public void Show_BlendedWithUserPropertyBlock_RestoresItsColour()
    {
        _tool.sharedMaterial = Blended("_Color", 1);
        var block = new MaterialPropertyBlock();
        block.SetColor(Shader.PropertyToID("_Color"), new Color(0, 1, 0, 0.5f));
        _tool.SetPropertyBlock(block);
        BeCurrent();

        Hold();
        _tool.GetPropertyBlock(block);
        var held = block.GetColor("_Color");
        _cell.IsPlantUp = true;
        Run(1);
        _tool.GetPropertyBlock(block);

        Assert.That(held, Is.EqualTo(new Color(0, 1, 0, 0.5f * 0.6f)));
        Assert.That(block.GetColor("_Color"), Is.EqualTo(new Color(0, 1, 0, 0.5f)));
    }

    [Test]
    public void Show_Opaque_IsDrawnWithTheStripedSubstituteAndLogsOnce()
    {
        _tool.sharedMaterial = NewMaterial("Steel");
        BeCurrent();

        Hold();
        _appearance.Refresh();

        Assert.That(Seen(), Is.EqualTo("Substitute _Fade0.5 _Hatch1"));
        var said = _cell.Player.Logs.Where(l => l.Message.Contains("'Steel'", StringComparison.Ordinal)).ToList();
        Assert.That(said, Has.Count.EqualTo(1));
        Assert.That(said[0].Type, Is.EqualTo(LogType.Log));
        Assert.That(said[0].Message, Does.Contain("'Substitute'").And.Contain("NowposePose.hlsl"));
    }

    [Test]
    public void Show_OpaqueWithoutASubstitute_IsHiddenAndWarnsOnce()
    {
        _appearance.With("_substitute", null);
        _tool.sharedMaterial = NewMaterial("Steel");
        BeCurrent();
        Assert.That(_tool.isVisible, Is.True);

        Hold();

        Assert.That(_tool.isVisible, Is.False);
        var warnings = _cell.Player.Logs.Where(l => l.Type == LogType.Warning && l.Message.Contains("'Steel'", StringComparison.Ordinal));
        Assert.That(warnings.Count(), Is.EqualTo(1));
    }

    [Test]
    public void Show_SubstituteWithoutAPattern_IsNotUsed()
    {
        _appearance.With("_substitute", NewMaterial("Paint"));
        _tool.sharedMaterial = NewMaterial("Steel");
        BeCurrent();

        Hold();

        Assert.That(_tool.isVisible, Is.False);
    }

    [Test]
    public void Show_MaterialChangedWhileNotCurrent_KeepsTheNewMaterial()
    {
        _tool.sharedMaterial = NewMaterial("Steel");
        BeCurrent();
        Hold();
        var brass = NewMaterial("Brass");

        _tool.sharedMaterial = brass;
        _cell.IsPlantUp = true;
        Run(1);
        var current = _tool.sharedMaterial;
        Hold();

        Assert.That(current, Is.SameAs(brass));
        Assert.That(_tool.sharedMaterial, Is.SameAs(_substitute));
    }

    [TestCase("Occluder.mat", "Occluder")]
    [TestCase("Solid.mat", "Solid _Fade0.5 _Hatch1")]
    [TestCase("Text.mat", "Text")]
    public void Show_MaterialOfThePackage_KeepsIt(string file, string expected)
    {
        _tool.sharedMaterial = new AssetLibrary(RepositoryFiles.Root).Load<Material>(Materials + file);
        BeCurrent();

        Hold();

        Assert.That(Seen(), Is.EqualTo(expected));
        Assert.That(_cell.Player.Logs.Where(l => l.Message.Contains("of 'Tool'", StringComparison.Ordinal)), Is.Empty);
    }

    [Test]
    public void Show_ChangingStates_AllocatesNothing([Values(Sort.Blended, Sort.Opaque, Sort.Several, Sort.SeveralOppositeFade)] Sort sort)
    {
        _tool.sharedMaterials = Of(sort);
        _session.gameObject.SetActive(true);
        var frame = 0;
        void Cycle() => _cell.Run(40, _session, () => _cell.IsPlantUp = frame++ % 40 < 12);
        Cycle();

        var allocated = _cell.AllocatedIn(Cycle);

        Assert.That(allocated, Is.EqualTo(0));
    }
}
