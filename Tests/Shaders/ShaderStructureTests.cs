using System.Text.RegularExpressions;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Shaders;

/// <summary>Checks what Unity, URP's SRP batcher and single-pass instanced stereo require of a shader's structure.</summary>
public sealed class ShaderStructureTests
{
    const string Shaders = RepositoryFiles.Package + "/Runtime/Shaders/";

    static readonly Regex Buffers = new(
        @"(UNITY_INSTANCING_BUFFER_START|CBUFFER_START)\(UnityPerMaterial\)(?<members>.*?)(UNITY_INSTANCING_BUFFER_END|CBUFFER_END)",
        RegexOptions.Singleline | RegexOptions.CultureInvariant);

    static readonly Regex Members = new(
        @"UNITY_DEFINE_INSTANCED_PROP\((?<type>\w+), (?<name>\w+)\)|^\s*(?<type>\w+)\s+(?<name>\w+);",
        RegexOptions.Multiline | RegexOptions.CultureInvariant);

    static readonly Dictionary<string, string[]> KnownTags = new()
    {
        ["RenderPipeline"] = ["UniversalPipeline"],
        ["RenderType"] = ["Opaque", "Transparent", "TransparentCutout"],
        ["Queue"] = ["Background", "Geometry-10", "Geometry", "AlphaTest", "Transparent"],
        ["IgnoreProjector"] = ["True"],
        ["DisableBatching"] = ["True"],
        ["PoseAppearance"] = ["Ignore", "Alpha"],
    };

    static IEnumerable<ShaderSource> All => ShaderFiles.Shipped.Concat(ShaderFiles.Examples);

    static IEnumerable<ShaderSource> Shipped => ShaderFiles.Shipped;

    static IEnumerable<PassProgram> Programs => ShaderFiles.Programs;

    [TestCaseSource(nameof(Shipped))]
    public void Shader_Name_MatchesItsFile(ShaderSource shader)
    {
        Assert.That(shader.Name, Is.EqualTo("Nowpose/" + Path.GetFileNameWithoutExtension(shader.Path)));
    }

    /// <summary>URP uses the first SubShader that has the tag of URP or no tag.</summary>
    [TestCaseSource(nameof(Shipped))]
    public void Shader_SubShaders_UrpComesBeforeTheBuiltInPipeline(ShaderSource shader)
    {
        Assert.That(shader.SubShaders.Select(s => s.Pipeline), Is.EqualTo(new[] { "URP", "built-in" }));
        Assert.That(shader.SubShaders[0].Requirements, Is.EqualTo(new[] { "com.unity.render-pipelines.universal" }));
        Assert.That(shader.SubShaders[1].Requirements, Is.Empty);
        var modes = shader.SubShaders[0].Passes.Select(p => p.Tags.GetValueOrDefault("LightMode"));
        Assert.That(modes, Is.SubsetOf(new[] { "UniversalForwardOnly", "DepthOnly" }));
        Assert.That(shader.SubShaders[1].Passes.Select(p => p.Tags.Count), Is.All.Zero);
    }

    [TestCaseSource(nameof(All))]
    public void Shader_Tags_AreKnown(ShaderSource shader)
    {
        foreach (var (name, value) in shader.SubShaders.SelectMany(s => s.Tags))
        {
            Assert.That(KnownTags, Contains.Key(name));
            Assert.That(KnownTags[name], Does.Contain(value));
        }
    }

    [TestCaseSource(nameof(Shipped))]
    public void Shader_TagsAndMainPass_AreTheSameInBothPipelines(ShaderSource shader)
    {
        Assert.That(shader.SubShaders[0].Tags.Where(t => t.Key != "RenderPipeline"), Is.EquivalentTo(shader.SubShaders[1].Tags));
        Assert.That(shader.SubShaders[0].Passes[0].States, Is.EquivalentTo(shader.SubShaders[1].Passes[0].States));
    }

    /// <summary>
    /// The SRP batcher requires that this buffer contains every property except textures and render states, and that it is the same in every pass.
    /// </summary>
    [TestCaseSource(nameof(Programs))]
    public void Program_MaterialBuffer_ContainsAllProperties(PassProgram program)
    {
        var states = program.Shader.SubShaders.SelectMany(s => s.Passes).SelectMany(p => p.States.Values).ToHashSet();
        var expected = program.Shader.Properties.Where(p => p.Type != "2D" && !states.Contains($"[ {p.Name} ]"))
            .Select(p => (p.Name, p.Type is "Color" or "Vector" ? "float4" : "float"));

        var buffers = Buffers.Matches(program.OwnText);

        Assert.That(buffers, Has.Count.EqualTo(expected.Any() ? 1 : 0));
        var members = buffers.SelectMany(b => Members.Matches(b.Groups["members"].Value))
            .Select(m => (m.Groups["name"].Value, m.Groups["type"].Value));
        Assert.That(members, Is.EqualTo(expected));
        foreach (var texture in program.Shader.Properties.Where(p => p.Type == "2D"))
            Assert.That(program.OwnText, Does.Match($@"Texture2D {texture.Name};\s+SamplerState sampler{texture.Name};"));
    }

