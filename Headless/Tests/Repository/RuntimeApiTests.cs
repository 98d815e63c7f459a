using NUnit.Framework;

namespace Nowpose.Headless.Tests.Repository;

/// <summary>Members of the engine that compile everywhere and fail in some players.</summary>
public sealed class RuntimeApiTests
{
    // It adds a collider, and throws in a player from which colliders were stripped because nothing else in the project has one.
    [TestCase("CreatePrimitive")]
    public void Runtime_Sources_DoNotUseIt(string member)
    {
        var sources = new[] { "/Runtime", "/Samples~" }.SelectMany(folder => RepositoryFiles.Under(RepositoryFiles.Package + folder, ".cs"));

        Assert.That(sources.Where(s => CSharpCode.Of(RepositoryFiles.Read(s)).Contains(member, StringComparison.Ordinal)), Is.Empty);
    }
}
