using NUnit.Framework;

namespace Nowpose.Headless.Tests.Repository;

/// <summary>
/// Checks that the code in the package's documents compiles: each line of the code must be in an example file of the package's tests.
/// </summary>
public sealed class DocumentCodeTests
{
    const string Tests = RepositoryFiles.Package + "/Tests/Editor";

    static readonly HashSet<string> Compiled = RepositoryFiles.Under(Tests, ".cs")
        .Where(f => Path.GetFileNameWithoutExtension(f) is "ReadmeExample" or "ManualExamples")
        .SelectMany(Lines)
        .ToHashSet();

    static IEnumerable<string> Documents => RepositoryFiles.Under(RepositoryFiles.Package, ".md");

    [TestCaseSource(nameof(Documents))]
    public void Document_Code_IsCompiledByATest(string path)
    {
        Assert.That(CodeIn(path).Where(line => !Compiled.Contains(line)), Is.Empty);
    }

    [TestCase(RepositoryFiles.Package + "/README.md")]
    [TestCase(RepositoryFiles.Package + "/Documentation~/session.md")]
    public void Document_WithAnExample_ContainsCode(string path)
    {
        Assert.That(CodeIn(path), Is.Not.Empty);
    }

    static IEnumerable<string> CodeIn(string path)
    {
        var isCode = false;
        foreach (var line in Lines(path))
        {
            if (line.StartsWith("```", StringComparison.Ordinal)) isCode = line == "```csharp";
            else if (isCode && line.Length > 0) yield return line;
        }
    }

    static IEnumerable<string> Lines(string path) => RepositoryFiles.Read(path).Split('\n').Select(line => line.Trim());
}
