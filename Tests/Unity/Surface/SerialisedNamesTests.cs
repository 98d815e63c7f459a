using NUnit.Framework;

namespace Nowpose.Unity.Tests.Surface;

public class SerialisedNamesTests
{
    /// <summary>Lines of <see cref="SerialisedNames"/> of earlier versions, which a user's project may have stored.</summary>
    static readonly string[] Stored = File.ReadAllLines(Path.Combine(RepositoryFiles.Root, "Tests", "Unity", "Surface", "Serialised.txt"));

    [TestCase("script ", 25)]
    [TestCase("asset ", 45)]
    [TestCase("field ", 100)]
    [TestCase("value ", 10)]
    [TestCase("method ", 40)]
    public void SerialisedNames_StoredByAnEarlierVersion_Remain(string kind, int atLeast)
    {
        var stored = Stored.Where(line => line.StartsWith(kind, StringComparison.Ordinal)).ToList();

        Assert.That(stored, Has.Count.GreaterThanOrEqualTo(atLeast), "the list is not empty");
        Assert.That(stored.Except(SerialisedNames.All), Is.Empty, "scenes and prefabs of users would lose their values");
    }
}
