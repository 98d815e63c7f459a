using System.Diagnostics;
using System.Globalization;
using System.Text.Json.Nodes;
using Nowpose.Gateway.Status.Events;

namespace Nowpose.Gateway.Status.Prometheus;

/// <summary>Writes the gateway's metrics for Prometheus, in seconds, bytes and ratios. Their names start with nowpose_.</summary>
static class Metrics
{
    public static string Of(StatusSnapshot state, ForwardingTimes forwarding)
    {
        var text = new PrometheusText();
        text.Begin("nowpose_gateway_info", "Version of the gateway.").Add(1, ("version", state.Version));
        AddVersions(text, state);
        text.One("nowpose_uptime_seconds", "Time since the start.", state.UptimeS);
        text.One("nowpose_ready", "1 when headsets can be served; /readyz names the missing parts.", state.IsReady ? 1 : 0);
        text.One(
            "nowpose_certificate_expiry_timestamp_seconds", "Unix time at which the certificate expires.",
            (state.CertificateExpiresUtc - DateTime.UnixEpoch)?.TotalSeconds);
        PlantMetrics.Add(text, state);
        JointMetrics.Add(text, state.Joints);
        CellMetrics.Add(text, state);
        AddForwarding(text, forwarding);
        HeadsetMetrics.Add(text, state.Headsets);
        AddCounts(text, state);
        AddEvents(text, state.Events);
        AddRecording(text, state.Recording);
        AddProcess(text);
        return text.ToString();
    }

    static void AddVersions(PrometheusText text, StatusSnapshot state)
    {
        static int Others(IReadOnlyList<JsonObject> clients) => clients.Count(client => !NowposeVersion.Fits(StatusObjects.Word(client, "version")));
        text.Begin("nowpose_version_mismatches", "Headsets and adapters whose version is not compatible with that of the gateway.")
            .Add(Others(state.Headsets), ("kind", "headset")).Add(Others(state.Adapters), ("kind", "adapter"));
    }

    static void AddForwarding(PrometheusText text, ForwardingTimes times)
    {
        text.Begin("nowpose_forward_seconds", "Time from a sample's receipt to a subscriber's socket.", "histogram");
        var counts = times.Counts();
        var below = 0L;
        for (var i = 0; i < ForwardingTimes.Limits.Length; i++)
        {
            below += counts[i];
            text.Add("_bucket", below, ("le", ForwardingTimes.Limits[i].ToString("R", CultureInfo.InvariantCulture)));
        }

        text.Add("_bucket", below + counts[^1], ("le", "+Inf")).Add("_sum", times.Sum).Add("_count", below + counts[^1]);
    }

    static void AddCounts(PrometheusText text, StatusSnapshot state)
    {
        var servers = state.Connections.ToList();
        text.Each("nowpose_connections", "Open connections.", servers, server => [("server", server.Key)], server => server.Value.Open);
        text.Each(
            "nowpose_connections_accepted_total", "Accepted connections.", servers, server => [("server", server.Key)],
            server => server.Value.Accepted);
        text.Begin("nowpose_connections_closed_total", "Refused or ended connections, by reason.");
        foreach (var (server, connections) in servers)
            foreach (var (reason, count) in connections.Closures) text.Add(count, ("server", server), ("reason", reason));
        text.Each("nowpose_messages_total", "Forwarded messages.", [.. state.Messages], one => [("topic", one.Key)], one => one.Value);
        text.Each("nowpose_drops_total", "Dropped messages.", [.. state.Drops], one => [("reason", one.Key)], one => one.Value);
    }

    static void AddEvents(PrometheusText text, IReadOnlyList<EventView> events)
    {
        if (events.Count == 0) return;
        text.Begin("nowpose_events_active", "Active events, by kind.");
        foreach (var kind in events.GroupBy(one => one.Kind)) text.Add(kind.Count(one => one.UntilUtc == null), ("kind", kind.Key));
    }

    static void AddRecording(PrometheusText text, RecordingStatus recording)
    {
        text.One("nowpose_recording_on", "1 while the gateway records.", recording.On ? 1 : 0);
        text.One("nowpose_recording_failed", "1 when the recording stopped because of a problem.", recording.Problem == null ? 0 : 1);
        text.One("nowpose_recording_lines", "Lines in the newest recording, all files together.", recording.Lines);
        text.One("nowpose_recording_bytes", "Size of the newest recording, all files together.", recording.Bytes);
        text.One("nowpose_recording_lost_lines", "Lines that are missing from the newest recording.", recording.Lost);
    }

    static void AddProcess(PrometheusText text)
    {
        using var process = Process.GetCurrentProcess();
        text.One("process_cpu_seconds_total", "Processor time.", process.TotalProcessorTime.TotalSeconds);
        text.One("process_resident_memory_bytes", "Resident memory.", process.WorkingSet64);
        text.One("nowpose_managed_memory_bytes", "Memory of the managed heap.", GC.GetTotalMemory(false));
    }
}
