namespace Nowpose.Cli.Calibrate.Head;

/// <summary>Formats the latency for head motion as JSON.</summary>
static class HeadJson
{
    public static string Of(HeadResult result) => JsonText.Of(isIndented: true, json =>
    {
        json.WriteStartObject();
        json.WriteNumber("head_latency_ms", result.LatencyMs);
        json.WriteNumber("head_latency_uncertainty_ms", result.UncertaintyMs);
        json.WriteNumber("visu_ms", result.VisuMs);
        json.WriteNumber("pictures", result.Pictures.Pictures.Count);
        json.WriteNumber("rejected", result.Pictures.Rejected);
        json.WriteNumber("used", result.Used.Count);
        json.WriteNumber("speed_px_s", result.SpeedPx);
        json.WriteEndObject();
    });
}
