namespace Nowpose.Web;

/// <summary>The report as one HTML page that needs no network: plots and tables, or tables alone when built without Node.js.</summary>
public static class ReportPage
{
    static readonly PageTemplate Template = PageTemplate.Named("report.html");

    /// <summary>True when the page draws plots; false if this assembly was built without Node.js.</summary>
    public static bool HasPlots => Template != null;

    /// <param name="json">One JSON object; the fields are those of <c>Web/src/data.ts</c>, each of which may be null or absent.</param>
    /// <exception cref="ArgumentException">The text is not JSON (which has no NaN) or not an object.</exception>
    public static string Render(string json)
    {
        using var data = PageTemplate.Parse(json);
        return HasPlots ? Template.With(json) : PlainReport.Render(data.RootElement);
    }
}
