using System.Globalization;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Messages;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Status.Joints;

/// <summary>Publishes the joints that are not live on /nowpose/joint_status: on each change, and every second while there are any.</summary>
/// <remarks>Called by one thread at a time.</remarks>
sealed class JointStatusTopic(MessageHub hub, IControlClock clock, TimeProvider time) : IDisposable
{
    static readonly TimeSpan Interval = TimeSpan.FromSeconds(1);

    const int MaxReasonLength = 200;

    // Limit of all reasons together. With the names, the message stays below the 64 KiB that clients read.
    const int MaxReasonsLength = 16 * 1024;

    // Bridges to other gateways search for this text.
    const string Uncertain = EventTexts.UncertainRest + ": ";

    readonly HubSource _source = hub.OpenSource();
    List<(string Name, JointDataState State, string Reason)> _sent;
    long _sentAt;

    public void Publish(IReadOnlyList<JointStatus> joints)
    {
        // If two sources have a joint, the better state applies: the other's samples are refused.
        // A joint without any source is left out: headsets notice it themselves, and another gateway behind a bridge may have its source.
        var troubled = joints.Where(row => row.Source != UnpublishedJoints.NoSource).GroupBy(joint => joint.Name, StringComparer.Ordinal).Select(rows => rows.MinBy(row => row.State))
            .Where(row => row.State != JointDataState.Live).ToList();
        // Recent failures have priority over those from long ago.
        if (troubled.Count > ProtocolLimits.Joints)
            troubled = [.. troubled.OrderBy(row => row.IsGood).ThenByDescending(row => row.Since).Take(ProtocolLimits.Joints).OrderBy(row => row.Name, StringComparer.Ordinal)];
        var content = troubled.ConvertAll(row => (row.Name, row.State, ReasonOf(row)));
        var isSame = _sent != null && content.SequenceEqual(_sent);
        if (isSame && (content.Count == 0 || time.GetElapsedTime(_sentAt) < Interval)) return;
        (_sent, _sentAt) = (content, time.GetTimestamp());
        var now = (Control: clock.Now, Utc: time.GetUtcNow());
        var longest = Math.Min(MaxReasonLength, MaxReasonsLength / Math.Max(1, troubled.Count));
        var values = troubled.ConvertAll(row => KeyValuePair.Create(row.Name, ValueOf(row, now.Control - (now.Utc - row.Since), longest)));
        // 0 for none, 1 if all of them are at rest, 2 otherwise.
        var level = troubled.Count == 0 ? 0 : troubled.TrueForAll(row => row.IsGood) ? 1 : 2;
        _source.PublishJointStatus(new DiagnosticsMessage(now.Control, "gateway", values, level, "joints"));
    }

    public void Dispose() => _source.Dispose();

    static string ReasonOf(JointStatus row) => row.Uncertainty.Length == 0 ? row.Reason : Uncertain + row.Uncertainty;

    static string ValueOf(JointStatus row, ControlTime since, int longest) => string.Create(
        CultureInfo.InvariantCulture, $"{row.Word} {since.SinceEpoch.TotalSeconds:0.000} {InputException.OneLine(ReasonOf(row), longest)}").TrimEnd();
}
