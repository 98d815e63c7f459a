namespace Nowpose.Cli.Calibrate.Sine;

/// <summary>Formats the result of a back-and-forth jog as JSON.</summary>
static class SineJson
{
    public static string Of(SineResult result) => JsonText.Of(isIndented: true, json =>
    {
        json.WriteStartObject();
        json.WriteNumber("total_ms", result.TotalMs);
        json.WriteNumber("total_sd_ms", result.DeviationMs);
        if (result.VisuMs is double visu) json.WriteNumber("visu_ms", visu);
        else json.WriteNull("visu_ms");
        json.WriteNumber("correlation", result.Lag.Correlation);
        json.WriteNumber("pictures", result.Tracks.Shown.Length);
        json.WriteEndObject();
    });
}
