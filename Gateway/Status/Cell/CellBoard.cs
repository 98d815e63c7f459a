using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Status.Joints;
using Nowpose.Protocol.Cell;
using Nowpose.Signals;

namespace Nowpose.Gateway.Status.Cell;

/// <summary>The frames and signals of the cell with their states. Thread-safe.</summary>
/// <remarks>
/// A frame or signal whose messages are dropped because of their content is refused: a tracked frame while no valid pose arrives, a stationary frame
/// or a signal until its next valid message, because these are sent only once. A signal is also refused while its newest stamp is in the future, because
/// headsets show its value only from then on. The gateway accepts no such stamp, but the control clock may be set back or replaced afterwards.
/// A frame or signal stays listed after its source has ended, so that the status shows that its data are missing. If the source ended normally, the frame
/// or signal is removed after <see cref="JointBoard.ForgottenAfter"/> without data.
/// </remarks>
/// <param name="time">Time source for the age of poses.</param>
/// <param name="reports">The adapters' reports, which give the reasons for missing data.</param>
/// <param name="rootOfLink">Returns the root link of the described robot to which a link belongs; null for a frame that is not a link.</param>
/// <param name="jointsOfLink">Returns the joints that decide whether the pose of a link is current.</param>
sealed class CellBoard(
    TimeProvider time, CellReports reports, Func<string, string> rootOfLink = null, Func<string, IReadOnlyList<string>> jointsOfLink = null)
{
    /// <summary>
    /// Maximum number of frames, and of signals, known only from refused messages. They are listed in addition to the maximum number of published ones.
    /// </summary>
    internal const int MaxRefused = 64;

    /// <summary>Time for which a tracked frame stays refused after its last invalid pose.</summary>
    internal static readonly TimeSpan RefusedFor = TimeSpan.FromSeconds(10);

    /// <summary>Time without a pose with another time stamp after which a tracked frame is stale.</summary>
    static readonly TimeSpan MaxSilence = TimeSpan.FromSeconds(1);

    /// <summary>Assumed error bound of the control clock for stamps in the future. It is larger than that of a synchronised clock, with which stamps are accepted.</summary>
    static readonly TimeSpan ClockErrorBound = TimeSpan.FromSeconds(1);

    static readonly string RefusedState = JointDataStates.Of(JointDataState.Refused);

    readonly object _gate = new();
    readonly SortedDictionary<string, FrameEntry> _frames = new(StringComparer.Ordinal);
    readonly SortedDictionary<string, SignalEntry> _signals = new(StringComparer.Ordinal);

    /// <summary>Records a publication on /tf or /tf_static.</summary>
    /// <param name="arrival">Control time of the arrival; null if unknown.</param>
    public void Add(HubSource source, TransformsMessage message, bool isStationary, ControlTime? arrival = null)
    {
        lock (_gate)
            for (var i = 0; i < message.Count; i++)
            {
                if (!TryGet(_frames, message[i].Child, ProtocolLimits.Frames, out var frame)) continue;
                frame.ArrivedAt = time.GetTimestamp();
                if (!frame.HasAny || isStationary || message[i].Stamp != frame.Stamp || frame.Source != source) (frame.Stamp, frame.SeenAt) = (message[i].Stamp, frame.ArrivedAt);
                frame.IsOld = !isStationary && arrival - message[i].Stamp > JointSamples.MaxAge;
                (frame.Source, frame.IsStationary, frame.Parent) = (source, isStationary, message[i].Parent);
                (frame.HasLeft, frame.IsEnded, frame.HasAny) = (false, false, true);
                frame.Refusal = null;
            }
    }

    /// <summary>Records a publication on /signals.</summary>
    public void Add(HubSource source, SignalsMessage message)
    {
        lock (_gate)
            for (var i = 0; i < message.Count; i++)
            {
                if (!TryGet(_signals, message[i].Name, ProtocolLimits.Signals, out var signal)) continue;
                if (signal.IsEnded || !LateValues.IsOvertaken(message.Stamp, signal.Newest)) Update(signal, message[i].Value, message.Stamp);
                (signal.Source, signal.IsEnded, signal.HasLeft, signal.HasAny) = (source, false, false, true);
                signal.Refusal = null;
            }
    }

    static void Update(SignalEntry signal, double value, ControlTime stamp)
    {
        if (signal.Value != value) (signal.Value, signal.Since) = (value, stamp);
        signal.Newest = stamp;
    }

    /// <summary>
    /// Records that a frame or signal was dropped because of its content. Has no effect on one that is known from another source, except for a stationary
    /// frame whose source has ended.
    /// </summary>
    /// <param name="topic">Topic of the message.</param>
    public void Refuse(HubSource source, string topic, LeftOut part)
    {
        if (part.Name.Length == 0) return;
        var refusal = new DroppedMessage(part.Fault, RequestMessages.Dropped(source.Title, part.Fault, part.Reason), time.GetTimestamp(), time.GetUtcNow());
        lock (_gate)
        {
            if (topic == RosTopics.Signals) Refuse(_signals, source, part.Name, refusal);
            else if (Refuse(_frames, source, part.Name, refusal) is { HasAny: false } frame) frame.IsStationary = topic == RosTopics.TfStatic;
        }
    }

    /// <summary>
    /// Gets the signals that an adapter reports with a fault, whose adapter is silent, or whose newest value is refused, with a short reason for headsets.
    /// </summary>
    public IReadOnlyList<CellReport> FaultySignals(ControlTime now)
    {
        lock (_gate)
            return
            [
                .. SignalFaults(),
                .. from signal in _signals
                   where !signal.Value.IsEnded
                   let refusal = RefusalOf(signal.Value, now)
                   where refusal != null
                   select new CellReport(
                       signal.Key, signal.Value.Source.Title, new AdapterReport(JointDataState.Refused, refusal.Since, refusal.Fault)),
            ];
    }

    /// <summary>Records that the source of these signals has ended.</summary>
    public void End(HubSource source, IReadOnlyCollection<string> signals)
    {
        lock (_gate)
            foreach (var name in signals)
                if (_signals.TryGetValue(name, out var signal)) (signal.IsEnded, signal.EndedAt, signal.EndedUtc) = (true, time.GetTimestamp(), time.GetUtcNow());
    }

    /// <summary>Records that a tracked frame no longer has a source.</summary>
    public void EndFrame(string name)
    {
        lock (_gate)
            if (_frames.TryGetValue(name, out var frame)) frame.IsEnded = true;
    }

    /// <summary>Removes a frame that the gateway no longer publishes, because another frame has replaced it.</summary>
    public void RemoveFrame(string name)
    {
        lock (_gate) _frames.Remove(name);
    }

    /// <summary>Records that a source ended normally.</summary>
    /// <param name="topic">The topic on which the source ended; null for all.</param>
    public void Leave(HubSource source, string topic = null)
    {
        bool IsOn(string of) => topic == null || topic == of;
        lock (_gate)
        {
            foreach (var frame in _frames.Values)
                if (frame.Source == source && IsOn(frame.IsStationary ? RosTopics.TfStatic : RosTopics.Tf)) frame.HasLeft = true;
            foreach (var signal in _signals.Values)
                if (signal.Source == source && IsOn(RosTopics.Signals)) signal.HasLeft = true;
        }
    }

    /// <summary>Gets all frames in the order of their names.</summary>
    /// <param name="joints">The latest states of the joint board; null to assume that all joints are current.</param>
    public IReadOnlyList<FrameView> Frames(ControlTime now, IReadOnlyList<JointSnapshot> joints = null)
    {
        var current = joints?.Where(row => row.IsGood).Select(row => row.Name).ToHashSet(StringComparer.Ordinal);
        bool IsLinkCurrent(string link) => current == null || jointsOfLink == null || jointsOfLink(link).All(current.Contains);
        lock (_gate)
        {
            var ancestors = new FrameAncestors(_frames, IsCurrent, rootOfLink, IsLinkCurrent);
            Forget(_frames, frame => frame.HasAny ? frame.HasLeft && IsSilent(frame) && IsOver(frame.SeenAt) : !IsRefused(frame));
            // An adapter can report rest although the gateway has not received the newest pose. Then no pose of the frame at rest is known.
            var unknown = reports.AtRest(AdapterReport.FramePrefix).Where(one => !_frames.TryGetValue(one.Name, out var frame) || frame.IsEnded)
                .Select(one => one with { Report = new AdapterReport(JointDataState.Missing, one.Report.Since, CellReasons.NoPoseAtRest) });
            var troubled = reports.Troubled(AdapterReport.FramePrefix).Concat(unknown).DistinctBy(one => one.Name).ToDictionary(one => one.Name, StringComparer.Ordinal);
            var published = _frames.Select(one => Explained(ViewOf(one.Key, one.Value, now, ancestors), troubled.GetValueOrDefault(one.Key)));
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
            Forget(_signals, signal => signal.HasAny ? signal is { HasLeft: true, IsEnded: true } && IsOver(signal.EndedAt) : IsOver(signal.Refusal.At));
            var troubled = SignalFaults().ToDictionary(one => one.Name, StringComparer.Ordinal);
            var published = _signals.Select(one => Explained(ViewOf(one.Key, one.Value, now), troubled.GetValueOrDefault(one.Key)));
            var missing = troubled.Values.Where(one => !_signals.ContainsKey(one.Name)).Select(one => new SignalView(
                one.Name, null, one.Adapter, JointDataStates.Of(one.Report.State), null, one.Report.Reason)
            {
                Since = one.Report.Since,
            });
            return [.. published.Concat(missing).OrderBy(signal => signal.Name, StringComparer.Ordinal)];
        }
    }

    FrameView ViewOf(string name, FrameEntry frame, ControlTime now, FrameAncestors ancestors)
    {
        var (state, reason, cause) = (frame.IsStationary ? CellStates.Stationary : CellStates.Live, (string)null, (string)null);
        var utcNow = time.GetUtcNow();
        var since = utcNow;
        if (IsRefused(frame)) (state, reason, since) = (RefusedState, frame.Refusal.Reason, frame.Refusal.Since);
        else if (IsSilent(frame))
        {
            (state, reason) = (CellStates.Stale, time.GetElapsedTime(frame.ArrivedAt) > MaxSilence ? CellReasons.PosesStopped : CellReasons.StampsStopped);
            since = utcNow - time.GetElapsedTime(frame.SeenAt);
        }
        else if (frame.IsOld) (state, reason) = (CellStates.Stale, CellReasons.StampsOld);
        else if (ancestors.FaultOf(name, frame) is { } fault) (state, reason, cause) = fault;
        since = frame.Enter(state, since, time.GetTimestamp());
        return new FrameView(
            name, frame.Parent, frame.Source.Title, state, frame.IsStationary || !frame.HasAny ? null : Seconds(now - frame.Stamp), reason)
        {
            Since = reason == null ? null : since,
            KnownFor = time.GetElapsedTime(frame.EnteredAt),
            Cause = cause,
        };
    }

    SignalView ViewOf(string name, SignalEntry signal, ControlTime now)
    {
        var (state, reason, since) = (CellStates.Live, (string)null, (DateTimeOffset?)null);
        if (signal.IsEnded) (state, reason, since) = (CellStates.Ended, EventTexts.SourceEnded(signal.Source.Title), signal.EndedUtc);
        else if (RefusalOf(signal, now) is { } refusal) (state, reason, since) = (RefusedState, refusal.Reason, refusal.Since);
        return new SignalView(name, signal.Value, signal.Source.Title, state, signal.HasAny ? Seconds(now - signal.Since) : null, reason) { Since = since };
    }

    // Returns null for a signal whose newest message was valid and still is.
    DroppedMessage RefusalOf(SignalEntry signal, ControlTime now)
    {
        signal.SetAhead(signal.HasAny && StampRule.IsInFuture(signal.Newest, now, ClockErrorBound) ? signal.Newest - now : null, time);
        return signal.Refusal ?? signal.Ahead;
    }

    bool IsCurrent(FrameEntry frame) => !frame.IsEnded && !IsRefused(frame) && !IsSilent(frame) && !frame.IsOld;

    // Adds the adapter's reason to a stale frame. If poses still arrive, they come from another source or are newer than the report.
    FrameView Explained(FrameView frame, CellReport report)
    {
        if (frame.State != CellStates.Stale) return frame;
        if (report != null) return frame with { State = JointDataStates.Of(report.Report.State), Reason = report.Report.Reason, Since = report.Report.Since };
        return reports.RestOf(AdapterReport.FramePrefix + frame.Name, frame.Source) is { } rest ? frame with { Reason = rest.Reason, IsAtRest = true } : frame;
    }

    // Adds the adapter's reason to a signal. A signal does not become stale by itself, so only a report shows that its value is not current.
    static SignalView Explained(SignalView signal, CellReport report) => report == null
        ? signal : signal with { State = JointDataStates.Of(report.Report.State), Reason = report.Report.Reason, Since = report.Report.Since };

    // Gets the adapters' reports about signals that are not current, and the signals of silent adapters. Both apply to a live signal only if the adapter is
    // the signal's source.
    IEnumerable<CellReport> SignalFaults() => reports.Troubled(AdapterReport.SignalPrefix)
        .Where(one => !_signals.TryGetValue(one.Name, out var signal) || signal.IsEnded || signal.Refusal != null || signal.Source.Title == one.Adapter)
        .Concat(reports.Unconfirmed(AdapterReport.SignalPrefix).Where(IsCurrent)).DistinctBy(one => one.Name);

    bool IsCurrent(CellReport one) =>
        _signals.TryGetValue(one.Name, out var signal) && signal is { IsEnded: false, Refusal: null } && signal.Source.Title == one.Adapter;

    bool IsOver(long last) => time.GetElapsedTime(last) > JointBoard.ForgottenAfter;

    static void Forget<T>(SortedDictionary<string, T> all, Predicate<T> isOver)
    {
        foreach (var (name, _) in all.Where(one => isOver(one.Value)).ToArray()) all.Remove(name);
    }

    // A tracked frame is refused only if no valid pose arrives, because its next pose follows soon. The refusal lasts for some time, so that a slow source
    // does not change the state with each message.
    bool IsRefused(FrameEntry frame) => frame.Refusal is { } refusal
        && (frame.IsStationary ? frame.HasAny || !IsOver(refusal.At) : (!frame.HasAny || IsSilent(frame)) && time.GetElapsedTime(refusal.At) < RefusedFor);

    bool IsSilent(FrameEntry frame) => !frame.IsStationary && time.GetElapsedTime(frame.SeenAt) > MaxSilence;

    static double Seconds(TimeSpan age) => Math.Round(age.TotalSeconds, 3);

    // Finds or adds the entry of a published frame or signal. At the maximum number of published ones, a new entry replaces one without a source.
    static bool TryGet<T>(SortedDictionary<string, T> all, string name, int limit, out T found)
        where T : CellEntry, new()
    {
        if (all.TryGetValue(name, out found) && found.HasAny) return true;
        if (all.Values.Count(one => one.HasAny) >= limit)
        {
            if (all.FirstOrDefault(one => one.Value is { HasAny: true, IsEnded: true }).Key is not { } ended) return false;
            all.Remove(ended);
        }

        if (found == null) all.Add(name, found = new T());
        return true;
    }

    // Finds or adds the entry of a refused frame or signal, and keeps the start of a refusal that continues.
    static T Refuse<T>(SortedDictionary<string, T> all, HubSource source, string name, DroppedMessage refusal)
        where T : CellEntry, new()
    {
        if (!all.TryGetValue(name, out var entry))
        {
            if (all.Values.Count(one => !one.HasAny) >= MaxRefused) return null;
            all.Add(name, entry = new T());
        }

        // A stationary frame keeps its place after the end of its source. An invalid pose of another source may then have been its new place.
        var isWithoutSource = entry is { HasAny: true, IsEnded: false } && (entry.HasLeft || entry.Source.IsEnded);
        if (entry.HasAny && entry.Source != source && !isWithoutSource) return null;
        entry.Source = source;
        entry.Refusal = entry.Refusal == null ? refusal : refusal with { Since = entry.Refusal.Since };
        return entry;
    }
}
