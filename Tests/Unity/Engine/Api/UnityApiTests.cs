using System.Reflection;
using NUnit.Framework;

namespace Nowpose.Unity.Tests.Engine.Api;

/// <summary>
/// The public members of a stand-in are a subset of Unity's, line by line: otherwise code could compile here and fail in Unity. The lists
/// hold the members in use, as read from Unity's own assemblies. To add a member, copy its line from there.
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
    public void PublicMember_OfTheStandIn_ExistsInUnity() => Assert.That(_made.Except(_listed), Is.Empty);

    [Test]
    public void Line_OfTheList_HasAMember() => Assert.That(_listed.Except(_made), Is.Empty);

    [Test]
    public void Line_OfTheList_ExistsInTheOldestUnity() => Assert.That(_listed.Where(l => l.Line.Contains("# not in", StringComparison.Ordinal)), Is.Empty);
}
