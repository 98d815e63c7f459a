using System.Text.Json.Nodes;

namespace Nowpose.Gateway.Status.Prometheus;

/// <summary>Writes the metrics of the control system: the control clock, the clocks of plants, adapters, and sources of joint positions.</summary>
/// <remarks>
/// The number of label values is bounded: clocks, adapters and sources are limited where they are received, and the reasons for refusals here.
/// </remarks>
static class PlantMetrics
{
    const string RefusedPrefix = "refused/";
    const int MaxReasons = 32;
    const double Milli = 1e-3, Micro = 1e-6;

    public static void Add(PrometheusText text, StatusSnapshot state)
    {
        AddClock(text, state.Clock);
        AddPlantClocks(text, state.PlantClocks);
        AddAdapters(text, state.Adapters);
        AddRefusals(text, state.Adapters);
        AddSources(text, state.Sources);
    }

    static void AddClock(PrometheusText text, ClockStatus clock)
    {
        text.Begin("nowpose_clock_synchronised", "1 while the served control clock is synchronised.")
            .Add(clock.IsServed ? 1 : 0, ("source", clock.Source));
        text.One("nowpose_clock_error_bound_seconds", "Error bound of the served control clock.", clock.ErrorBoundUs * Micro);
        text.One("nowpose_clock_skew_ratio", "Rate of the control clock relative to the gateway's counter, minus one.", clock.SkewPpm * Micro);
        text.One("nowpose_clock_resolution_seconds", "Resolution of the control clock.", clock.ResolutionUs * Micro);
        text.One("nowpose_clock_warning", "1 while stamps of sources contradict the control clock.", clock.Warning == null ? 0 : 1);
        text.One("nowpose_clock_steps_total", "Clock steps of the control clock since the gateway started.", clock.Steps);
    }

    static void AddPlantClocks(PrometheusText text, IReadOnlyList<PlantClockView> clocks)
    {
        void Add(string name, string help, Func<PlantClockView, double?> value) =>
            text.Each(name, help, clocks, clock => [("clock", clock.Name)], value);

        Add("nowpose_plant_clock_connected", "1 while the clock is connected.", clock => clock.Connected ? 1 : 0);
        Add("nowpose_plant_clock_offset_seconds", "This clock minus the control clock.", clock => clock.OffsetToControlMs * Milli);
        Add("nowpose_plant_clock_skew_ratio", "Rate of this clock relative to the control clock, minus one.", clock => clock.SkewPpm * Micro);
        Add("nowpose_plant_clock_drift_ratio", "Former name of nowpose_plant_clock_skew_ratio.", clock => clock.SkewPpm * Micro);
        Add("nowpose_plant_clock_round_trip_seconds", "Round-trip time of an exchange.", clock => clock.RttMs * Milli);
        Add("nowpose_plant_clock_estimated_error_seconds", "Estimated error of the offset.", clock => clock.EstimatedErrorUs * Micro);
        Add("nowpose_plant_clock_error_bound_seconds", "Error bound of the offset.", clock => clock.ErrorBoundUs * Micro);
        Add("nowpose_plant_clock_exchanges_total", "Successful sync exchanges.", clock => clock.Exchanges);
        Add("nowpose_plant_clock_failures_total", "Unanswered exchanges.", clock => clock.Failures);
    }

    static void AddAdapters(PrometheusText text, IReadOnlyList<JsonObject> adapters)
    {
        void Add(string name, string help, Func<JsonObject, double?> value) =>
            text.Each(name, help, adapters, adapter => [LabelOf(adapter)], value);

        Add(
            "nowpose_adapter_connected", "1 while the adapter is connected to its plant; 0 also while the adapter does not report.",
            adapter => StatusObjects.IsSilent(adapter) ? 0 : StatusObjects.OneIf(adapter, "state", "connected"));
        Add("nowpose_adapter_samples_total", "Samples that the adapter published.", adapter => StatusObjects.Number(adapter, "samples"));
        Add(
            "nowpose_adapter_refused_total", "Refused values: bad status, no finite number, invalid time stamp, or deleted node.",
            adapter => StatusObjects.Number(adapter, "refused"));
        Add("nowpose_adapter_reconnects_total", "Number of reconnections.", adapter => StatusObjects.Number(adapter, "reconnects"));
    }

    static void AddSources(PrometheusText text, IReadOnlyList<SourceStatus> sources)
    {
        text.Each(
            "nowpose_source_rate_hertz", "Messages per second over the last few seconds.", sources, source => [LabelOf(source)],
            source => source.RateHz);
        text.Begin("nowpose_source_age_seconds", "Control time at the gateway minus the samples' time stamps, over the last few seconds.", "summary");
        foreach (var source in sources)
        {
            text.Add(source.AgeMs?.P50 * Milli, LabelOf(source), ("quantile", "0.5"));
            text.Add(source.AgeMs?.P95 * Milli, LabelOf(source), ("quantile", "0.95"));
        }

        text.Each(
            "nowpose_source_beyond_limits", "Number of joints outside the limits of the described robot.", sources, source => [LabelOf(source)],
            source => source.BeyondLimits.Count);
    }

    static void AddRefusals(PrometheusText text, IReadOnlyList<JsonObject> adapters)
    {
        var isBegun = false;
        foreach (var adapter in adapters)
        {
            foreach (var (key, _) in adapter.Where(pair => pair.Key.StartsWith(RefusedPrefix, StringComparison.Ordinal)).Take(MaxReasons))
            {
                if (!isBegun) text.Begin("nowpose_adapter_refusals_total", "Values that the adapter refused, by reason.");
                isBegun = true;
                text.Add(StatusObjects.Number(adapter, key), LabelOf(adapter), ("reason", key[RefusedPrefix.Length..]));
            }
        }
    }

    static (string, string) LabelOf(JsonObject adapter) => ("adapter", (string)adapter["name"]);

    // Escapes commas in names, and sorts the names, so that the label does not depend on the order in which joints were first published.
    static (string, string) LabelOf(SourceStatus source) => (
        "joints", string.Join(',', source.Joints.Order(StringComparer.Ordinal).Select(Escaped)));

    static string Escaped(string name) => name.Replace("\\", "\\\\", StringComparison.Ordinal).Replace(",", "\\,", StringComparison.Ordinal);
}
