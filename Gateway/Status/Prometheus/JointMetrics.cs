using Nowpose.Gateway.Status.Joints;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Status.Prometheus;

/// <summary>Writes the metrics of joints: the state, the fault and the samples of each joint per source.</summary>
/// <remarks>
/// The number of label values is bounded: states and reasons for a joint's fault are fixed sets, and the numbers of joints and sources of a joint are
/// limited where they are received.
/// </remarks>
static class JointMetrics
{
    public static void Add(PrometheusText text, IReadOnlyList<JointView> joints)
    {
        if (joints.Count == 0) return;
        text.Begin(
            "nowpose_joint_state",
            "1 for the present state of the joint, 0 for the other states. rest: no change is reported, and the joint is assumed at rest.");
        foreach (var joint in joints)
            foreach (var word in JointDataStates.Names)
                text.Add(joint.State == word ? 1 : 0, ("joint", joint.Name), ("source", joint.Source), ("state", word));
        AddFaults(text, joints);
        text.Begin("nowpose_joint_rest_uncertain", "1 for a joint that may not be at rest although no change of it is reported, 0 otherwise.");
        foreach (var joint in joints) text.Add(joint.Uncertain == null ? 0 : 1, ("joint", joint.Name), ("source", joint.Source));
        text.Begin("nowpose_joint_state_since_seconds", "Unix time at which the present state of the joint began.");
        foreach (var joint in joints) text.Add(UtcText.UnixSeconds(joint.SinceUtc), ("joint", joint.Name), ("source", joint.Source));
        text.Begin("nowpose_joint_age_seconds", "Control time minus the stamp of the joint's newest sample.");
        foreach (var joint in joints) text.Add(joint.AgeS, ("joint", joint.Name), ("source", joint.Source));
        text.Begin("nowpose_joint_rate_hertz", "Samples of the joint per second.");
        foreach (var joint in joints) text.Add(joint.RateHz, ("joint", joint.Name), ("source", joint.Source));
    }

    static void AddFaults(PrometheusText text, IReadOnlyList<JointView> joints)
    {
        var faults = joints.Where(joint => joint.ReasonWord != null).ToList();
        if (faults.Count == 0) return;
        text.Begin("nowpose_joint_fault", "1 for a joint that is stale, refused, in fault or missing, with one word for the reason.");
        foreach (var joint in faults)
            text.Add(1, ("joint", joint.Name), ("source", joint.Source), ("reason", JointFaultReasons.Of(joint.ReasonWord)));
    }
}
