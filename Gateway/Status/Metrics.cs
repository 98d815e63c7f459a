using System.Diagnostics;
using System.Globalization;
using System.Text.Json.Nodes;
using Nowpose.Gateway.Status.Cell;

namespace Nowpose.Gateway.Status;

/// <summary>Writes the gateway's metrics for Prometheus, in seconds, bytes and ratios. Their names start with nowpose_.</summary>
static class Metrics
{
    const string Gauge = "gauge", Counter = "counter";
    const double Milli = 1e-3, Micro = 1e-6;

    public static string Of(StatusSnapshot state, ForwardingTimes forwarding)
    {
        var text = new PrometheusText();
        text.Begin("nowpose_gateway_info", Gauge, "Version of the gateway.").Add(1, ("version", state.Version));
        AddVersions(text, state);
        text.One("nowpose_uptime_seconds", Gauge, "Time since the start.", state.UptimeS);
        text.One("nowpose_ready", Gauge, "1 when headsets can be served; /readyz names the missing parts.", state.IsReady ? 1 : 0);
        text.One(
            "nowpose_certificate_expiry_timestamp_seconds", Gauge, "Unix time at which the certificate expires.",
            (state.CertificateExpiresUtc - DateTime.UnixEpoch)?.TotalSeconds);
        AddClock(text, state.Clock);
        AddPlantClocks(text, state.PlantClocks);
        AddAdapters(text, state.Adapters);
        AddSources(text, state.Sources);
        JointMetrics.Add(text, state);
        CellMetrics.Add(text, state);
        AddForwarding(text, forwarding);
        AddHeadsets(text, state.Headsets);
        AddCounts(text, state);
        AddRecording(text, state.Recording);
        AddProcess(text);
        return text.ToString();
    }

    static void AddVersions(PrometheusText text, StatusSnapshot state)
    {
        static int Others(IReadOnlyList<JsonObject> clients) => clients.Count(client => !NowposeVersion.Fits(StatusObjects.Word(client, "version")));
        text.Begin("nowpose_version_mismatches", Gauge, "Headsets and adapters whose version is not compatible with that of the gateway.")
            .Add(Others(state.Headsets), ("kind", "headset")).Add(Others(state.Adapters), ("kind", "adapter"));
    }

    static void AddClock(PrometheusText text, ClockStatus clock)
    {
        text.Begin("nowpose_clock_synchronised", Gauge, "1 while the served control clock is synchronised.")
            .Add(clock.IsServed ? 1 : 0, ("source", clock.Source));
        text.One("nowpose_clock_error_bound_seconds", Gauge, "Error bound of the served control clock.", clock.ErrorBoundUs * Micro);
        text.One("nowpose_clock_skew_ratio", Gauge, "Rate of the control clock relative to the gateway's counter, minus one.", clock.SkewPpm * Micro);
        text.One("nowpose_clock_resolution_seconds", Gauge, "Resolution of the control clock.", clock.ResolutionUs * Micro);
        text.One("nowpose_clock_warning", Gauge, "1 while stamps of sources contradict the control clock.", clock.Warning == null ? 0 : 1);
        text.One("nowpose_clock_steps_total", Counter, "Clock steps of the control clock since the gateway started.", clock.Steps);
    }

    static void AddPlantClocks(PrometheusText text, IReadOnlyList<PlantClockView> clocks)
    {
        void Add(string name, string type, string help, Func<PlantClockView, double?> value) =>
            AddEach(text, name, type, help, clocks, clock => ("clock", clock.Name), value);

        Add("nowpose_plant_clock_connected", Gauge, "1 while the clock is connected.", clock => clock.Connected ? 1 : 0);
        Add("nowpose_plant_clock_offset_seconds", Gauge, "This clock minus the control clock.", clock => clock.OffsetToControlMs * Milli);
        Add("nowpose_plant_clock_skew_ratio", Gauge, "Rate of this clock relative to the control clock, minus one.", clock => clock.SkewPpm * Micro);
        Add("nowpose_plant_clock_drift_ratio", Gauge, "Former name of nowpose_plant_clock_skew_ratio.", clock => clock.SkewPpm * Micro);
        Add("nowpose_plant_clock_round_trip_seconds", Gauge, "Round-trip time of an exchange.", clock => clock.RttMs * Milli);
        Add("nowpose_plant_clock_estimated_error_seconds", Gauge, "Estimated error of the offset.", clock => clock.EstimatedErrorUs * Micro);
        Add("nowpose_plant_clock_error_bound_seconds", Gauge, "Error bound of the offset.", clock => clock.ErrorBoundUs * Micro);
        Add("nowpose_plant_clock_exchanges_total", Counter, "Successful sync exchanges.", clock => clock.Exchanges);
        Add("nowpose_plant_clock_failures_total", Counter, "Unanswered exchanges.", clock => clock.Failures);
    }

