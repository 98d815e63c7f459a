using System.Text.RegularExpressions;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Repository;

/// <summary>What single-pass instanced rendering needs of a shader: without one of these one eye sees nothing, or what the other sees.</summary>
public sealed class ShaderTests
{
    static IEnumerable<string> Shaders => RepositoryFiles.Under(RepositoryFiles.Package, ".shader");

    [Test]
    public void Shaders_Package_HasThem()
    {
        Assert.That(Shaders.Select(Path.GetFileName), Is.EquivalentTo(new[] { "Hologram.shader", "Occluder.shader" }));
    }

    [TestCaseSource(nameof(Shaders))]
    public void Shader_Name_IsOursAndThatOfItsFile(string path)
    {
        var name = Regex.Match(RepositoryFiles.Read(path), "(?m)^Shader \"([^\"]+)\"").Groups[1].Value;

        Assert.That(name, Is.EqualTo("Nowpose/" + Path.GetFileNameWithoutExtension(path)));
    }

    [TestCaseSource(nameof(Shaders))]
    public void Shader_EveryPass_ServesBothEyesAtOnce(string path)
    {
        var passes = Regex.Matches(RepositoryFiles.Read(path), "CGPROGRAM(.*?)ENDCG", RegexOptions.Singleline)
            .Select(m => m.Groups[1].Value).ToList();
        var needed = new[]
        {
            "#pragma multi_compile_instancing", "UNITY_VERTEX_INPUT_INSTANCE_ID", "UNITY_VERTEX_OUTPUT_STEREO", "UNITY_SETUP_INSTANCE_ID(vertex)",
            "UNITY_INITIALIZE_OUTPUT(Fragment, fragment)", "UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(fragment)",
            "UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(fragment)",
        };

        Assert.That(passes, Is.Not.Empty);
        foreach (var pass in passes) Assert.That(needed.Where(n => !pass.Contains(n, StringComparison.Ordinal)), Is.Empty);
    }

    [Test]
    public void Occluder_Pass_WritesDepthOnlyAndFirst()
    {
        var text = RepositoryFiles.Read(RepositoryFiles.Package + "/Runtime/Shaders/Occluder.shader");

        Assert.That(text, Does.Contain("ColorMask 0").And.Contain("ZWrite On").And.Contain("\"Queue\" = \"Geometry-10\""));
    }
}
