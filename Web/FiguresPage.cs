namespace Nowpose.Web;

/// <summary>Creates the page of the paper's figures: one HTML file that needs no network. It has plots unless it was built without Node.js.</summary>
public static class FiguresPage
{
    static readonly PageTemplate Template = PageTemplate.Named("figures.html");

    /// <inheritdoc cref="ReportPage.HasPlots"/>
    public static bool HasPlots => Template != null;

    /// <param name="json">A JSON object with the fields of <c>Web/src/figures/data.ts</c>.</param>
    /// <exception cref="ArgumentException">The text is not a valid JSON object. JSON has no NaN.</exception>
    public static string Render(string json)
    {
        using var data = PageTemplate.Parse(json);
        return HasPlots ? Template.With(json) : PlainFigures.Render(data.RootElement);
    }
}