    static void AddAdapters(PrometheusText text, IReadOnlyList<JsonObject> adapters)
    {
        void Add(string name, string type, string help, Func<JsonObject, double?> value) =>
            AddEach(text, name, type, help, adapters, adapter => ("adapter", NameOf(adapter)), value);

        Add(
            "nowpose_adapter_connected", Gauge, "1 while the adapter is connected to its plant; 0 also while the adapter does not report.",
            adapter => StatusObjects.IsSilent(adapter) ? 0 : OneIf(adapter, "state", "connected"));
        Add("nowpose_adapter_samples_total", Counter, "Samples that the adapter published.", adapter => StatusObjects.Number(adapter, "samples"));
        Add("nowpose_adapter_refused_total", Counter, "Refused values: bad status, no finite number, invalid time stamp, or deleted node.", adapter => StatusObjects.Number(adapter, "refused"));
        Add("nowpose_adapter_reconnects_total", Counter, "Number of reconnections.", adapter => StatusObjects.Number(adapter, "reconnects"));
    }

    static void AddSources(PrometheusText text, IReadOnlyList<SourceStatus> sources)
    {
        AddEach(
            text, "nowpose_source_rate_hertz", Gauge, "Messages per second over the last few seconds.", sources, LabelOf, source => source.RateHz);
        text.Begin("nowpose_source_age_seconds", "summary", "Control time at the gateway minus the samples' time stamps, over the last few seconds.");
        foreach (var source in sources)
        {
            text.Add(source.AgeMs?.P50 * Milli, LabelOf(source), ("quantile", "0.5"));
            text.Add(source.AgeMs?.P95 * Milli, LabelOf(source), ("quantile", "0.95"));
        }

        AddEach(
            text, "nowpose_source_beyond_limits", Gauge, "Number of joints outside the limits of the described robot.", sources, LabelOf,
            source => source.BeyondLimits.Count);
    }

    static void AddForwarding(PrometheusText text, ForwardingTimes times)
    {
        text.Begin("nowpose_forward_seconds", "histogram", "Time from a sample's receipt to a subscriber's socket.");
        var counts = times.Counts();
        var below = 0L;
        for (var i = 0; i < ForwardingTimes.Limits.Length; i++)
        {
            below += counts[i];
            text.Add("_bucket", below, ("le", ForwardingTimes.Limits[i].ToString("R", CultureInfo.InvariantCulture)));
        }

        text.Add("_bucket", below + counts[^1], ("le", "+Inf")).Add("_sum", times.Sum).Add("_count", below + counts[^1]);
    }

