using System.Globalization;
using System.Text.Json.Nodes;

namespace Nowpose.Gateway.Status;

/// <summary>The parts of a sample's latency that the gateway measures, in ms; null if unknown.</summary>
/// <param name="PlantMs">C1 at the gateway minus t_k. Unknown if there are several robots, because the headset's own robot is not known.</param>
/// <param name="GatewayMs">Time from the receipt at the gateway until the sample is written to the subscribers' sockets.</param>
readonly record struct HopTimes(double? PlantMs, double? GatewayMs);

/// <summary>Converts the diagnostics of headsets and adapters to JSON, and adds values that the gateway derives.</summary>
static class StatusObjects
{
    /// <summary>Time without a report after which an adapter or headset is silent. Both report once per second.</summary>
    public static readonly TimeSpan Silence = TimeSpan.FromSeconds(3);

    // Adapters use the prefix plant/. The gateway also accepts adapter/.
    static readonly string[] AdapterPrefixes = ["plant/", "adapter/"];

    // Keys that the gateway sets. A client's diagnostics must not replace them.
    static readonly string[] Own = ["name", "seen_s_ago", "budget_ms"];

    // Keys whose values are text even if they read as a number, such as the name of a missing joint.
    static readonly string[] Texts = [HeadsetKeys.State, HeadsetKeys.Pose, HeadsetKeys.MissingJoints, HeadsetKeys.Version];

    /// <summary>Whether a hardware_id belongs to an adapter.</summary>
    public static bool IsAdapter(string hardwareId) => Array.Exists(AdapterPrefixes, prefix => hardwareId.StartsWith(prefix, StringComparison.Ordinal));

    public static string AdapterName(string hardwareId) => hardwareId[(hardwareId.IndexOf('/', StringComparison.Ordinal) + 1)..];

    public static JsonObject Adapter(ClientReport report) =>
        Words(AdapterName(report.Name), report.Ago, report.Values);

    public static JsonObject Headset(ClientReport report, HopTimes hops)
    {
        var headset = Words(report.Name, report.Ago, report.Values);
        headset["budget_ms"] = Budget(headset, hops);
        return headset;
    }

    /// <summary>Whether an adapter or headset has stopped reporting, so that its last report does not describe its present state.</summary>
    public static bool IsSilent(JsonObject words) => Number(words, "seen_s_ago") > Silence.TotalSeconds;

    /// <summary>Gets a number from a client's diagnostics; null if there is none.</summary>
    public static double? Number(JsonObject words, string key) =>
        words[key] is JsonValue value && value.TryGetValue(out double number) ? number : null;

    /// <summary>Gets a string from the diagnostics of a headset or an adapter; null if there is none.</summary>
    public static string Word(JsonObject words, string key) =>
        words[key] is JsonValue value && value.TryGetValue(out string word) ? word : null;

    /// <summary>Returns 1 if the value of a key is a certain word, and 0 if it is another word; null if there is none.</summary>
    public static double? OneIf(JsonObject words, string key, string yes) => Word(words, key) is { } word ? (word == yes ? 1 : 0) : null;

    static JsonObject Words(string name, TimeSpan ago, IReadOnlyList<KeyValuePair<string, string>> values)
    {
        var words = new JsonObject { ["name"] = name, ["seen_s_ago"] = Math.Round(ago.TotalSeconds, 1) };
        foreach (var (key, value) in values)
        {
            if (Own.Contains(key)) continue;
            var number = 0.0;
            var isNumber = !Texts.Contains(key) && double.TryParse(value, NumberStyles.Float, CultureInfo.InvariantCulture, out number) && double.IsFinite(number);
            words[key] = isNumber ? number : value;
        }

        return words;
    }

    // L_app ends when the headset receives the sample. L_app minus the times of plant, gateway and network is the time in queues. It can be negative,
    // because the other times are medians and half of a round-trip time. The hops always add up to the reported latency.
    static JsonObject Budget(JsonObject headset, HopTimes hops)
    {
        var network = Number(headset, HeadsetKeys.RoundTripMs) / 2;
        var queue = Number(headset, HeadsetKeys.ApplicationLatencyMs) - hops.PlantMs - hops.GatewayMs - network;
        var render = Number(headset, HeadsetKeys.RenderMs);
        return new JsonObject
        {
            ["plant"] = Rounded(hops.PlantMs),
            ["gateway"] = Rounded(hops.GatewayMs),
            ["network"] = Rounded(network),
            ["queue"] = Rounded(queue),
            ["render"] = Rounded(render),
            ["display"] = Rounded(Number(headset, HeadsetKeys.VisualisationLatencyMs) - (render ?? 0)),
        };
    }

    // Returns null for a result that is not finite, because reported numbers may be arbitrarily large.
    static JsonNode Rounded(double? milliseconds) =>
        milliseconds is { } known && double.IsFinite(known) ? Math.Round(known, 3) : null;
}
