using Nowpose.Gateway.Hub;
using Nowpose.Kinematics;

namespace Nowpose.Gateway.Status.Joints;

/// <summary>The state of each joint per source, from the adapters' reports and the received samples. Thread-safe; bounded.</summary>
/// <remarks>
/// A joint in an adapter's configuration stays listed until the adapter reports without this joint. Beyond <see cref="MaxSources"/>, the sources of
/// a joint that have been gone for the longest time are removed, so that an adapter that changes its name does not add sources without limit. The
/// joint stays listed with its other sources. Any other joint is removed when its source has ended normally and no sample has arrived for
/// <see cref="ForgottenAfter"/>. If its source has ended in another way, the joint stays listed as failed until samples arrive again. An arm joint
/// of a described robot that no source publishes is listed as missing as soon as a source publishes another arm joint.
/// </remarks>
/// <param name="time">Time source.</param>
/// <param name="robots">Returns the described robots with their namespaces; null if no robots are described.</param>
/// <param name="log">Called once, when an adapter uses a former key; null for no log.</param>
/// <param name="clockFault">Returns the fault of the control clock because of which no joint is current; null if there is none.</param>
sealed class JointBoard(
    TimeProvider time, Func<IReadOnlyList<(string Namespace, RobotModel Model)>> robots = null, Action<string> log = null,
    Func<string> clockFault = null)
{
    internal const int MaxJoints = 4 * ProtocolLimits.Joints;

    /// <summary>Maximum number of sources of one joint: the source that publishes the joint, and others that are refused or gone.</summary>
    internal const int MaxSources = 4;

    /// <summary>Time without a sample with a new stamp after which a joint is stale, unless its adapter reports another state.</summary>
    internal static readonly TimeSpan StaleAfter = TimeSpan.FromSeconds(1.8);

    internal static readonly TimeSpan ForgottenAfter = TimeSpan.FromMinutes(10);

    /// <summary>Maximum number of joints known only from refused samples.</summary>
    internal const int MaxRefusedJoints = 64;

    readonly Lock _lock = new();
    readonly Dictionary<string, Joint> _joints = [];
    readonly UnpublishedJoints _unpublished = new(time);
    bool _isFormerKeyLogged;
    DateTimeOffset? _clockFaultSince;

    /// <summary>Adds a published sample.</summary>
    /// <param name="source">The source; null for the gateway's own.</param>
    /// <param name="names">Joints of the sample.</param>
    /// <param name="age">Control time at the arrival of the sample minus its stamp.</param>
    /// <param name="robot">Namespace of the robot; empty if it has none.</param>
    public void Add(HubSource source, string[] names, ControlTime stamp, TimeSpan age, string robot = "")
    {
        lock (_lock)
            foreach (var name in names) Find(name)?.Samples.Add(source, stamp, age, robot);
    }

    /// <summary>Adds a sample that was refused because another source publishes one of its joints.</summary>
    public void Refuse(HubSource source, string name, HubSource owner)
    {
        lock (_lock)
            if (_joints.TryGetValue(name, out var joint))
                joint.Rows.Find(row => row.Source == source.Name)?.Refuse(JointReasons.Taken(owner.Title), JointFaultReasons.Taken);
    }

    /// <summary>
    /// Adds a sample that was dropped because of its content. All joints in the sample count as refused; if their names cannot be read, all joints that the
    /// source publishes.
    /// </summary>
    public void Refuse(HubSource source, string[] names, string reason, DropReason drop = DropReason.None)
    {
        var word = JointFaultReasons.Of(drop);
        lock (_lock)
        {
            foreach (var joint in _joints.Values)
                if (joint.IsPublishedBy(source) && (names.Length == 0 || names.Contains(joint.Name))) joint.OwnerRow().Refuse(reason, word);
            var places = MaxRefusedJoints - _joints.Values.Count(joint => joint.IsOnlyRefused);
            foreach (var name in names)
            {
                if (!_joints.TryGetValue(name, out var joint) && places-- > 0) joint = Find(name);
                if (joint != null && !joint.IsPublishedBy(source)) joint.RowOf(source.Name).Refuse(reason, word);
            }
        }
    }

    /// <summary>Adds the diagnostics of an adapter, which have a key for each configured joint.</summary>
    /// <param name="source">The adapter's connection; null if unknown.</param>
    /// <param name="sent">Stamp of the diagnostics; zero if unknown.</param>
    public void Report(string adapter, IReadOnlyCollection<KeyValuePair<string, string>> values, HubSource source = null, ControlTime sent = default)
    {
        var now = time.GetUtcNow();
        var reports = new Dictionary<string, AdapterReport>();
        var uncertainties = values.Select(pair => (Joint: AdapterReport.UncertainJoint(pair.Key), pair.Value)).Where(one => one.Joint != null)
            .Take(ProtocolLimits.Joints).DistinctBy(one => one.Joint).ToDictionary(one => one.Joint, one => AdapterReport.Sentence(one.Value));
        var words = values.Where(pair => pair.Key.StartsWith(AdapterReport.WordPrefix, StringComparison.Ordinal)).Take(ProtocolLimits.Joints)
            .DistinctBy(pair => pair.Key).ToDictionary(pair => pair.Key[AdapterReport.WordPrefix.Length..], pair => pair.Value);
        if (values.Any(pair => AdapterReport.IsFormerKey(pair.Key))) LogFormerKey(adapter);
        foreach (var (key, value) in values)
        {
            if (reports.Count >= ProtocolLimits.Joints) break;
            if (key.StartsWith(AdapterReport.JointPrefix, StringComparison.Ordinal) && AdapterReport.TryParse(value, sent, now, out var report))
            {
                var name = key[AdapterReport.JointPrefix.Length..];
                reports[name] = report with { Uncertainty = uncertainties.GetValueOrDefault(name, ""), Word = words.GetValueOrDefault(name) };
            }
        }

        lock (_lock)
        {
            foreach (var (name, joint) in _joints)
                if (!reports.ContainsKey(name) && joint.EndReports(adapter) && joint.Samples.Source == source) joint.Samples.Leave();
            foreach (var (name, report) in reports) Find(name)?.RowOf(adapter).Report(report);
        }
    }

    void LogFormerKey(string adapter)
    {
        lock (_lock)
        {
            if (_isFormerKeyLogged) return;
            _isFormerKeyLogged = true;
        }
        log?.Invoke(AdapterMessages.FormerKey(adapter, AdapterReport.FormerUncertainPrefix, AdapterReport.UncertainPrefix));
    }

    /// <summary>Records that a source ended normally.</summary>
    /// <param name="robot">Namespace of the robot for which it ended, empty for the robot without a namespace; null for all robots.</param>
    public void Leave(HubSource source, string robot = null)
    {
        lock (_lock)
            foreach (var joint in _joints.Values)
                if (joint.IsPublishedBy(source) && (robot == null || joint.Samples.Robot == robot)) joint.Samples.Leave();
    }

    /// <summary>
    /// Gets the namespace of the robot of a joint with samples, by the joint's cell-wide name; null without samples, and if the source has ended
    /// normally.
    /// </summary>
    public string RobotOf(string name)
    {
        lock (_lock) return _joints.TryGetValue(name, out var joint) && !joint.Samples.HasLeft ? joint.Samples.Robot : null;
    }

    /// <summary>Gets the state of all joints, sorted by name and source.</summary>
    public IReadOnlyList<JointSnapshot> Read()
    {
        var expected = robots?.Invoke() ?? [];
        var fault = clockFault?.Invoke();
        lock (_lock)
        {
            Forget();
            _clockFaultSince = fault == null ? null : _clockFaultSince ?? time.GetUtcNow();
            return
            [
                .. _joints.Values.SelectMany(joint => joint.Judge()).Concat(_unpublished.Judge(expected, _joints.ContainsKey))
                    .Select(row => WithClockFault(row, fault)).OrderBy(row => row.Name, StringComparer.Ordinal)
                    .ThenBy(row => row.Source, StringComparer.Ordinal),
            ];
        }
    }

    // A joint that is in fault or missing has a reason of its own.
    JointSnapshot WithClockFault(in JointSnapshot row, string fault) =>
        fault == null || row.State is JointDataState.Fault or JointDataState.Missing ? row : row with
        {
            State = JointDataState.Fault,
            Since = _clockFaultSince.Value,
            Reason = fault,
            ReasonWord = JointFaultReasons.ClockRate,
            Uncertainty = "",
        };

    Joint Find(string name)
    {
        if (_joints.TryGetValue(name, out var known)) return known;
        if (_joints.Count >= MaxJoints) DropOldest();
        if (_joints.Count >= MaxJoints) return null;
        return _joints[name] = new Joint(name, time);
    }

    // Removes the joint that has been silent for the longest time, and prefers joints whose source ended normally. Does not remove configured or
    // live joints, so that a source with many names cannot displace them.
    void DropOldest()
    {
        var oldest = _joints.Values.Where(joint => !joint.IsConfigured && !joint.Samples.IsFlowing)
            .MaxBy(joint => (joint.Samples.HasLeft, joint.Samples.Silence));
        if (oldest != null) _joints.Remove(oldest.Name);
    }

    void Forget()
    {
        foreach (var (name, joint) in _joints)
            if (!joint.IsConfigured && !joint.IsRefused && IsOver(joint.Samples)) _joints.Remove(name);
    }

    static bool IsOver(JointSamples samples) => !samples.HasAny || samples.HasLeft && samples.Silence > ForgottenAfter;

    sealed class Joint(string name, TimeProvider time)
    {
        public string Name => name;
        public JointSamples Samples { get; } = new(time);
        public List<JointRow> Rows { get; private set; } = [];
        public bool IsConfigured => Rows.Exists(row => row.IsConfigured);
        public bool IsRefused => Rows.Exists(row => row.IsRefused);
        public bool IsOnlyRefused => !IsConfigured && !Samples.HasAny;

        public bool IsPublishedBy(HubSource source) => Samples.HasAny && Samples.Source == source;

        /// <summary>Records that an adapter no longer reports the joint.</summary>
        /// <returns>Whether the adapter had been reporting the joint.</returns>
        public bool EndReports(string adapter) => Rows.Find(row => row.Source == adapter)?.EndReports() == true;

        public JointRow RowOf(string source)
        {
            var row = Rows.Find(row => row.Source == source);
            if (row == null) Rows.Add(row = new JointRow(name, source, time));
            return row;
        }

        public IEnumerable<JointSnapshot> Judge()
        {
            var owner = Samples.HasAny ? OwnerRow() : null;
            Rows.RemoveAll(row => !row.IsConfigured && !row.IsRefused && row != owner);
            // Keeps the source that publishes the joint, then those that were present last. The sort is stable, so a new source does not replace one
            // that is still present.
            if (Rows.Count > MaxSources)
                Rows = [.. Rows.OrderByDescending(row => row == owner).ThenByDescending(row => row.LastPresent).Take(MaxSources)];
            return Rows.Select(row => row.Judge(row == owner ? Samples : null) with { Robot = Samples.Robot });
        }

        // Gets the row of the source that publishes the joint. An adapter that has just reconnected has not sent its name yet. If one adapter has
        // the joint in its configuration, the samples are assigned to that adapter.
        public JointRow OwnerRow()
        {
            var configured = Rows.FindAll(row => row.IsConfigured);
            var isUnnamed = Samples.Source?.Name is null or HubSource.Unnamed;
            return isUnnamed && configured.Count == 1 ? configured[0] : RowOf(Samples.Source?.Name ?? HubSource.Own);
        }
    }
}
