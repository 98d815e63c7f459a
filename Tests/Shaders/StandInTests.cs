using NUnit.Framework;

namespace Nowpose.Headless.Tests.Shaders;

/// <summary>Tests that the substitutes declare, and the shaders use, only names that exist in Unity's includes.</summary>
public sealed class StandInTests
{
    static readonly IReadOnlyDictionary<string, IReadOnlySet<string>> Known = UnityNames.Read();

    static IEnumerable<PassProgram> Programs => ShaderFiles.Programs;

    static IEnumerable<string> StandIns => RepositoryFiles.All.Where(f => f.StartsWith(PassProgram.StandIns + "/", StringComparison.Ordinal));

    [Test]
    public void StandIns_DeclaredNames_ExistInUnitysIncludes([Values("UnityCG.cginc", "Core.hlsl")] string include)
    {
        var declared = StandIns.SelectMany(f => UnityNames.DeclaredBy(RepositoryFiles.Read(f))).Distinct().ToList();

        Assert.That(declared, Has.Count.GreaterThan(20));
        Assert.That(declared.Where(n => !Known[include].Contains(n)), Is.Empty, "not in " + UnityNames.List);
    }

    [TestCaseSource(nameof(Programs))]
    public void Program_NamesOfUnity_ExistInTheInclude(PassProgram program)
    {
        Assert.That(program.UnityIncludes, Is.EqualTo(new[] { program.SubShader.IsUniversal ? "Core.hlsl" : "UnityCG.cginc" }));
        var used = UnityNames.UsedBy(program.OwnText).ToList();

        Assert.That(used, Is.Not.Empty);
        Assert.That(used.Where(n => !Known[program.UnityIncludes[0]].Contains(n)), Is.Empty, "not in " + UnityNames.List);
    }

    [TestCase("#define UNITY_OWN 1", "UNITY_OWN")]
    [TestCase("    float4x4 unity_Own[2];", "unity_Own")]
    [TestCase("static uint unity_Own;", "unity_Own")]
    [TestCase("float4 OwnTransform(float4 position)", "OwnTransform")]
    [TestCase("    UNITY_DEFINE_INSTANCED_PROP(float4x4, unity_Own)", "unity_Own")]
    public void DeclaredBy_EachKindOfDeclaration_ReturnsTheName(string text, string name)
    {
        Assert.That(UnityNames.DeclaredBy(text), Is.EqualTo(new[] { name }));
    }

    /// <summary>A pattern in screen space would differ between the eyes and move relative to the part, so such names are not allowed.</summary>
    [TestCase("float4 screen = ComputeScreenPos(position);", "ComputeScreenPos")]
    [TestCase("place.x *= _ScreenParams.x;", "_ScreenParams")]
    public void NamesList_ScreenSpaceName_IsNotAllowed(string text, string name)
    {
        Assert.That(UnityNames.UsedBy(text), Is.EqualTo(new[] { name }));
        Assert.That(Known.Values.Where(names => names.Contains(name)), Is.Empty);
    }
}
