using NUnit.Framework;

namespace Nowpose.Headless.Tests.Repository;

public class ReadmeCodeTests
{
    const string Package = "Packages/com.nowpose.mril";

    [Test]
    public void PackageReadme_ItsCode_IsCompiledByATest()
    {
        var root = RepositoryFiles.Root;
        var readme = File.ReadAllText(Path.Combine(root, Package, "README.md"));
        var example = Path.Combine(root, Package, "Tests/Editor/Core/Session/ReadmeExample.cs");
        var source = File.ReadAllLines(example).Select(line => line.Trim()).ToHashSet();

        var code = readme.Split("```csharp")[1].Split("```")[0].Split('\n').Select(line => line.Trim()).Where(line => line.Length > 0).ToList();

        Assert.That(code, Is.Not.Empty);
        Assert.That(code.Where(line => !source.Contains(line)), Is.Empty);
    }
}
