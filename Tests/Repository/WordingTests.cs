using System.Text.RegularExpressions;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Repository;

/// <summary>Checks that texts and names use the field's terms instead of the private words that CONTRIBUTING.md lists.</summary>
/// <remarks>The check finds wrong words but not unclear sentences, so it does not replace a reader.</remarks>
public sealed partial class WordingTests
{
    const string Contributing = "CONTRIBUTING.md";

    static readonly string[] Exempt = ["THIRD-PARTY-NOTICES.md", Contributing, "Tests/Repository/WordingTests.cs"];

    static IEnumerable<string> Sources => RepositoryFiles.All
        .Where(file => Path.GetExtension(file) is ".cs" or ".ts" or ".mjs" or ".md" or ".yaml" or ".html" && !Exempt.Contains(file));

    [Test]
    public void Names_All_UseTheTermsOfTheField()
    {
        var found = Sources.Where(file => file.EndsWith(".cs", StringComparison.Ordinal)).SelectMany(file => WithoutFormerNames([.. Lines([file])]))
            .SelectMany(line => NameRules.SelectMany(rule => rule.In(line)));

        Assert.That(found, Is.Empty);
    }

    [Test]
    public void Texts_All_UseTheTermsOfTheField()
    {
        var found = Lines(Sources).SelectMany(line => TextRules.SelectMany(rule => rule.In(line with { Text = Prose(line) })));

        Assert.That(found, Is.Empty);
    }

    [TestCase("bool _isDoubted;", "Doubt")]
    [TestCase("const int MostRetries = 3;", "Most")]
    [TestCase("const int MaxRetries = 3;", null)]
    [TestCase("public void Run_PortClosed_SaysSo()", "_SaysSo")]
    [TestCase("public void Run_PortClosed_ReportsIt()", null)]
    public void NameRules_Sample_DetectThePrivateWord(string code, string word) =>
        Assert.That(NameRules.SelectMany(rule => rule.In(new Line("a.cs", 1, code))), word == null ? Is.Empty : Has.One.Contains(word));

    [Test]
    public void WithoutFormerNames_ObsoleteMember_IsRemoved()
    {
        Line[] lines = [new("a.cs", 1, "int Doubt;"), new("a.cs", 2, "[Obsolete(\"use Conflict\")]"), new("a.cs", 3, "int Quarrel;")];

        Assert.That(WithoutFormerNames([.. lines]), Is.EqualTo(lines[..2]));
    }

    [TestCase("- Renamed `moment of light`.", false)]
    [TestCase("- Renamed the moment of light.", true)]
    public void TextRules_Changelog_OmitFormerNamesInBackticks(string text, bool isFound)
    {
        var line = new Line("Packages/a/CHANGELOG.md", 1, text);

        Assert.That(TextRules.SelectMany(rule => rule.In(line with { Text = Prose(line) })), isFound ? Has.Exactly(1).Items : Is.Empty);
    }

    [TestCase("/// <summary>What the headset shows.</summary>", true)]
    [TestCase("/// <summary>Gets what the headset shows.</summary>", false)]
    [TestCase("// the predictor is told the horizon", true)]
    [TestCase("// the predictor gets the horizon", false)]
    [TestCase("var whoever = 1;", false)]
    [TestCase("throw new InputException(\"whoever asks\");", true)]
    public void TextRules_Sample_DetectThePrivateWord(string code, bool isFound)
    {
        var line = new Line("a.cs", 1, code);

        Assert.That(TextRules.SelectMany(rule => rule.In(line with { Text = Prose(line) })), isFound ? Has.Exactly(1).Items : Is.Empty);
    }

    [Test]
    public void Contributing_RulesOfTheCheck_AreListed()
    {
        var text = RepositoryFiles.Read(Contributing);

        Assert.That(NameRules.Concat(TextRules).Select(rule => rule.Instead).Where(instead => !text.Contains(instead, StringComparison.Ordinal)), Is.Empty);
    }

