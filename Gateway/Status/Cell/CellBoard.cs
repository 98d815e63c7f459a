using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Status.Joints;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;

namespace Nowpose.Gateway.Status.Cell;

/// <summary>The frames and signals of the cell with their states. Thread-safe.</summary>
/// <remarks>
/// A frame or signal stays listed after its source has ended, so that the status shows that its data are missing. If the source ended normally, the frame
/// or signal is removed after <see cref="JointBoard.ForgottenAfter"/> without data.
/// </remarks>
/// <param name="time">Time source for the age of poses.</param>
/// <param name="reports">The adapters' reports, which give the reasons for missing data.</param>
/// <param name="isLink">Returns whether a frame is a link of a described robot; null if no robot is described.</param>
sealed class CellBoard(TimeProvider time, CellReports reports, Predicate<string> isLink = null)
{
    /// <summary>Time without a pose after which a tracked frame is stale.</summary>
    static readonly TimeSpan MaxSilence = TimeSpan.FromSeconds(1);

    readonly object _gate = new();
    readonly SortedDictionary<string, Frame> _frames = new(StringComparer.Ordinal);
    readonly SortedDictionary<string, Signal> _signals = new(StringComparer.Ordinal);

    /// <summary>Records a publication on /tf or /tf_static.</summary>
    public void Add(HubSource source, TransformsMessage message, bool isStationary)
    {
        lock (_gate)
            for (var i = 0; i < message.Count; i++)
            {
                if (!TryGet(_frames, message[i].Child, ProtocolLimits.Frames, IsSilent, out var frame)) continue;
                (frame.Source, frame.IsStationary, frame.Parent) = (source, isStationary, message[i].Parent);
                (frame.Stamp, frame.SeenAt, frame.HasLeft) = (message[i].Stamp, time.GetTimestamp(), false);
            }
    }

    /// <summary>Records a publication on /signals.</summary>
    public void Add(HubSource source, SignalsMessage message)
    {
        lock (_gate)
            for (var i = 0; i < message.Count; i++)
            {
                if (!TryGet(_signals, message[i].Name, ProtocolLimits.Signals, signal => signal.IsEnded, out var signal)) continue;
                if (signal.Value != message[i].Value || signal.Source == null) (signal.Value, signal.Since) = (message[i].Value, message.Stamp);
                (signal.Source, signal.IsEnded, signal.HasLeft) = (source, false, false);
            }
    }

    /// <summary>Records that the source of these signals has ended.</summary>
    public void End(HubSource source, IReadOnlyCollection<string> signals)
    {
        lock (_gate)
            foreach (var name in signals)
                if (_signals.TryGetValue(name, out var signal)) (signal.IsEnded, signal.EndedAt, signal.EndedUtc) = (true, time.GetTimestamp(), time.GetUtcNow());
    }

    /// <summary>Records that a source ended normally.</summary>
    public void Leave(HubSource source)
    {
        lock (_gate)
        {
            foreach (var frame in _frames.Values.Where(frame => frame.Source == source)) frame.HasLeft = true;
            foreach (var signal in _signals.Values.Where(signal => signal.Source == source)) signal.HasLeft = true;
        }
    }

    /// <summary>Gets all frames in the order of their names.</summary>
    public IReadOnlyList<FrameView> Frames(ControlTime now)
    {
        lock (_gate)
        {
            foreach (var (name, _) in _frames.Where(one => one.Value.HasLeft && IsSilent(one.Value) && IsOver(one.Value.SeenAt)).ToArray()) _frames.Remove(name);
            var troubled = reports.Troubled(AdapterReport.FramePrefix).DistinctBy(one => one.Name).ToDictionary(one => one.Name, StringComparer.Ordinal);
            var published = _frames.Select(one => Explained(ViewOf(one.Key, one.Value, now), troubled.GetValueOrDefault(one.Key)));
            var missing = troubled.Values.Where(one => !_frames.ContainsKey(one.Name)).Select(one => new FrameView(
                one.Name, null, one.Adapter, JointDataStates.Of(one.Report.State), null, one.Report.Reason)
            {
                Since = one.Report.Since,
            });
            return [.. published.Concat(missing).OrderBy(frame => frame.Name, StringComparer.Ordinal)];
        }
    }

    /// <summary>Gets all signals in the order of their names.</summary>
    public IReadOnlyList<SignalView> Signals(ControlTime now)
    {
        lock (_gate)
        {
            foreach (var (name, _) in _signals.Where(one => one.Value is { HasLeft: true, IsEnded: true } && IsOver(one.Value.EndedAt)).ToArray()) _signals.Remove(name);
            var troubled = reports.Troubled(AdapterReport.SignalPrefix).DistinctBy(one => one.Name).ToDictionary(one => one.Name, StringComparer.Ordinal);
            var published = _signals.Select(one => Explained(ViewOf(one.Key, one.Value, now), troubled.GetValueOrDefault(one.Key)));
            var missing = troubled.Values.Where(one => !_signals.ContainsKey(one.Name)).Select(one => new SignalView(
                one.Name, null, one.Adapter, JointDataStates.Of(one.Report.State), null, one.Report.Reason)
            {
                Since = one.Report.Since,
            });
            return [.. published.Concat(missing).OrderBy(signal => signal.Name, StringComparer.Ordinal)];
        }
    }

