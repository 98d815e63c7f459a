using System.Text.Json;

namespace Nowpose.Cli.Recommend;

/// <summary>Formats the recommendation as JSON, with all digits of the numbers.</summary>
static class RecommendJson
{
    public static string Of(string path, RecordingTraits traits, IReadOnlyList<(Recommendation Recommendation, BlendCost Blend)> results) => JsonText.Of(isIndented: true, json =>
    {
        json.WriteStartObject();
        json.WriteString("file", path);
        Write(json, traits);
        json.WriteStartArray("conditions");
        foreach (var (recommendation, blend) in results) Write(json, recommendation, blend);
        json.WriteEndArray();
        json.WriteEndObject();
    });

    static void Write(Utf8JsonWriter json, RecordingTraits traits)
    {
        json.WriteNumber("seconds", traits.Duration);
        json.WriteStartObject("interval_ms");
        json.WriteNumber("median", 1e3 * traits.Interval);
        json.WriteNumber("p5", 1e3 * traits.IntervalP5);
        json.WriteNumber("p95", 1e3 * traits.IntervalP95);
        json.WriteEndObject();
        json.WriteNumber("repeated", traits.Repeats);
        json.WriteStartObject("rounding");
        foreach (var (name, step) in traits.RoundingSteps) json.WriteNumber(name, step);
        json.WriteEndObject();
        json.WriteStartArray("warnings");
        foreach (var warning in traits.Warnings()) json.WriteStringValue(warning);
        json.WriteEndArray();
    }

    static void Write(Utf8JsonWriter json, Recommendation recommendation, BlendCost blend)
    {
        json.WriteStartObject();
        WriteNumber(json, "sampling_ms", recommendation.Subject.SamplingMs);
        WriteNumber(json, "latency_ms", recommendation.Subject.LatencyMs);
        json.WriteString("recommended", recommendation.Recommended.Predictor);
        json.WriteString("reason", recommendation.Reason);
        WriteNumber(json, "reduction", recommendation.Recommended.Reduction);
        WriteNumber(json, "gain_over_default", recommendation.Recommended.GainOver(recommendation.Default));
        json.WriteNumber("blend_ms", blend.RecommendedMs);
        WriteNumber(json, "blend_cost", blend.Share);
        json.WriteStartArray("candidates");
        foreach (var trial in recommendation.Trials) Write(json, recommendation, trial);
        json.WriteEndArray();
        json.WriteEndObject();
    }

    static void Write(Utf8JsonWriter json, Recommendation recommendation, Trial trial)
    {
        json.WriteStartObject();
        json.WriteString("predictor", trial.Predictor);
        json.WriteNumber("rms", trial.Rms);
        json.WriteNumber("rms_hold", trial.RmsHold);
        WriteNumber(json, "reduction", trial.Reduction);
        WriteNumber(json, "gain_over_default", trial.GainOver(recommendation.Default));
        json.WriteBoolean("tie", recommendation.IsTie(trial));
        json.WriteStartArray("halves");
        foreach (var half in Enum.GetValues<Half>())
        {
            json.WriteStartObject();
            json.WriteNumber("frames", trial.On(half).Frames);
            json.WriteNumber("rms", trial.On(half).Rms);
            json.WriteNumber("rms_hold", trial.On(half).RmsHold);
            WriteNumber(json, "reduction", trial.On(half).Reduction);
            WriteNumber(json, "gain_over_default", trial.GainOver(recommendation.Default, half));
            json.WriteEndObject();
        }
        json.WriteEndArray();
        json.WriteEndObject();
    }

    static void WriteNumber(Utf8JsonWriter json, string name, double? value)
    {
        if (value is double number) json.WriteNumber(name, number);
        else json.WriteNull(name);
    }
}
