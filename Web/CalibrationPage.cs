namespace Nowpose.Web;

/// <summary>One calibration as an HTML page that needs no network. It has plots unless it was built without Node.js.</summary>
public static class CalibrationPage
{
    static readonly PageTemplate Template = PageTemplate.Named("calibration.html");

    /// <inheritdoc cref="ReportPage.HasPlots"/>
    public static bool HasPlots => Template != null;

    /// <param name="json">One JSON object; the fields are those of <c>Web/src/calibration/data.ts</c>.</param>
    /// <exception cref="ArgumentException">The text is not JSON (which has no NaN) or not an object.</exception>
    public static string Render(string json)
    {
        using var data = PageTemplate.Parse(json);
        return HasPlots ? Template.With(json) : PlainCalibration.Render(data.RootElement);
    }
}
