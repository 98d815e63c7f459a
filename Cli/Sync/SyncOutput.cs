using System.Text.Json;

namespace Nowpose.Cli.Sync;

/// <summary>Prints estimates as CSV or JSON, with the columns specified in cli.md.</summary>
static class SyncOutput
{
    public static void WriteCsv(IEnumerable<SyncBelief> beliefs, bool atInstants, TextWriter output)
    {
        output.WriteLine(atInstants ? "t_ns,offset_ns,error_bound_ns,state" : "t4_ns,offset_ns,skew_ppm,error_bound_ns,state,estimated_error_ns");
        foreach (var belief in beliefs)
        {
            var skew = atInstants ? "" : SyncBelief.Text(belief.SkewPpm) + ",";
            var (offset, bound) = (SyncBelief.Text(belief.OffsetNanoseconds), SyncBelief.Text(belief.ErrorBoundNanoseconds));
            var estimated = atInstants ? "" : "," + SyncBelief.Text(belief.EstimatedErrorNanoseconds);
            output.WriteLine($"{belief.Nanoseconds},{offset},{skew}{bound},{belief.State}{estimated}");
        }
    }

    public static void WriteJson(IEnumerable<SyncBelief> beliefs, bool atInstants, TextWriter output) =>
        output.WriteLine(JsonText.Of(isIndented: true, json => WriteArray(json, beliefs, atInstants)));

    static void WriteArray(Utf8JsonWriter json, IEnumerable<SyncBelief> beliefs, bool atInstants)
    {
        json.WriteStartArray();
        foreach (var belief in beliefs)
        {
            json.WriteStartObject();
            json.WriteNumber(atInstants ? "t_ns" : "t4_ns", belief.Nanoseconds);
            WriteNumber(json, "offset_ns", SyncBelief.Text(belief.OffsetNanoseconds));
            if (!atInstants) WriteNumber(json, "skew_ppm", SyncBelief.Text(belief.SkewPpm));
            WriteNumber(json, "error_bound_ns", SyncBelief.Text(belief.ErrorBoundNanoseconds));
            json.WriteString("state", belief.State);
            if (!atInstants) WriteNumber(json, "estimated_error_ns", SyncBelief.Text(belief.EstimatedErrorNanoseconds));
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
