namespace Nowpose.Web;

/// <summary>
/// Creates the report: one HTML file that needs no network. It has plots and tables, or only tables if it was built without Node.js.
/// </summary>
public static class ReportPage
{
    static readonly PageTemplate Template = PageTemplate.Named("report.html");

    /// <summary>Whether the page has plots; false if this assembly was built without Node.js.</summary>
    public static bool HasPlots => Template != null;

    /// <param name="json">A JSON object with the fields of <c>Web/src/data.ts</c>. Each field can be null or missing.</param>
    /// <exception cref="ArgumentException">The text is not a valid JSON object. JSON has no NaN.</exception>
    public static string Render(string json)
    {
        using var data = PageTemplate.Parse(json);
        return HasPlots ? Template.With(json) : PlainReport.Render(data.RootElement);
    }
}