    static readonly Rule[] NameRules =
    [
        new(PrivateNames(), "conflict, new, factor, display time, uncertainty, reported"),
        new(ExtremeConstants(), "`Min…`, `Max…`"),
        new(PrivateTestNames(), "`Method_Condition_Result` with `Is`, `Has`, `Returns`, `Reports`"),
    ];

    static readonly Rule[] TextRules =
    [
        new(SummaryStarts(), "a verb in the third person, or the name of the thing"),
        new(PrivateWords(), "the field's term, see docs/glossary.md"),
        new(Told(), "gets, is given, reports, states"),
    ];

    static IEnumerable<Line> Lines(IEnumerable<string> files) =>
        files.SelectMany(file => RepositoryFiles.Read(file).Split('\n').Select((text, i) => new Line(file, i + 1, text)));

    // A line below the attribute Obsolete declares a former public name, which remains for one release.
    static IEnumerable<Line> WithoutFormerNames(List<Line> lines) =>
        lines.Where((_, i) => i == 0 || !lines[i - 1].Text.Contains("[Obsolete(", StringComparison.Ordinal));

    // Returns the comment and the string literals of a line of code, or the whole line of a Markdown or HTML page. A changelog quotes former names and
    // texts as code, which is omitted.
    static string Prose(Line line)
    {
        if (Path.GetFileName(line.File) == "CHANGELOG.md") return Code().Replace(line.Text, "");
        if (Path.GetExtension(line.File) is ".md" or ".html") return line.Text;
        var comment = Comment().Match(line.Text).Value;
        return comment + ' ' + string.Join(' ', Literals().Matches(line.Text[..^comment.Length]).Select(match => match.Value));
    }

    sealed record Line(string File, int Number, string Text);

    sealed record Rule(Regex Pattern, string Instead)
    {
        public IEnumerable<string> In(Line line) =>
            Pattern.Matches(line.Text).Select(match => $"{line.File}:{line.Number}: '{match.Value}'; use {Instead}");
    }

    // Begins with the word instead of the name that contains it: the search for a literal takes a fraction of the time.
    [GeneratedRegex(@"(?:Quarrel|Newcomer|Optimism|MomentOfLight|Unmet|Unheard|Doubt|Told)\w*")]
    private static partial Regex PrivateNames();

    [GeneratedRegex(@"\b(?:const|static readonly) \S+ _?(?:Least|Greatest|Most|Fewest|Longest|Shortest)[A-Z]")]
    private static partial Regex ExtremeConstants();

    [GeneratedRegex(@"(?<=public (?:async Task|void) \w*)(?:_Is(?:Said|Told|Heard)\w*|_Says\w*|SaysSo\w*|_Tells\w*|_Knows\w*|Nobody\w*|Whoever\w*)")]
    private static partial Regex PrivateTestNames();

    [GeneratedRegex(@"<summary>\s*(?:Of|What|Whoever|Whatever|So many|So long|It is|They are|One that|That|Such)\b")]
    private static partial Regex SummaryStarts();

    [GeneratedRegex(@"(?i)\b(?:whoever|whatever|somebody|quarrels?|newcomers?|unheard of|moment of light|anew|thereby|therein|thereof|forth and back)\b")]
    private static partial Regex PrivateWords();

    [GeneratedRegex(@"(?i)\b(?:is|are|was|were|be|been|as) told\b|\btold by\b|\b(?:is|are|was|were) said to\b")]
    private static partial Regex Told();

    [GeneratedRegex(@"(?<!:)//.*$|^\s*\*.*$|^\s*#.*$")]
    private static partial Regex Comment();

    [GeneratedRegex("`[^`]*`")]
    private static partial Regex Code();

    [GeneratedRegex("\"(?:[^\"\\\\]|\\\\.)*\"|'[^']{12,}'|`[^`]*`")]
    private static partial Regex Literals();
}
