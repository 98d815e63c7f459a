using Nowpose.Latency;

namespace Nowpose.Cli.Calibrate.Range;

/// <summary>Formats the constant-latency range as JSON.</summary>
static class RangeJson
{
    public static string Of(RangeFitResult fit) => JsonText.Of(isIndented: true, json =>
    {
        json.WriteStartObject();
        json.WriteNumber("visu_ms", fit.VisuMs);
        json.WriteNumber("visu_spread_ms", fit.SpreadMs);
        if (fit.LimitRenderMs is double limit) json.WriteNumber("limit_render_ms", limit);
        else json.WriteNull("limit_render_ms");
        json.WriteNumber("valid_to_render_ms", fit.ValidToRenderMs);
        json.WriteNumber("pairs", fit.Pairs);
        json.WriteNumber("rejected", fit.Rejected);
        json.WriteEndObject();
    });
}