    [TestCaseSource(nameof(Programs))]
    public void Program_Stereo_SupportsSinglePassInstanced(PassProgram program)
    {
        string[] needed =
        [
            "#pragma multi_compile_instancing", "UNITY_VERTEX_INPUT_INSTANCE_ID", "UNITY_VERTEX_OUTPUT_STEREO", "UNITY_SETUP_INSTANCE_ID(vertex)",
            "(Fragment)0", "UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(fragment)", "UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(fragment)",
        ];

        Assert.That(needed.Where(n => !program.OwnText.Contains(n, StringComparison.Ordinal)), Is.Empty);
        Assert.That(program.OwnText, Does.Match($@"\b{program.VertexFunction}\(Vertex vertex\)"));
        Assert.That(program.OwnText, Does.Match($@"\b{program.FragmentFunction}\(Fragment fragment\) : SV_Target"));
        Assert.That(program.Pass.Program.IsCg, Is.Not.EqualTo(program.SubShader.IsUniversal));
    }

    [Test]
    public void OccluderShader_Passes_WriteOnlyDepthAndAreDrawnFirst()
    {
        var shader = ShaderLabReader.Read(RepositoryFiles.Read(Shaders + "Occluder.shader"), "Occluder.shader");

        Assert.That(shader.SubShaders.Select(s => s.Tags["Queue"]), Is.Not.Empty.And.All.EqualTo("Geometry-10"));
        foreach (var pass in shader.SubShaders.SelectMany(s => s.Passes))
        {
            Assert.That(pass.States["ColorMask"], Is.EqualTo("0"));
            Assert.That(pass.States["ZWrite"], Is.EqualTo("On"));
        }
    }

    /// <summary>The font's shader has ZTest Always and ZWrite Off. Its text would cover hands and arm, and have no depth for reprojection.</summary>
    [Test]
    public void TextShader_Passes_TestAndWriteDepth()
    {
        var shader = ShaderLabReader.Read(RepositoryFiles.Read(Shaders + "Text.shader"), "Text.shader");

        var programs = ShaderFiles.Of(shader with { Path = Shaders + "Text.shader" }).ToArray();
        Assert.That(programs, Is.Not.Empty);
        foreach (var program in programs)
        {
            Assert.That(program.Pass.States["ZTest"], Is.EqualTo("LEqual"));
            Assert.That(program.Pass.States["ZWrite"], Is.EqualTo("On"));
            Assert.That(program.OwnText, Does.Contain("clip("));
        }
    }

    [Test]
    public void HologramShader_Passes_WriteDepthUnlessTheMaterialSwitchesItOff()
    {
        var text = RepositoryFiles.Read(Shaders + "Hologram.shader");
        var shader = ShaderLabReader.Read(text, "Hologram.shader");

        Assert.That(shader.SubShaders.Select(s => s.Passes[0].States["ZWrite"]), Is.EqualTo(new[] { "[ _ZWrite ]", "[ _ZWrite ]" }));
        Assert.That(text, Does.Match(@"_ZWrite \(""[^\n]*\) = 1\n"), "a material without the property writes depth");
        Assert.That(shader.SubShaders[0].Passes[1].States["ZWrite"], Is.EqualTo("On"));
    }

    [TestCase("}", "", "'(' is expected")]
    [TestCase("\n    }\n}\n", "\n    }\n", "braces do not match")]
    [TestCase("\n    }\n}\n", "\n    }\n}\n}\n", "braces do not match")]
    [TestCase("\"Queue\" = \"Transparent\"", "\"Queue\" \"Transparent\"", "'=' is expected")]
    [TestCase("ZWrite On", "ZWirte On", "'ZWirte' is not understood")]
    [TestCase("(0.25, 0.75, 1, 1)", "(0.25, 0.75, 1)", "',' is expected")]
    [TestCase("Range(0, 1)) = 0", "Range(0, 1)) =", "not a number")]
    [TestCase("ENDHLSL", "ENDCG", "ends as the other kind")]
    [TestCase("_Hatch (\"", "_Fade (\"", "property _Fade is declared twice")]
    public void Read_InvalidStructure_ThrowsWithTheLine(string right, string wrong, string problem)
    {
        var text = RepositoryFiles.Read(Shaders + "Hologram.shader");
        var at = text.IndexOf(right, StringComparison.Ordinal);

        Assert.That(() => ShaderLabReader.Read(text.Remove(at, right.Length).Insert(at, wrong), "Hologram.shader"),
            Throws.TypeOf<ShaderLabException>().With.Message.Match(@"^Hologram\.shader:\d+: ").And.Message.Contains(problem));
    }

    [Test]
    public void NowposePose_Stripes_AreOneCentimetreWideInObjectSpace()
    {
        var include = RepositoryFiles.Read(Shaders + "NowposePose.hlsl");

        Assert.That(include, Does.Contain("#define NOWPOSE_STRIPE_METRES 0.01").And.Contain("UNITY_MATRIX_M"));
        Assert.That(Regex.Matches(include, "SV_Position|VPOS|screen", RegexOptions.IgnoreCase), Is.Empty);
    }

    /// <summary>
    /// The columns of the object-to-world matrix are the object's axes in the world, and their lengths are its scale. If the scale were ignored,
    /// the stripes of a part in millimetres, scaled by 0.001, would be 10 m wide.
    /// </summary>
    [Test]
    public void NowposeMetres_ScaledObject_ReturnsMetres()
    {
        var include = RepositoryFiles.Read(Shaders + "NowposePose.hlsl");

        var function = Regex.Match(include, @"float3 NowposeMetres\(float3 objectPosition\)\s*\{(?<body>.*?)\}", RegexOptions.Singleline);

        Assert.That(Regex.Replace(function.Groups["body"].Value, @"\s+", " ").Trim(), Is.EqualTo(
            "float3x3 axes = transpose((float3x3)UNITY_MATRIX_M); "
            + "return objectPosition * float3(length(axes[0]), length(axes[1]), length(axes[2]));"));
    }
}
