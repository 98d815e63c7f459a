namespace Nowpose.Web;

/// <summary>
/// Creates the page of a calibration: one HTML file that needs no network. The page has plots unless Nowpose was built without Node.js.
/// </summary>
public static class CalibrationPage
{
    static readonly PageTemplate Template = PageTemplate.Named("calibration.html");

    /// <inheritdoc cref="ReportPage.HasPlots"/>
    public static bool HasPlots => Template != null;

    /// <param name="json">A JSON object with the fields of <c>Web/src/calibration/data.ts</c>.</param>
    /// <exception cref="ArgumentException">The text is not a valid JSON object. JSON has no NaN.</exception>
    public static string Render(string json)
    {
        using var data = PageTemplate.Parse(json);
        return HasPlots ? Template.With(json) : PlainCalibration.Render(data.RootElement);
    }
}
