using System.Reflection;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Engine.Api;

/// <summary>
/// What a stand-in shows to scripts is Unity's, line by line, and no more: else code could compile here and not there. The lists hold the
/// lines for the members in use, as they were read from Unity's own assemblies; a line is added by copying it from there.
/// </summary>
[TestFixture("UnityEngine", "UnityEngine/Api/unity-api-used.txt")]
[TestFixture("UnityEditor", "UnityEngine/Api/unity-editor-api-used.txt")]
[TestFixture("MixedReality.Toolkit", "UnityEngine/Api/mrtk3-api-used.txt")]
[TestFixture("Unity.XR.CoreUtils", "UnityEngine/Api/core-utils-api-used.txt")]
[TestFixture("Unity.XR.ARSubsystems", "UnityEngine/Api/ar-subsystems-api-used.txt")]
[TestFixture("Unity.XR.ARFoundation", "UnityEngine/Api/ar-foundation-api-used.txt")]
[TestFixture("Unity.XR.OpenXR", "UnityEngine/Api/openxr-api-used.txt")]
[TestFixture("Microsoft.MixedReality.OpenXR", "UnityEngine/Api/mixed-reality-openxr-api-used.txt")]
public sealed class UnityApiTests(string assembly, string list)
{
    (string Type, string Line)[] _listed = [];
    (string Type, string Line)[] _made = [];

    [OneTimeSetUp]
    public void ReadBoth()
    {
        _listed = ListedApi.Read(Path.Combine(Repository.RepositoryFiles.Root, "Headless/Tests", list)).ToArray();
        _made = Assembly.Load(assembly).GetExportedTypes().SelectMany(t => ApiLines.Of(t).Select(l => (TypeLines.Of(t), l))).ToArray();
    }

    [Test]
    public void EveryPublicMember_IsUnitys() => Assert.That(_made.Except(_listed), Is.Empty);

    [Test]
    public void EveryLine_HasItsMember() => Assert.That(_listed.Except(_made), Is.Empty);

    [Test]
    public void EveryLine_IsInTheOldestUnity() => Assert.That(_listed.Where(l => l.Line.Contains("# not in", StringComparison.Ordinal)), Is.Empty);
}