    FrameView ViewOf(string name, Frame frame, ControlTime now)
    {
        var (state, reason) = (frame.IsStationary ? CellStates.Stationary : CellStates.Live, (string)null);
        var utcNow = time.GetUtcNow();
        var since = utcNow;
        if (IsSilent(frame)) (state, reason, since) = (CellStates.Stale, CellReasons.PosesStopped, utcNow - time.GetElapsedTime(frame.SeenAt));
        else if (OrphanReason(name, frame) is { } why) (state, reason) = (CellStates.Orphan, why);
        since = frame.Enter(state, since);
        return new FrameView(name, frame.Parent, frame.Source.Title, state, frame.IsStationary ? null : Seconds(now - frame.Stamp), reason)
        {
            Since = reason == null ? null : since,
        };
    }

    static SignalView ViewOf(string name, Signal signal, ControlTime now) =>
        new(
            name, signal.Value, signal.Source.Title, signal.IsEnded ? CellStates.Ended : CellStates.Live, Seconds(now - signal.Since),
            signal.IsEnded ? EventTexts.SourceEnded(signal.Source.Title) : null)
        {
            Since = signal.IsEnded ? signal.EndedUtc : null,
        };

    // Returns null if the parents of the frame reach the world or a robot. The number of steps is limited, because a frame whose source has ended stays
    // listed, so that the listed parents may form a cycle.
    string OrphanReason(string name, Frame frame)
    {
        var (child, parent) = (name, frame.Parent);
        for (var steps = 0; steps <= _frames.Count; steps++)
        {
            if (parent == FrameParents.World || isLink?.Invoke(parent) == true) return null;
            if (!_frames.TryGetValue(parent, out var above)) break;
            (child, parent) = (parent, above.Parent);
        }

        return child == name ? CellReasons.ParentMissing(parent) : CellReasons.ParentMissingAbove(child, parent);
    }

    // Adds the adapter's reason to a stale frame. If poses still arrive, they come from another source or are newer than the report.
    FrameView Explained(FrameView frame, CellReport report)
    {
        if (frame.State != CellStates.Stale) return frame;
        if (report != null) return frame with { State = JointDataStates.Of(report.Report.State), Reason = report.Report.Reason, Since = report.Report.Since };
        return reports.RestOf(AdapterReport.FramePrefix + frame.Name, frame.Source) is { } rest ? frame with { Reason = rest.Reason, IsAtRest = true } : frame;
    }

    // Adds the adapter's reason to a signal. A signal does not become stale by itself, so only a report shows that its value is not current.
    // A report does not apply to a live signal if it comes from an adapter that is not the signal's source.
    static SignalView Explained(SignalView signal, CellReport report) => report == null || signal.Source != report.Adapter && signal.State == CellStates.Live
        ? signal : signal with { State = JointDataStates.Of(report.Report.State), Reason = report.Report.Reason, Since = report.Report.Since };

    bool IsOver(long last) => time.GetElapsedTime(last) > JointBoard.ForgottenAfter;

    bool IsSilent(Frame frame) => !frame.IsStationary && time.GetElapsedTime(frame.SeenAt) > MaxSilence;

    static double Seconds(TimeSpan age) => Math.Round(age.TotalSeconds, 3);

    // Finds or adds an entry. At the limit, a new entry replaces one without a source.
    static bool TryGet<T>(SortedDictionary<string, T> all, string name, int limit, Predicate<T> isEnded, out T found)
        where T : new()
    {
        if (all.TryGetValue(name, out found)) return true;
        if (all.Count >= limit && all.FirstOrDefault(one => isEnded(one.Value)).Key is { } ended) all.Remove(ended);
        if (all.Count >= limit) return false;
        all.Add(name, found = new T());
        return true;
    }

    sealed class Frame
    {
        string _state;
        DateTimeOffset _since;

        public HubSource Source { get; set; }
        public bool IsStationary { get; set; }
        public string Parent { get; set; }
        public ControlTime Stamp { get; set; }
        public long SeenAt { get; set; }

        /// <summary>Whether the source of the newest pose has ended normally.</summary>
        public bool HasLeft { get; set; }

        /// <summary>Returns the start of the present state.</summary>
        /// <param name="since">Start of the state if it is new.</param>
        public DateTimeOffset Enter(string state, DateTimeOffset since)
        {
            if (_state != state) (_state, _since) = (state, since);
            return _since;
        }
    }

    sealed class Signal
    {
        public HubSource Source { get; set; }
        public bool IsEnded { get; set; }
        public long EndedAt { get; set; }
        public DateTimeOffset EndedUtc { get; set; }

        /// <summary>Whether the source has ended normally.</summary>
        public bool HasLeft { get; set; }

        public double Value { get; set; }

        /// <summary>Stamp of the message with which the value changed.</summary>
        public ControlTime Since { get; set; }
    }
}
