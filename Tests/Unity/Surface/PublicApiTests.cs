using System.Reflection;
using NUnit.Framework;

namespace Nowpose.Unity.Tests.Surface;

/// <summary>Compares the public API of each assembly with a list in the repository, so that a review shows each change of the API.</summary>
public class PublicApiTests
{
    /// <summary>Maximum number of public types, including nested types, in Core.</summary>
    const int MaxCoreTypes = 80;

    static readonly string[] Assemblies =
    [
        "Nowpose", "Nowpose.Unity", "Nowpose.Editor", "Nowpose.ArFoundation", "Nowpose.MRTK3", "Nowpose.OpenXR", "Nowpose.OpenXR.Anchoring",
    ];

    [TestCaseSource(nameof(Assemblies))]
    public void Assembly_PublicTypesAndMembers_MatchItsList(string name)
    {
        var list = Path.Combine(RepositoryFiles.Root, "Tests", "Unity", "Surface", name + ".txt");
        var actual = PublicApi.Of(Assembly.Load(name)).ToList();
        var written = Path.Combine(TestContext.CurrentContext.WorkDirectory, name + ".txt");
        File.WriteAllLines(written, actual);
        var listed = File.Exists(list) ? File.ReadAllLines(list) : [];

        Assert.That(actual.Except(listed), Is.Empty, $"public and not in the list; if this is intended, copy {written} to {list}");
        Assert.That(listed.Except(actual), Is.Empty, $"in the list but no longer public; if this is intended, copy {written} to {list}");
    }

    [Test]
    public void Core_NumberOfPublicTypes_IsWithinTheLimit() => Assert.That(
        Assembly.Load("Nowpose").GetExportedTypes().Length, Is.LessThanOrEqualTo(MaxCoreTypes),
        "make the new type internal; the product's own assemblies and tests can use internal types. Only types that users' scripts need are public");
}
