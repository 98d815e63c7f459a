namespace Nowpose.Headless.Tests.Autobahn;

/// <summary>Lists all cases, and creates the table of cases for the document.</summary>
static class AutobahnDocument
{
    public static readonly AutobahnSection[] Sections = [.. FramingCases.All(), .. Utf8Cases.All(), .. CloseCases.All(), .. LimitCases.All()];

    /// <summary>Creates the table, with one row per section.</summary>
    public static string Table() => string.Concat(
        Sections.Select(section => $"| {section.Number} | {section.Cases.Length} | {section.What} | {Outcomes(section)} | {section.Note} |\n")
            .Prepend("| Cases | Tests | What is sent | Expected outcome | Note |\n| --- | --- | --- | --- | --- |\n"));

    static string Outcomes(AutobahnSection section) => string.Join("; ", section.Cases.Select(one => Outcome(one.Expected)).Distinct());

    // Lists each alternative that contains an event that the first alternative lacks. Omits the other alternatives, because the document
    // states that messages before a close may be lost.
    static string Outcome(string expected)
    {
        var ways = expected.Split('|').Select(Words).ToArray();
        return string.Join(" or ", ways.Where((way, i) => i == 0 || way.Except(ways[0]).Any()).Select(Outcome));
    }

    static string Outcome(string[] way)
    {
        var words = way.GroupBy(word => word).Select(group => group.Count() == 1 ? group.Key : $"{group.Count()} × {group.Key}");
        return string.Join(", ", words) is { Length: > 0 } text ? text : "stays open";
    }

    static string[] Words(string way) => way.Split(' ', StringSplitOptions.RemoveEmptyEntries);
}
