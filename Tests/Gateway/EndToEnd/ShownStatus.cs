using System.Net;
using System.Text.Json;
using System.Text.RegularExpressions;

namespace Nowpose.Headless.Tests.Gateway.EndToEnd;

/// <summary>Status of a gateway at one moment, in each place where people and programs read it.</summary>
/// <param name="Adapter">The newest DiagnosticStatus of the adapter; null before the first.</param>
/// <param name="Headset">The newest DiagnosticStatus of the headset; null before the first.</param>
sealed record ShownStatus(JsonElement State, HttpStatusCode ReadyCode, string Ready, string Metrics, JsonElement? Adapter, JsonElement? Headset)
{
    public static readonly IReadOnlyList<string> Places = ["page", "readyz", "metrics", "diagnostics", "headset"];

    static readonly string[] GoodJoints = ["live", "rest"], GoodPoses = ["current", "coarse"], GoodClocks = ["coarse", "synchronised"];

    public static async Task<ShownStatus> ReadAsync(HttpClient http, HeardDiagnostics diagnostics)
    {
        using var ready = await http.GetAsync("readyz");
        return new ShownStatus(
            JsonDocument.Parse(await http.GetStringAsync("operations/state")).RootElement, ready.StatusCode, await ready.Content.ReadAsStringAsync(),
            await http.GetStringAsync("metrics"), diagnostics.NewestOf("plant/plc"), diagnostics.NewestOf("headless"));
    }

    public IEnumerable<JsonElement> Joints => State.GetProperty("joints").EnumerateArray();
    public IEnumerable<JsonElement> Events => State.GetProperty("events").EnumerateArray();

    public static string Text(JsonElement element, string key) => element.TryGetProperty(key, out var value) ? value.ToString() : "";

    /// <summary>Whether all joints have this state.</summary>
    public bool AreAll(string state) => Joints.All(joint => Text(joint, "state") == state);

    /// <summary>Whether all joints except this one have values of the last second.</summary>
    public bool AreOthersLive(string joint) => Joints.Where(other => Text(other, "name") != joint)
        .All(other => Text(other, "state") == "live" && other.GetProperty("age_s").GetDouble() < 1);

    /// <summary>Whether the headset is synchronised but has no current pose only because this joint is missing.</summary>
    public bool IsHeadsetWithout(string joint) => Headset is { } headset && Text(headset, "level") == "2"
        && GoodClocks.Contains(ValueOf(headset, "state")) && !GoodPoses.Contains(ValueOf(headset, "pose")) && ValueOf(headset, "missing_joints") == joint;

    /// <summary>Whether a place reports this joint with this state and with the reason. The headset's own result is tested separately.</summary>
    /// <param name="reason">Regular expression for the reason.</param>
    /// <param name="word">The word for the reason in the metrics.</param>
    public bool Reports(string place, string joint, string state, string reason, string word) => place switch
    {
        "page" => Text(State.GetProperty("status"), "level") == "error"
            && Joints.Any(row => Text(row, "name") == joint && Text(row, "state") == state && Regex.IsMatch(Text(row, "reason"), reason)),
        "readyz" => ReadyCode == HttpStatusCode.ServiceUnavailable && Regex.IsMatch(Ready, $"(?m)^joint {joint} .*{reason}"),
        "metrics" => Metrics.Contains("nowpose_ready 0\n") && Metrics.Contains($"nowpose_joint_state{{joint=\"{joint}\",source=\"plc\",state=\"{state}\"}} 1\n")
            && Metrics.Contains($"nowpose_joint_fault{{joint=\"{joint}\",source=\"plc\",reason=\"{word}\"}} 1\n"),
        "diagnostics" => Adapter is { } adapter && Text(adapter, "level") == "2" && Regex.IsMatch(Text(adapter, "message"), $"^{joint} {state}: .*{reason}")
            && Regex.IsMatch(ValueOf(adapter, "joint/" + joint), $"^{state} .*{reason}"),
        "headset" => IsHeadsetWithout(joint),
        _ => throw new ArgumentOutOfRangeException(nameof(place)),
    };

    public bool IsGood(string place) => place switch
    {
        "page" => Text(State.GetProperty("status"), "level") == "ok" && Joints.Any() && Joints.All(row => GoodJoints.Contains(Text(row, "state"))),
        "readyz" => ReadyCode == HttpStatusCode.OK,
        "metrics" => Metrics.Contains("nowpose_ready 1\n") && !Regex.IsMatch(Metrics, "nowpose_joint_state{.*,state=\"(missing|refused|fault|stale)\"} 1")
            && !Metrics.Contains("nowpose_joint_fault{"),
        "diagnostics" => Adapter is { } adapter && Text(adapter, "level") == "0"
            && Values(adapter).Where(pair => Text(pair, "key").StartsWith("joint/", StringComparison.Ordinal)).All(pair => GoodJoints.Contains(Text(pair, "value").Split(' ')[0])),
        "headset" => Headset is { } headset && Text(headset, "level") == "0" && GoodPoses.Contains(ValueOf(headset, "pose"))
            && ValueOf(headset, "missing_joints").Length == 0,
        _ => throw new ArgumentOutOfRangeException(nameof(place)),
    };

    public override string ToString() => $"{Ready}{State}\n{Adapter}\n{Headset}";

    static IEnumerable<JsonElement> Values(JsonElement status) => status.GetProperty("values").EnumerateArray();

    static string ValueOf(JsonElement status, string key) =>
        Values(status).Where(pair => Text(pair, "key") == key).Select(pair => Text(pair, "value")).FirstOrDefault("");
}