    static void AddHeadsets(PrometheusText text, IReadOnlyList<JsonObject> headsets)
    {
        text.One("nowpose_headsets", Gauge, "Headsets that reported within the last half minute.", headsets.Count);
        AddEach(
            text, "nowpose_headset_seen_seconds", Gauge, "Time since the headset's last report.", headsets, LabelOf,
            headset => StatusObjects.Number(headset, "seen_s_ago"));
        var reporting = headsets.Where(headset => !StatusObjects.IsSilent(headset)).ToList();
        void Add(string name, string help, string key, double unit) =>
            AddEach(text, name, Gauge, help, reporting, LabelOf, headset => StatusObjects.Number(headset, key) * unit);

        AddEach(
            text, "nowpose_headset_synchronised", Gauge, "1 while the headset's clock is synchronised, 0 in all other states.", reporting, LabelOf,
            headset => OneIf(headset, "state", "synchronised"));
        Add("nowpose_headset_clock_error_bound_seconds", "Error bound of the headset's clock.", "error_bound_us", Micro);
        Add("nowpose_headset_round_trip_seconds", "Round-trip time of the headset's clock synchronisation.", "rtt_ms", Milli);
        Add("nowpose_headset_application_latency_seconds", "L_app.", "l_app_ms", Milli);
        Add("nowpose_headset_visualisation_latency_seconds", "L_visu.", "l_visu_ms", Milli);
        Add("nowpose_headset_render_seconds", "Render time of the last frame.", "render_ms", Milli);
        Add("nowpose_headset_objects_not_current", "Objects that the headset shows and that are not current.", "objects_not_current", 1);
        Add("nowpose_headset_signals_not_current", "Signals that the headset uses and that are not current.", "signals_not_current", 1);
        Add("nowpose_headset_error_reduction_ratio", "Share of the uncompensated error that the prediction removes.", "reduction", 1);
    }

    static void AddCounts(PrometheusText text, StatusSnapshot state)
    {
        var servers = state.Connections.ToList();
        AddEach(text, "nowpose_connections", Gauge, "Open connections.", servers, server => ("server", server.Key), server => server.Value.Open);
        AddEach(
            text, "nowpose_connections_accepted_total", Counter, "Accepted connections.", servers, server => ("server", server.Key),
            server => server.Value.Accepted);
        text.Begin("nowpose_connections_closed_total", Counter, "Refused or ended connections, by reason.");
        foreach (var (server, connections) in servers)
            foreach (var (reason, count) in connections.Closures) text.Add(count, ("server", server), ("reason", reason));
        AddEach(text, "nowpose_messages_total", Counter, "Forwarded messages.", [.. state.Messages], one => ("topic", one.Key), one => one.Value);
        AddEach(text, "nowpose_drops_total", Counter, "Dropped messages.", [.. state.Drops], one => ("reason", one.Key), one => one.Value);
    }

    static void AddRecording(PrometheusText text, RecordingStatus recording)
    {
        text.One("nowpose_recording_on", Gauge, "1 while the gateway records.", recording.On ? 1 : 0);
        text.One("nowpose_recording_failed", Gauge, "1 when the recording stopped because of a problem.", recording.Problem == null ? 0 : 1);
        text.One("nowpose_recording_lines", Gauge, "Lines in the newest recording, all files together.", recording.Lines);
        text.One("nowpose_recording_bytes", Gauge, "Size of the newest recording, all files together.", recording.Bytes);
        text.One("nowpose_recording_lost_lines", Gauge, "Lines that are missing from the newest recording.", recording.Lost);
    }

    static void AddProcess(PrometheusText text)
    {
        using var process = Process.GetCurrentProcess();
        text.One("process_cpu_seconds_total", Counter, "Processor time.", process.TotalProcessorTime.TotalSeconds);
        text.One("process_resident_memory_bytes", Gauge, "Resident memory.", process.WorkingSet64);
        text.One("nowpose_managed_memory_bytes", Gauge, "Memory of the managed heap.", GC.GetTotalMemory(false));
    }

    static void AddEach<T>(
        PrometheusText text, string name, string type, string help, IReadOnlyList<T> all, Func<T, (string, string)> label, Func<T, double?> value)
    {
        if (all.Count == 0) return;
        text.Begin(name, type, help);
        foreach (var one in all) text.Add(value(one), label(one));
    }

    // Escapes commas in names, and sorts the names, so that the label does not depend on the order in which joints were first published.
    static (string, string) LabelOf(SourceStatus source) => (
        "joints", string.Join(',', source.Joints.Order(StringComparer.Ordinal).Select(Escaped)));

    static (string, string) LabelOf(JsonObject headset) => ("headset", NameOf(headset));

    static string Escaped(string name) => name.Replace("\\", "\\\\", StringComparison.Ordinal).Replace(",", "\\,", StringComparison.Ordinal);

    static string NameOf(JsonObject words) => (string)words["name"];

    static double? OneIf(JsonObject words, string key, string yes) => StatusObjects.Word(words, key) is { } word ? (word == yes ? 1 : 0) : null;
}
