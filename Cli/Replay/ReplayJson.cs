using System.Text.Json;

namespace Nowpose.Cli.Replay;

/// <summary>Formats the result of a replay as JSON, with all digits of the numbers.</summary>
static class ReplayJson
{
    public static string Of(ReplayResult result) => JsonText.Of(isIndented: true, json => Write(json, result));

    /// <summary>Formats the result of a rigid body. It has no totals, because millimetres and degrees cannot be added.</summary>
    public static string Of(BodyReplayResult result) => JsonText.Of(isIndented: true, json => Write(json, result));

    static void Write(Utf8JsonWriter json, BodyReplayResult result)
    {
        json.WriteStartObject();
        json.WriteString("file", result.File);
        json.WriteString("predictor", result.Predictor);
        json.WriteNumber("frames", result.Frames);
        json.WriteStartObject("body");
        Write(json, "error_mm", result.Position);
        Write(json, "error_deg", result.Rotation);
        json.WriteEndObject();
        json.WriteEndObject();
    }

    static void Write(Utf8JsonWriter json, string name, BodyReplayResult.ErrorSize error)
    {
        json.WriteStartObject(name);
        json.WriteNumber("rms_hold", error.RmsHold);
        json.WriteNumber("rms", error.Rms);
        json.WriteNumber("p95", error.P95);
        json.WriteEndObject();
    }

    static void Write(Utf8JsonWriter json, ReplayResult result)
    {
        json.WriteStartObject();
        json.WriteString("file", result.File);
        json.WriteString("predictor", result.Predictor);
        json.WriteNumber("frames", result.Frames);
        json.WriteStartArray("axes");
        foreach (var axis in result.Axes) Write(json, axis);
        json.WriteEndArray();
        json.WriteNumber("rms_hold", result.RmsHold);
        json.WriteNumber("rms", result.Rms);
        if (result.Reduction is double reduction) json.WriteNumber("reduction", reduction);
        else json.WriteNull("reduction");
        if (result.Bodies.Count > 0) WriteBodies(json, result.Bodies);
        if (result.Signals.Count > 0) WriteSignals(json, result.Signals);
        json.WriteEndObject();
    }

    static void WriteBodies(Utf8JsonWriter json, IReadOnlyList<BodyReplayResult> bodies)
    {
        json.WriteStartArray("bodies");
        foreach (var body in bodies)
        {
            json.WriteStartObject();
            json.WriteString("name", body.File);
            json.WriteNumber("frames", body.Frames);
            Write(json, "error_mm", body.Position);
            Write(json, "error_deg", body.Rotation);
            json.WriteEndObject();
        }
        json.WriteEndArray();
    }

    static void WriteSignals(Utf8JsonWriter json, IReadOnlyList<(string Name, int Changes)> signals)
    {
        json.WriteStartArray("signals");
        foreach (var (name, changes) in signals)
        {
            json.WriteStartObject();
            json.WriteString("name", name);
            json.WriteNumber("changes", changes);
            json.WriteEndObject();
        }
        json.WriteEndArray();
    }

    static void Write(Utf8JsonWriter json, ReplayResult.Axis axis)
    {
        json.WriteStartObject();
        json.WriteString("name", axis.Name);
        json.WriteNumber("rms_hold", axis.RmsHold);
        json.WriteNumber("rms", axis.Rms);
        json.WriteNumber("p95", axis.P95);
        json.WriteNumber("max", axis.Max);
        if (axis.Deviation is ReplayResult.Deviation deviation)
        {
            json.WriteNumber("sd", deviation.Mean);
            json.WriteNumber("inside_1sd", deviation.InsideOne);
            json.WriteNumber("inside_2sd", deviation.InsideTwo);
        }
        json.WriteEndObject();
    }
}
