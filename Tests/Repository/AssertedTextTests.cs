using System.Text.RegularExpressions;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Repository;

/// <summary>
/// Checks that assertions use the members of a message catalogue instead of repeating parts of its texts. Otherwise a better wording would break
/// tests of other things, and two texts with the same part could not be distinguished.
/// </summary>
public sealed partial class AssertedTextTests
{
    /// <summary>Number of consecutive words from which a text counts as a copy.</summary>
    const int MinWords = 4;

    /// <summary>Files whose own texts have words in common with a catalogue, and the number of these texts.</summary>
    static readonly Dictionary<string, int> Exceptions = new()
    {
        ["Tests/Benchmarks/LinkScoreTests.cs"] = 1,
    };

    /// <summary>Catalogues whose members the tests can use.</summary>
    static readonly string[] Products = [RepositoryFiles.Package + "/Runtime/", RepositoryFiles.Package + "/Editor/", "Gateway/", "Cli/"];

    static IEnumerable<string> Tests =>
        RepositoryFiles.Under("Tests", ".cs").Concat(RepositoryFiles.Under(RepositoryFiles.Package + "/Tests", ".cs"));

    static HashSet<string> CatalogueParts() =>
    [
        .. RepositoryFiles.All.Where(file => file.Contains("/Messages/", StringComparison.Ordinal) && file.EndsWith(".cs", StringComparison.Ordinal)
            && Products.Any(product => file.StartsWith(product, StringComparison.Ordinal)))
            .SelectMany(file => SourceTexts.In(RepositoryFiles.Read(file))).SelectMany(text => PartsOf(text.Text)),
    ];

    [Test]
    public void Assertions_OfAllTests_UseTheCatalogues()
    {
        var parts = CatalogueParts();

        var found = Tests.Select(file => (File: file, Texts: CopiesIn(RepositoryFiles.Read(file), parts).ToList()))
            .Where(test => test.Texts.Count != Exceptions.GetValueOrDefault(test.File))
            .Select(test => $"{test.File}: {test.Texts.Count} texts:\n  {string.Join("\n  ", test.Texts)}");

        Assert.That(parts, Has.Count.GreaterThan(1000));
        Assert.That(found, Is.Empty, "compare with the member of the catalogue, with its arguments");
    }

    [TestCase("Assert.That(a, Does.Contain(\"the arm has no rig; assign one\"));", 1)]
    [TestCase("Assert.That(a, Is.EqualTo($\"{name}: The arm has no rig\"));", 1)]
    [TestCase("Assert.That(a.Count(m => m.Contains(\"the arm has no rig\")), Is.EqualTo(1));", 1)]
    [TestCase("Assert.That(a, Is.EqualTo(b), \"the arm has no rig\");", 0)]
    [TestCase("Assert.That(a, Does.Contain(\"the arm has 2 rigs\"));", 0)]
    [TestCase("var a = \"the arm has no rig\";", 0)]
    public void CopiesIn_SampleSource_FindsTextsOfConstraints(string source, int count) =>
        Assert.That(CopiesIn(source, [.. PartsOf("0: the arm has no rig, so it does not move")]).Count(), Is.EqualTo(count));

    static IEnumerable<string> CopiesIn(string source, HashSet<string> parts) => SourceTexts.In(source)
        .Where(text => Constraint().IsMatch(text.Call) && PartsOf(text.Text).Any(parts.Contains)).Select(text => text.Text);

    /// <summary>Returns all sequences of <see cref="MinWords"/> words that no value interrupts.</summary>
    static IEnumerable<string> PartsOf(string text)
    {
        var words = new Queue<string>();
        foreach (var part in text.Split((char[])null, StringSplitOptions.RemoveEmptyEntries))
        {
            if (SourceTexts.WordsIn(part) == 0) words.Clear();
            else words.Enqueue(part.Trim(Punctuation).ToLowerInvariant());
            if (words.Count > MinWords) words.Dequeue();
            if (words.Count == MinWords) yield return string.Join(' ', words);
        }
    }

    static readonly char[] Punctuation = [.. "()[]{}\"“”‘’'<>.,:;?!…"];

    [GeneratedRegex(@"(?:^|\.)(?:EqualTo|Contains?|StartsWith|StartWith|EndsWith|EndWith|Match|Matches|ExpectErrorAsync)$")]
    private static partial Regex Constraint();
}
