using System.Text.RegularExpressions;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Repository;

/// <summary>Finds calls of native libraries by name in code that UWP compiles. On a HoloLens, they throw DllNotFoundException.</summary>
/// <remarks>
/// UWP does not load a system library by name; see "Use P/Invoke" in Unity's manual. With "__Internal", the linker resolves the call.
/// </remarks>
public sealed partial class NativeCallTests
{
    static readonly string[] Sources = [.. RepositoryFiles.Under(RepositoryFiles.Package + "/Runtime", ".cs")];

    [Test]
    public void NativeCalls_InTheRuntime_AreLinkedOnUwp()
    {
        Assert.That(Sources.Where(file => Calls().IsMatch(RepositoryFiles.Read(file))), Is.Not.Empty);
        Assert.That(Sources.SelectMany(file => ByName(RepositoryFiles.Read(file)).Select(call => file + ": " + call)), Is.Empty);
    }

    [TestCase("[DllImport(\"kernel32.dll\")]")]
    [TestCase("[DllImport(\"kernel32\", ExactSpelling = true)]")]
    [TestCase("const string Library = \"kernel32.dll\"; [DllImport(Library)]")]
    [TestCase("#if UNITY_EDITOR\nconst string Library = \"__Internal\";\n#else\nconst string Library = \"a.dll\";\n#endif\n[DllImport(Library)]")]
    public void ByName_LibraryOnUwp_IsReported(string source) => Assert.That(ByName(source), Is.Not.Empty);

    [TestCase("[DllImport(\"__Internal\")]")]
    [TestCase("#if UNITY_WSA && !UNITY_EDITOR\nconst string A = \"__Internal\";\n#else\nconst string A = \"a.dll\";\n#endif\n[DllImport(A)]")]
    [TestCase("throw new DllNotFoundException(\"kernel32.dll\")")]
    public void ByName_LinkedOrNoCall_IsNotReported(string source) => Assert.That(ByName(source), Is.Empty);

    static IEnumerable<string> ByName(string source)
    {
        if (!Calls().IsMatch(source)) return [];
        return Name().Matches(OtherPlatforms().Replace(source, "${uwp}")).Select(m => m.Value);
    }

    [GeneratedRegex(@"\bDllImport\(")]
    private static partial Regex Calls();

    [GeneratedRegex(@"DllImport\(\s*""(?!__Internal"")[^""]*""|""[^""\s]*\.dll""")]
    private static partial Regex Name();

    // The code that UWP does not compile.
    [GeneratedRegex(@"#if UNITY_WSA && !UNITY_EDITOR\s(?<uwp>.*?)#else.*?#endif", RegexOptions.Singleline)]
    private static partial Regex OtherPlatforms();
}
