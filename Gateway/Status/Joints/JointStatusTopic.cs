using System.Globalization;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Hub;

namespace Nowpose.Gateway.Status.Joints;

/// <summary>
/// Publishes the list of joints that are not live on /nowpose/joint_status: after each change, and every second while the list is not empty. Not
/// thread-safe.
/// </summary>
sealed class JointStatusTopic(MessageHub hub, IControlClock clock, TimeProvider time) : IDisposable
{
    static readonly TimeSpan Interval = TimeSpan.FromSeconds(1);

    const int MaxReasonLength = 200;

    // Maximum length of all reasons together, and maximum length of all names and reasons in bytes. The message is then shorter than the 64 KiB that
    // clients accept.
    const int MaxReasonsLength = 16 * 1024, MaxBytes = 48 * 1024;

    // The broker adapter, which forwards this topic to another gateway, searches for this string.
    const string Uncertain = EventTexts.UncertainRestReason;

    readonly HubSource _source = hub.OpenSource();
    List<(string Name, JointDataState State, string Reason)> _sent;
    long _sentAt;

    public void Publish(IReadOnlyList<JointSnapshot> joints)
    {
        // For a joint with two sources, uses the better state, because the samples of the other source are refused.
        // Omits a joint without a source: headsets detect it themselves, and if two gateways are bridged, the other gateway may have a source.
        var troubled = joints.Where(row => row.Source != UnpublishedJoints.NoSource).GroupBy(joint => joint.Name, StringComparer.Ordinal).Select(rows => rows.MinBy(row => row.State))
            .Where(row => row.State != JointDataState.Live).ToList();
        var longest = Math.Min(MaxReasonLength, MaxReasonsLength / Math.Clamp(troubled.Count, 1, ProtocolLimits.Joints));
        int BytesOf(JointSnapshot row) => RosMessageWriter.MaxBytesOf(row.Name) + RosMessageWriter.MaxBytesOf(InputException.OneLine(ReasonOf(row), longest));
        // If there are too many joints, or their names are too long, the most recent failures have priority.
        if (troubled.Count > ProtocolLimits.Joints || troubled.Sum(BytesOf) > MaxBytes)
        {
            var bytes = 0;
            troubled = [.. troubled.OrderBy(row => row.IsGood).ThenByDescending(row => row.Since).Take(ProtocolLimits.Joints)
                .TakeWhile(row => (bytes += BytesOf(row)) <= MaxBytes).OrderBy(row => row.Name, StringComparer.Ordinal)];
        }

        var content = troubled.ConvertAll(row => (row.Name, row.State, ReasonOf(row)));
        var isSame = _sent != null && content.SequenceEqual(_sent);
        if (isSame && (content.Count == 0 || time.GetElapsedTime(_sentAt) < Interval)) return;
        (_sent, _sentAt) = (content, time.GetTimestamp());
        var now = (Control: clock.Now, Utc: time.GetUtcNow());
        var values = troubled.ConvertAll(row => KeyValuePair.Create(row.Name, ValueOf(row, now.Control - (now.Utc - row.Since), longest)));
        // Level 0 for an empty list, 1 if all joints in it are assumed at rest, 2 otherwise.
        var level = troubled.Count == 0 ? 0 : troubled.TrueForAll(row => row.IsGood) ? 1 : 2;
        _source.PublishNewest(RosTopics.JointStatus, new DiagnosticsMessage(now.Control, "gateway", values, level, "joints"));
    }

    public void Dispose() => _source.Dispose();

    static string ReasonOf(JointSnapshot row) => row.Uncertainty.Length == 0 ? row.Reason : Uncertain + row.Uncertainty;

    static string ValueOf(JointSnapshot row, ControlTime since, int longest) => string.Create(
        CultureInfo.InvariantCulture, $"{row.Word} {since.SinceEpoch.TotalSeconds:0.000} {InputException.OneLine(ReasonOf(row), longest)}").TrimEnd();
}
