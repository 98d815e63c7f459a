using System.Text.RegularExpressions;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Shaders;

/// <summary>Tests that every variant of every shader compiles for both render pipelines, with substitutes for Unity's includes.</summary>
public sealed class ShaderCompileTests
{
    const string Broken = """
        Shader "Test/Broken"
        {
            SubShader
            {
                Pass
                {
                    Name "Only"
                    CGPROGRAM
                    #pragma vertex Project
                    #pragma fragment Shade
                    #pragma multi_compile_instancing
                    #include "UnityCG.cginc"
                    float4 Project(float4 position : POSITION) : SV_POSITION { return mul(UNITY_MATRIX_VP, position); }
                    #if defined(INSTANCING_ON) && defined(STEREO_MULTIVIEW_ON)
                    half4 Shade() : SV_Target { return 1 }
                    #else
                    half4 Shade() : SV_Target { return 1; }
                    #endif
                    ENDCG
                }
            }
        }
        """;

    static IEnumerable<PassProgram> Programs => ShaderFiles.Programs;

    [TestCaseSource(nameof(Programs))]
    public void Compile_EveryVariant_Succeeds(PassProgram program)
    {
        Glslang.Require();

        Assert.That(Glslang.Compile(program).ToList(), Is.Empty);
    }

    [Test]
    public void Programs_ShippedShadersAndExample_AreCovered()
    {
        Assert.That(ShaderFiles.Shipped.Select(s => s.Name), Is.EquivalentTo(new[] { "Nowpose/Hologram", "Nowpose/Occluder", "Nowpose/Text" }));
        Assert.That(ShaderFiles.Examples, Is.Not.Empty);
    }

    [Test]
    public void Compile_SyntaxErrorInOneVariant_NamesShaderPassVariantAndLine()
    {
        Glslang.Require();
        var shader = ShaderLabReader.Read(Broken, "Broken.shader");

        var errors = Glslang.Compile(ShaderFiles.Of(shader).Single()).ToList();

        // Both stages are compiled from the same text, so both report the error.
        Assert.That(errors, Is.Not.Empty);
        const string where = "Broken.shader, built-in, pass Only, STEREO_MULTIVIEW_ON INSTANCING_ON, ";
        Assert.That(errors.Where(e => !e.StartsWith(where, StringComparison.Ordinal)), Is.Empty);
        Assert.That(errors.Select(e => Regex.Match(e, "Broken.shader[:(](15)").Groups[1].Value), Has.Some.EqualTo("15"));
    }

    [TestCase("Hologram", "NowposeOpacity(fade, hatch, fragment.metres)", "NowposeOpacity(fade, hatch)")]
    [TestCase("Occluder", "UNITY_VERTEX_OUTPUT_STEREO", "UNITY_VERTEX_OUTPUT_STEREOS")]
    [TestCase("Text", "half4(fragment.colour.rgb, fragment.colour.a * letter)", "half4(fragment.color)")]
    public void Compile_FaultInASharedPass_ReportsItForBothPipelines(string name, string right, string wrong)
    {
        Glslang.Require();
        var folder = RepositoryFiles.Package + "/Runtime/Shaders/";
        var pass = RepositoryFiles.Read(folder + name + "Pass.hlsl");
        Assert.That(pass, Does.Contain(right));
        var text = RepositoryFiles.Read(folder + name + ".shader")
            .Replace($"#include \"{name}Pass.hlsl\"", pass.Replace(right, wrong, StringComparison.Ordinal), StringComparison.Ordinal);

        var programs = ShaderFiles.Of(ShaderLabReader.Read(text, folder + name + ".shader")).ToList();

        Assert.That(programs.Select(p => p.SubShader.Pipeline).Distinct(), Is.EquivalentTo(new[] { "URP", "built-in" }));
        foreach (var program in programs) Assert.That(Glslang.Compile(program).Any(), Is.True, $"{program}: has errors");
    }

    [Test]
    public void Variants_OfBothPipelines_MatchUnitysCount()
    {
        var counts = ShaderFiles.Programs.Select(p => (p.SubShader.IsUniversal, p.Variants.Count)).Distinct();

        Assert.That(counts, Is.EquivalentTo(new[] { (true, 6), (false, 8) }));
    }

    [Test]
    public void Variants_SeveralKeywordSets_AreCombined()
    {
        const string keywords = "#pragma multi_compile _ A B\n#pragma shader_feature_local C";
        var text = Broken.Replace("#pragma multi_compile_instancing", keywords, StringComparison.Ordinal);

        var variants = ShaderFiles.Of(ShaderLabReader.Read(text, "Broken.shader")).Single().Variants;

        Assert.That(variants, Has.Count.EqualTo(4 * 3 * 2));
        Assert.That(variants.Select(v => string.Join(" ", v)), Is.Unique.And.Contains("STEREO_INSTANCING_ON B C"));
    }
}
