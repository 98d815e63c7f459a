using Nowpose.Gateway.Status.Joints;

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
        text.States(
            "nowpose_joint_state",
            "1 for the present state of the joint, 0 for the other states. rest: no change is reported, and the joint is assumed at rest.", joints,
            LabelsOf, joint => joint.State, JointDataStates.Names);
        text.Each(
            "nowpose_joint_fault", "1 for a joint that is stale, refused, in fault or missing, with one word for the reason.",
            joints.Where(joint => joint.ReasonWord != null).ToList(),
            joint => [.. LabelsOf(joint), ("reason", JointFaultReasons.Of(joint.ReasonWord))], _ => 1);
        void Add(string name, string help, Func<JointView, double?> value) => text.Each(name, help, joints, LabelsOf, value);

        Add(
            "nowpose_joint_rest_uncertain", "1 for a joint that may not be at rest although no change of it is reported, 0 otherwise.",
            joint => joint.Uncertain == null ? 0 : 1);
        Add(
            "nowpose_joint_state_since_seconds", "Unix time at which the present state of the joint began.",
            joint => UtcText.UnixSeconds(joint.SinceUtc));
        Add("nowpose_joint_age_seconds", "Control time minus the stamp of the joint's newest sample.", joint => joint.AgeS);
        Add("nowpose_joint_rate_hertz", "Samples of the joint per second.", joint => joint.RateHz);
    }

    static (string, string)[] LabelsOf(JointView joint) => [("joint", joint.Name), ("source", joint.Source)];
}
