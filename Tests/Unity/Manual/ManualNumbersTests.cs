using System.Text.RegularExpressions;
using NUnit.Framework;

namespace Nowpose.Unity.Tests.Manual;

/// <summary>Tests that the numbers in the manual agree with the defaults and the tooltips of the fields.</summary>
/// <remarks><see cref="ManualTests"/> compares the columns for defaults and allowed values with the fields.</remarks>
public sealed partial class ManualNumbersTests
{
    static readonly Dictionary<string, string[]> Defaults = InspectedType.All.SelectMany(type => new InspectedType(type).Fields)
        .GroupBy(field => field.Label, field => field.Default).ToDictionary(group => group.Key, group => group.Distinct().ToArray());

    static IEnumerable<Type> Types => InspectedType.All;

    static IEnumerable<string> Pages => ManualPage.Names;

    [TestCaseSource(nameof(Types))]
    public void Tooltip_Numbers_AgreeWithTheFieldRowOfTheManual(Type type)
    {
        var inspected = new InspectedType(type);
        var rows = ManualPage.Read(inspected.PageName).TableUnder("Fields").ToDictionary(row => row[0], row => string.Join(" | ", row.Skip(1)));

        var wrong = inspected.Fields.Where(field => field.Tooltip != null)
            .SelectMany(field => Conflicts(field.Tooltip, rows[field.Label]).Select(number => $"{field.Label}: {number}: {rows[field.Label]}"));

        Assert.That(wrong, Is.Empty);
    }

    // For example "locked after Settle Ms (1850 ms)".
    [TestCaseSource(nameof(Pages))]
    public void Page_DefaultInParenthesesAfterALabel_EqualsTheDefaultOfTheField(string page)
    {
        var stated = Parenthesised().Matches(RepositoryFiles.Read(ManualPage.Folder + "/" + page))
            .Select(match => (Words: match.Groups[1].Value.Replace('\n', ' '), Number: match.Groups[2].Value));

        var wrong = from text in stated
                    let label = Defaults.Keys.Where(label => (" " + text.Words).EndsWith(" " + label, StringComparison.Ordinal)).MaxBy(label => label.Length)
                    where label != null && !Defaults[label].Contains(text.Number)
                    select $"{label} ({text.Number}); the default is {string.Join(" or ", Defaults[label])}";

        Assert.That(wrong, Is.Empty);
    }

    [TestCase("Rate in Hz, 1 to 90.", "60 Hz | 1 to 90 Hz | Rate of the display.", true)]
    [TestCase("Rate in Hz, 1 to 90.", "60 Hz | 1 to 120 Hz | Rate of the display.", false)]
    [TestCase("A name with up to 64 characters.", "empty | up to 32 characters | The name.", false)]
    [TestCase("Duration. Default 5: about 40 pictures.", "5 s | 1 to 9 s | Duration. 40 pictures are sufficient.", true)]
    [TestCase("Duration. Default 5: about 40 pictures.", "5 s | 1 to 9 s | Duration. 30 pictures are sufficient.", false)]
    public void Conflicts_Sample_AreEmptyOnlyIfTheNumbersAgree(string tooltip, string row, bool isEmpty) =>
        Assert.That(Conflicts(tooltip, row), isEmpty ? Is.Empty : Is.Not.Empty);

    // A range in the tooltip must be in the row. A unit that occurs in both must have the same number at least once.
    static IEnumerable<string> Conflicts(string tooltip, string row)
    {
        var ranges = Ranges().Matches(tooltip).Select(match => match.Value).Where(range => !row.Contains(range, StringComparison.Ordinal));
        var stated = Quantities().Matches(row).ToLookup(match => match.Groups[2].Value, match => match.Groups[1].Value);
        var units = Quantities().Matches(tooltip).GroupBy(match => match.Groups[2].Value, match => match.Groups[1].Value)
            .Where(unit => stated.Contains(unit.Key) && !unit.Intersect(stated[unit.Key]).Any());
        return ranges.Concat(units.Select(unit => $"{string.Join(", ", unit)} {unit.Key}"));
    }

    [GeneratedRegex(@"\d[\d.]* to \d[\d.]*\d|\d+ to \d+|up to \d+")]
    private static partial Regex Ranges();

    [GeneratedRegex(@"(?<![\w.])(\d+(?:\.\d+)?) (%|[A-Za-z][\w/²³]*)")]
    private static partial Regex Quantities();

    [GeneratedRegex(@"((?:\w+\s){0,4}\w+)\s\((\d+(?:\.\d+)?) ?[\w%/²³°]*\)")]
    private static partial Regex Parenthesised();
}
