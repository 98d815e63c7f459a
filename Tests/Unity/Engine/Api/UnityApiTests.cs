using System.Reflection;
using NUnit.Framework;

namespace Nowpose.Unity.Tests.Engine.Api;

/// <summary>
/// Tests that the public members of a stand-in exist in Unity with the same signatures; otherwise code could compile here but not in Unity. The
/// lists contain the members in use, as they are in Unity's assemblies.
/// </summary>
[TestFixture("UnityEngine", "Api/unity-api-used.txt")]
[TestFixture("UnityEditor", "Api/unity-editor-api-used.txt")]
[TestFixture("MixedReality.Toolkit", "Api/mrtk3-api-used.txt")]
[TestFixture("Unity.XR.CoreUtils", "Api/core-utils-api-used.txt")]
[TestFixture("Unity.XR.ARSubsystems", "Api/ar-subsystems-api-used.txt")]
[TestFixture("Unity.XR.ARFoundation", "Api/ar-foundation-api-used.txt")]
[TestFixture("Unity.XR.OpenXR", "Api/openxr-api-used.txt")]
[TestFixture("Microsoft.MixedReality.OpenXR", "Api/mixed-reality-openxr-api-used.txt")]
public sealed class UnityApiTests(string assembly, string list)
{
    (string Type, string Line)[] _listed = [];
    (string Type, string Line)[] _made = [];

    [OneTimeSetUp]
    public void ReadBoth()
    {
        _listed = ListedApi.Read(Path.Combine(RepositoryFiles.Root, "Tests/Unity/Engine", list)).ToArray();
        _made = Assembly.Load(assembly).GetExportedTypes().SelectMany(t => ApiLines.Of(t).Select(l => (TypeLines.Of(t), l))).ToArray();
    }

    [Test]
    public void StandIn_PublicMembers_ExistInUnity() => Assert.That(
        _made.Except(_listed), Is.Empty, $"if these members exist in Unity's assembly with the same signature, add their lines to {list}");

    [Test]
    public void List_EachLine_HasAMemberInTheStandIn() => Assert.That(
        _listed.Except(_made), Is.Empty, $"implement these members in Headless/StandIn, or remove their lines from {list}");

    [Test]
    public void List_EachLine_ExistsInTheOldestSupportedUnity() => Assert.That(
        _listed.Where(l => l.Line.Contains("# not in", StringComparison.Ordinal)), Is.Empty);
}
