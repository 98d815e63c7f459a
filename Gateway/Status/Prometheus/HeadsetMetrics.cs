using System.Text.Json.Nodes;

namespace Nowpose.Gateway.Status.Prometheus;

/// <summary>Writes the metrics of headsets from their diagnostics: clock, latencies, pose, objects and signals.</summary>
/// <remarks>The number of label values is bounded: the states are fixed sets, and the number of headsets is limited where they report.</remarks>
static class HeadsetMetrics
{
    const string Other = "other";
    const double Milli = 1e-3, Micro = 1e-6;

    // The pose states in the protocol. Any other state counts as "other".
    static readonly string[] PoseStates = ["current", "coarse", "held", "unsynchronised", "incomplete", "outside", Other];

    static readonly string[] ClockStates = [.. Enum.GetValues<ClockState>().Select(state => state.Word()), Other];

    public static void Add(PrometheusText text, IReadOnlyList<JsonObject> headsets)
    {
        text.One("nowpose_headsets", "Headsets that reported within the last half minute.", headsets.Count);
        text.Each(
            "nowpose_headset_seen_seconds", "Time since the headset's last report.", headsets, LabelsOf,
            headset => StatusObjects.Number(headset, "seen_s_ago"));
        var reporting = headsets.Where(headset => !StatusObjects.IsSilent(headset)).ToList();
        void AddNumber(string name, string help, string key, double unit) =>
            text.Each(name, help, reporting, LabelsOf, headset => StatusObjects.Number(headset, key) * unit);

        text.Each(
            "nowpose_headset_synchronised", "1 while the headset's clock is synchronised, 0 in all other states.", reporting, LabelsOf,
            headset => StatusObjects.OneIf(headset, HeadsetKeys.State, "synchronised"));
        AddNumber("nowpose_headset_clock_error_bound_seconds", "Error bound of the headset's clock.", HeadsetKeys.ErrorBoundUs, Micro);
        AddNumber("nowpose_headset_round_trip_seconds", "Round-trip time of the headset's clock synchronisation.", HeadsetKeys.RoundTripMs, Milli);
        AddNumber("nowpose_headset_application_latency_seconds", "L_app.", HeadsetKeys.ApplicationLatencyMs, Milli);
        AddNumber("nowpose_headset_visualisation_latency_seconds", "L_visu.", HeadsetKeys.VisualisationLatencyMs, Milli);
        AddNumber("nowpose_headset_render_seconds", "Render time of the last frame.", HeadsetKeys.RenderMs, Milli);
        AddNumber("nowpose_headset_objects_not_current", "Objects on the headset that are not current.", HeadsetKeys.ObjectsNotCurrent, 1);
        AddNumber("nowpose_headset_signals_not_current", "Signals on the headset that are not current.", HeadsetKeys.SignalsNotCurrent, 1);
        AddNumber("nowpose_headset_error_reduction_ratio", "Share of the uncompensated error that the prediction removes.", HeadsetKeys.Reduction, 1);
        AddStates(text, "nowpose_headset_clock_state", "the headset's clock", reporting, HeadsetKeys.State, ClockStates);
        AddStates(text, "nowpose_headset_pose_state", "the headset's pose", reporting, HeadsetKeys.Pose, PoseStates);
        AddPoses(text, reporting);
    }

    static void AddStates(PrometheusText text, string name, string what, IReadOnlyList<JsonObject> headsets, string key, string[] states)
    {
        var known = headsets.Where(headset => StatusObjects.Word(headset, key) != null).ToList();
        text.States(
            name, $"1 for the present state of {what}, 0 for the other states.", known, LabelsOf,
            headset => StatusObjects.Word(headset, key) is var word && states.Contains(word) ? word : Other, states);
    }

    static void AddPoses(PrometheusText text, IReadOnlyList<JsonObject> headsets)
    {
        var known = headsets.Where(headset => StatusObjects.Word(headset, HeadsetKeys.Pose) != null).ToList();
        text.Each(
            "nowpose_headset_current_share_ratio", "Share of frames with a current pose.", known, LabelsOf,
            headset => StatusObjects.Number(headset, HeadsetKeys.CurrentShare));
        text.Each(
            "nowpose_headset_missing_joints", "Joints of the robot without a sample on the headset.", known, LabelsOf,
            headset => StatusObjects.Word(headset, HeadsetKeys.MissingJoints)?.Split(',', StringSplitOptions.RemoveEmptyEntries).Length ?? 0);
    }

    static (string, string)[] LabelsOf(JsonObject headset) => [("headset", (string)headset["name"])];
}
