using System.Globalization;
using System.Text.RegularExpressions;
using Nowpose.Gateway.Status;
using Nowpose.Gateway.Status.Prometheus;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Gateway.Disturbances;

/// <summary>Checks that the status, the metrics and the lists for headsets show the state that follows from what was published.</summary>
sealed partial class StatusLaws(DisturbedGateway gateway, Ledger ledger, List<string> faults)
{
    /// <summary>Time without a new stamp after which a frame is stale, s.</summary>
    const double FrameSilence = 1;

    /// <summary>Interval of the gateway's lists for headsets, with a reserve, s.</summary>
    const double ListInterval = 0.25;

    /// <summary>Tolerance for the rounding of times, s.</summary>
    const double Rounding = 1e-3;

    readonly Dictionary<string, double> _counters = [];
    readonly Dictionary<string, double> _otherSince = [];

    double Now => gateway.Loop.Seconds;

    public void Check()
    {
        var state = gateway.Status.Read();
        foreach (var (topic, count) in state.Messages)
            if (ledger.Messages.GetValueOrDefault(topic) is var published && published != count) Fail($"{topic} has {count} of {published} messages");
        foreach (var ((kind, name), newest) in ledger.Newest)
        {
            if (kind.EndsWith(RosTopics.JointStates, StringComparison.Ordinal)) CheckJoint(state, kind, newest);
            else if (kind == RosTopics.Tf) CheckFrame(state, newest);
            else if (kind == RosTopics.Signals) CheckSignal(state, newest);
        }

        CheckCounters(Metrics.Of(state, gateway.Status.Forwarding));
    }

    void CheckJoint(StatusSnapshot state, string kind, Published newest)
    {
        var name = RobotTopic.Qualified(RobotTopic.Parse(kind).Robot, newest.Name);
        var silence = Now - ledger.Changed[(kind, newest.Name)];
        if (Math.Abs(silence - Ledger.JointSilence) < Rounding) return;
        var isLive = silence < Ledger.JointSilence && !newest.IsOld;
        var states = state.Joints.Where(joint => joint.Name == name).Select(joint => joint.State).ToArray();
        if (states.Contains("live") != isLive) Fail($"joint {name} is {string.Join(',', states)}, silent for {silence:0.000} s");
        var isSettled = isLive ? Now - ledger.LiveSince[(kind, newest.Name)] > ListInterval
            : silence > Ledger.JointSilence + ListInterval || (newest.IsOld && Now - newest.At > ListInterval);
        // The list has a maximum length.
        if (!isSettled || ledger.JointStatus.Values.Count == ProtocolLimits.Joints) return;
        if (IsListed(ledger.JointStatus, name) == isLive) Fail($"headsets have another state of joint {name}");
    }

    void CheckFrame(StatusSnapshot state, Published newest)
    {
        var silence = Now - ledger.Changed[(RosTopics.Tf, newest.Name)];
        var isOwned = ledger.OwnerOf(RosTopics.Tf, newest.Name) != null;
        var isMoving = newest.Topic == RosTopics.Tf;
        var frame = state.Frames.SingleOrDefault(one => one.Name == newest.Name);
        // In a full cell, another frame may replace one that has ended.
        var mayBeReplaced = !isOwned && state.Frames.Count >= ProtocolLimits.Frames;
        if (Math.Abs(silence - FrameSilence) < Rounding || (frame == null && mayBeReplaced)) return;
        var isFresh = !isMoving || (silence < FrameSilence && !newest.IsOld);
        var isShown = frame?.State == (isMoving ? "live" : "stationary");
        // Its own data or a parent may be refused.
        var mayBeOther = !isOwned || newest.Parent != "world" || frame?.State == "refused";
        if (isShown ? isFresh : !isFresh || mayBeOther) return;
        Fail($"frame {newest.Name} on {newest.Topic} is {frame?.State}, silent for {silence:0.000} s");
    }

    void CheckSignal(StatusSnapshot state, Published newest)
    {
        var isOwned = ledger.OwnerOf(RosTopics.Signals, newest.Name) != null;
        var signal = state.Signals.SingleOrDefault(one => one.Name == newest.Name);
        if (signal == null && !isOwned && state.Signals.Count >= ProtocolLimits.Signals) return;
        if (signal == null || isOwned == (signal.State == "ended")) Fail($"signal {newest.Name} is {signal?.State}, has a source: {isOwned}");
        var isListed = IsListed(ledger.SignalStatus, newest.Name);
        if (!isOwned && !isListed && ledger.SignalStatus.Values.Count < ProtocolLimits.Signals)
            Fail($"the status for headsets does not contain that signal {newest.Name} has ended");
        if (signal?.State != "live" || !isListed) _otherSince.Remove(newest.Name);
        else if (!_otherSince.TryAdd(newest.Name, Now) && Now - Math.Max(newest.At, _otherSince[newest.Name]) > ListInterval)
            Fail($"the status for headsets does not contain that signal {newest.Name} is live");
    }

    static bool IsListed(DiagnosticsMessage list, string name) => list.Values.Any(pair => pair.Key == name);

    void CheckCounters(string metrics)
    {
        foreach (Match match in Counter().Matches(metrics))
        {
            var (name, value) = (match.Groups[1].Value, double.Parse(match.Groups[2].Value, CultureInfo.InvariantCulture));
            if (value < _counters.GetValueOrDefault(name)) Fail($"{name} fell to {value}");
            _counters[name] = value;
        }
    }

    void Fail(string why) => faults.Add($"{Now:0.000} s: {why}");

    [GeneratedRegex(@"^(nowpose_\w+_total\S*) (\S+)$", RegexOptions.Multiline)]
    private static partial Regex Counter();
}
