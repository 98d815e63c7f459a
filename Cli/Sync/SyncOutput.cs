using System.Text.Json;

namespace Nowpose.Cli.Sync;

/// <summary>Prints estimates as CSV or JSON. The columns are specified in cli.md.</summary>
static class SyncOutput
{
    public static void WriteCsv(IEnumerable<SyncEstimate> estimates, bool atInstants, TextWriter output)
    {
        output.WriteLine(atInstants ? "t_ns,offset_ns,error_bound_ns,state" : "t4_ns,offset_ns,skew_ppm,error_bound_ns,state,estimated_error_ns");
        foreach (var estimate in estimates)
        {
            var skew = atInstants ? "" : SyncEstimate.Text(estimate.SkewPpm) + ",";
            var (offset, bound) = (SyncEstimate.Text(estimate.OffsetNanoseconds), SyncEstimate.Text(estimate.ErrorBoundNanoseconds));
            var estimated = atInstants ? "" : "," + SyncEstimate.Text(estimate.EstimatedErrorNanoseconds);
            output.WriteLine($"{estimate.Nanoseconds},{offset},{skew}{bound},{estimate.State}{estimated}");
        }
    }

    public static void WriteJson(IEnumerable<SyncEstimate> estimates, bool atInstants, TextWriter output) =>
        output.WriteLine(JsonText.Of(isIndented: true, json => WriteArray(json, estimates, atInstants)));

    static void WriteArray(Utf8JsonWriter json, IEnumerable<SyncEstimate> estimates, bool atInstants)
    {
        json.WriteStartArray();
        foreach (var estimate in estimates)
        {
            json.WriteStartObject();
            json.WriteNumber(atInstants ? "t_ns" : "t4_ns", estimate.Nanoseconds);
            WriteNumber(json, "offset_ns", SyncEstimate.Text(estimate.OffsetNanoseconds));
            if (!atInstants) WriteNumber(json, "skew_ppm", SyncEstimate.Text(estimate.SkewPpm));
            WriteNumber(json, "error_bound_ns", SyncEstimate.Text(estimate.ErrorBoundNanoseconds));
            json.WriteString("state", estimate.State);
            if (!atInstants) WriteNumber(json, "estimated_error_ns", SyncEstimate.Text(estimate.EstimatedErrorNanoseconds));
            json.WriteEndObject();
        }
        json.WriteEndArray();
    }

    static void WriteNumber(Utf8JsonWriter json, string name, string number)
    {
        json.WritePropertyName(name);
        json.WriteRawValue(number.Length == 0 ? "null" : number);
    }
}
