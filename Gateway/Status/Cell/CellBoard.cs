using Nowpose.Gateway.Hub;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;

namespace Nowpose.Gateway.Status.Cell;

/// <summary>The frames and signals of the cell with their states. Thread-safe.</summary>
/// <remarks>A frame or signal stays listed after its source has ended, so that the status shows that its data are missing.</remarks>
/// <param name="time">Time source for the age of poses.</param>
/// <param name="reports">The adapters' reports, which give the reasons for missing data.</param>
sealed class CellBoard(TimeProvider time, CellReports reports)
{
    /// <summary>The state "stationary" of a frame on /tf_static, and the state "live" of a tracked frame or a signal with current data.</summary>
    internal const string Stationary = "stationary", Live = "live";

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
                (frame.Stamp, frame.SeenAt) = (message[i].Stamp, time.GetTimestamp());
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
                (signal.Source, signal.IsEnded) = (source, false);
            }
    }

    /// <summary>Records that the source of these signals has ended.</summary>
    public void End(HubSource source, IReadOnlyCollection<string> signals)
    {
        lock (_gate)
            foreach (var name in signals)
                if (_signals.TryGetValue(name, out var signal)) signal.IsEnded = true;
    }

    /// <summary>Gets all frames in the order of their names.</summary>
    public IReadOnlyList<FrameView> Frames(ControlTime now)
    {
        lock (_gate)
        {
            var troubled = reports.Troubled(AdapterReport.FramePrefix).DistinctBy(one => one.Name).ToDictionary(one => one.Name, StringComparer.Ordinal);
            var published = _frames.Select(one => Explained(new FrameView(
                one.Key, one.Value.Parent, one.Value.Source.Title, one.Value.IsStationary ? Stationary : IsSilent(one.Value) ? "stale" : Live,
                one.Value.IsStationary ? null : Seconds(now - one.Value.Stamp)), troubled.GetValueOrDefault(one.Key)));
            var missing = troubled.Values.Where(one => !_frames.ContainsKey(one.Name)).Select(one => new FrameView(
                one.Name, null, one.Adapter, JointDataStates.Of(one.Report.State), null, one.Report.Reason));
            return [.. published.Concat(missing).OrderBy(frame => frame.Name, StringComparer.Ordinal)];
        }
    }

    /// <summary>Gets all signals in the order of their names.</summary>
    public IReadOnlyList<SignalView> Signals(ControlTime now)
    {
        lock (_gate)
        {
            var troubled = reports.Troubled(AdapterReport.SignalPrefix).DistinctBy(one => one.Name).ToDictionary(one => one.Name, StringComparer.Ordinal);
            var published = _signals.Select(one => Explained(new SignalView(
                one.Key, one.Value.Value, one.Value.Source.Title, one.Value.IsEnded ? "ended" : Live, Seconds(now - one.Value.Since)),
                troubled.GetValueOrDefault(one.Key)));
            var missing = troubled.Values.Where(one => !_signals.ContainsKey(one.Name)).Select(one => new SignalView(
                one.Name, null, one.Adapter, JointDataStates.Of(one.Report.State), null, one.Report.Reason));
            return [.. published.Concat(missing).OrderBy(signal => signal.Name, StringComparer.Ordinal)];
        }
    }

    // Adds the adapter's reason to a stale frame. If poses still arrive, they come from another source or are newer than the report.
    static FrameView Explained(FrameView frame, CellReport report) =>
        report == null || frame.State != "stale" ? frame : frame with { State = JointDataStates.Of(report.Report.State), Reason = report.Report.Reason };

    // Adds the adapter's reason to a signal. A signal does not become stale by itself, so only a report shows that its value is not current.
    // A report does not apply to a live signal if it comes from an adapter that is not the signal's source.
    static SignalView Explained(SignalView signal, CellReport report) => report == null || signal.Source != report.Adapter && signal.State == Live
        ? signal : signal with { State = JointDataStates.Of(report.Report.State), Reason = report.Report.Reason };

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
        public HubSource Source { get; set; }
        public bool IsStationary { get; set; }
        public string Parent { get; set; }
        public ControlTime Stamp { get; set; }
        public long SeenAt { get; set; }
    }

    sealed class Signal
    {
        public HubSource Source { get; set; }
        public bool IsEnded { get; set; }
        public double Value { get; set; }

        /// <summary>Stamp of the message with which the value changed.</summary>
        public ControlTime Since { get; set; }
    }
}
