using System.Globalization;
using System.Text.Json.Nodes;

namespace Nowpose.Gateway.Status;

/// <summary>What the gateway itself knows of a sample's way, ms; null for not known.</summary>
/// <param name="PlantMs">C1 at the gateway less t_k.</param>
/// <param name="GatewayMs">From receipt to the sockets.</param>
readonly record struct HopTimes(double? PlantMs, double? GatewayMs);

/// <summary>Headsets and adapters as they are told: their own words, and what follows from them.</summary>
static class StatusObjects
{
    // Two spellings: adapters of one release use plant/.
    static readonly string[] AdapterPrefixes = ["plant/", "adapter/"];

    // The gateway's own words, which nobody else's may replace.
    static readonly string[] Own = ["name", "seen_s_ago", "budget_ms"];

    /// <summary>Whether a hardware_id is an adapter's.</summary>
    public static bool IsAdapter(string hardwareId) => Array.Exists(AdapterPrefixes, prefix => hardwareId.StartsWith(prefix, StringComparison.Ordinal));

    public static string AdapterName(string hardwareId) => hardwareId[(hardwareId.IndexOf('/', StringComparison.Ordinal) + 1)..];

    public static JsonObject Adapter((string Name, TimeSpan Ago, IReadOnlyList<KeyValuePair<string, string>> Values) said) =>
        Words(AdapterName(said.Name), said.Ago, said.Values);

    public static JsonObject Headset((string Name, TimeSpan Ago, IReadOnlyList<KeyValuePair<string, string>> Values) said, HopTimes hops)
    {
        var headset = Words(said.Name, said.Ago, said.Values);
        headset["budget_ms"] = Budget(headset, hops);
        return headset;
    }

    /// <summary>A number among somebody's words; null where there is none.</summary>
    public static double? Number(JsonObject words, string key) =>
        words[key] is JsonValue value && value.TryGetValue(out double number) ? number : null;

    /// <summary>A text in the words of a headset or an adapter; null where there is none.</summary>
    public static string Word(JsonObject words, string key) =>
        words[key] is JsonValue value && value.TryGetValue(out string word) ? word : null;

    static JsonObject Words(string name, TimeSpan ago, IReadOnlyList<KeyValuePair<string, string>> values)
    {
        var words = new JsonObject { ["name"] = name, ["seen_s_ago"] = Math.Round(ago.TotalSeconds, 1) };
        foreach (var (key, value) in values)
        {
            if (Own.Contains(key)) continue;
            var isNumber = double.TryParse(value, NumberStyles.Float, CultureInfo.InvariantCulture, out var number) && double.IsFinite(number);
            words[key] = isNumber ? number : value;
        }

        return words;
    }

    // L_app ends at the headset's socket: what the first three hops leave of it is waiting.
    static JsonObject Budget(JsonObject headset, HopTimes hops)
    {
        var network = Number(headset, "rtt_ms") / 2;
        var queue = Number(headset, "l_app_ms") - hops.PlantMs - hops.GatewayMs - network;
        var render = Number(headset, "render_ms");
        return new JsonObject
        {
            ["plant"] = Rounded(hops.PlantMs),
            ["gateway"] = Rounded(hops.GatewayMs),
            ["network"] = Rounded(network),
            ["queue"] = Rounded(queue),
            ["render"] = Rounded(render),
            ["display"] = Rounded(Number(headset, "l_visu_ms") - (render ?? 0)),
        };
    }

    // What they say may be as great as a number can be: what follows from it may not be one.
    static JsonNode Rounded(double? milliseconds) =>
        milliseconds is { } known && double.IsFinite(known) ? Math.Round(Math.Max(0, known), 3) : null;
}
