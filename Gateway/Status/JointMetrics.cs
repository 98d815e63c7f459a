using System.Text.Json.Nodes;
using Nowpose.Gateway.Status.Events;
using Nowpose.Gateway.Status.Joints;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Status;

/// <summary>
/// Writes the metrics on which alerts are based: the state and the fault of each joint per source, refusals by reason, the clock and the pose of each headset,
/// and active events.
/// </summary>
/// <remarks>
/// The number of label values is bounded: states and reasons for a joint's fault are fixed sets, and the numbers of joints, sources of a joint, adapters,
/// reasons for a refusal and headsets are limited where they are received.
/// </remarks>
static class JointMetrics
{
    const string Gauge = "gauge", Counter = "counter", RefusedPrefix = "refused/", Other = "other";
    const int MaxReasons = 32;

    // The pose states in the protocol. Any other state counts as "other".
    static readonly string[] PoseStates = ["current", "coarse", "held", "unsynchronised", "incomplete", "outside", Other];

    static readonly string[] ClockStates = [.. Enum.GetValues<ClockState>().Select(state => state.Word()), Other];

    public static void Add(PrometheusText text, StatusSnapshot state)
    {
        AddJoints(text, state.Joints);
        AddRefusals(text, state.Adapters);
        var headsets = state.Headsets.Where(headset => !StatusObjects.IsSilent(headset)).ToList();
        AddStates(text, "nowpose_headset_clock_state", "the headset's clock", headsets, "state", ClockStates);
        AddStates(text, "nowpose_headset_pose_state", "the headset's pose", headsets, "pose", PoseStates);
        AddPoses(text, headsets);
        if (state.Events.Count == 0) return;
        text.Begin("nowpose_events_active", Gauge, "Active events, by kind.");
        foreach (var kind in state.Events.GroupBy(one => one.Kind)) text.Add(kind.Count(one => one.UntilUtc == null), ("kind", kind.Key));
    }

    static void AddJoints(PrometheusText text, IReadOnlyList<JointView> joints)
    {
        if (joints.Count == 0) return;
        text.Begin("nowpose_joint_state", Gauge, "1 for the present state of the joint, 0 for the other states. rest: no change is reported, and the joint is assumed at rest.");
        foreach (var joint in joints)
            foreach (var word in JointDataStates.Names)
                text.Add(joint.State == word ? 1 : 0, ("joint", joint.Name), ("source", joint.Source), ("state", word));
        AddFaults(text, joints);
        text.Begin("nowpose_joint_rest_uncertain", Gauge, "1 for a joint that may not be at rest although no change of it is reported, 0 otherwise.");
        foreach (var joint in joints) text.Add(joint.Uncertain == null ? 0 : 1, ("joint", joint.Name), ("source", joint.Source));
        text.Begin("nowpose_joint_state_since_seconds", Gauge, "Unix time at which the present state of the joint began.");
        foreach (var joint in joints) text.Add(UtcText.UnixSeconds(joint.SinceUtc), ("joint", joint.Name), ("source", joint.Source));
        text.Begin("nowpose_joint_age_seconds", Gauge, "Control time minus the stamp of the joint's newest sample.");
        foreach (var joint in joints) text.Add(joint.AgeS, ("joint", joint.Name), ("source", joint.Source));
        text.Begin("nowpose_joint_rate_hertz", Gauge, "Samples of the joint per second.");
        foreach (var joint in joints) text.Add(joint.RateHz, ("joint", joint.Name), ("source", joint.Source));
    }

    static void AddFaults(PrometheusText text, IReadOnlyList<JointView> joints)
    {
        var faults = joints.Where(joint => joint.ReasonWord != null).ToList();
        if (faults.Count == 0) return;
        text.Begin("nowpose_joint_fault", Gauge, "1 for a joint that is stale, refused, in fault or missing, with one word for the reason.");
        foreach (var joint in faults) text.Add(1, ("joint", joint.Name), ("source", joint.Source), ("reason", JointFaultReasons.Of(joint.ReasonWord)));
    }

    static void AddRefusals(PrometheusText text, IReadOnlyList<JsonObject> adapters)
    {
        var isBegun = false;
        foreach (var adapter in adapters)
        {
            foreach (var (key, _) in adapter.Where(pair => pair.Key.StartsWith(RefusedPrefix, StringComparison.Ordinal)).Take(MaxReasons))
            {
                if (!isBegun) text.Begin("nowpose_adapter_refusals_total", Counter, "Values that the adapter refused, by reason.");
                isBegun = true;
                text.Add(StatusObjects.Number(adapter, key), ("adapter", (string)adapter["name"]), ("reason", key[RefusedPrefix.Length..]));
            }
        }
    }

    static void AddStates(PrometheusText text, string name, string what, IReadOnlyList<JsonObject> headsets, string key, string[] states)
    {
        var known = headsets.Where(headset => StatusObjects.Word(headset, key) != null).ToList();
        if (known.Count == 0) return;
        text.Begin(name, Gauge, $"1 for the present state of {what}, 0 for the other states.");
        foreach (var headset in known)
        {
            var word = StatusObjects.Word(headset, key);
            var present = states.Contains(word) ? word : Other;
            foreach (var state in states) text.Add(state == present ? 1 : 0, ("headset", (string)headset["name"]), ("state", state));
        }
    }

    static void AddPoses(PrometheusText text, IReadOnlyList<JsonObject> headsets)
    {
        var known = headsets.Where(headset => StatusObjects.Word(headset, "pose") != null).ToList();
        if (known.Count == 0) return;
        text.Begin("nowpose_headset_current_share_ratio", Gauge, "Share of frames with a current pose.");
        foreach (var headset in known) text.Add(StatusObjects.Number(headset, "current_share"), ("headset", (string)headset["name"]));
        text.Begin("nowpose_headset_missing_joints", Gauge, "Joints of the robot without a sample on the headset.");
        foreach (var headset in known)
            text.Add(
                StatusObjects.Word(headset, "missing_joints")?.Split(',', StringSplitOptions.RemoveEmptyEntries).Length ?? 0,
                ("headset", (string)headset["name"]));
    }
}
