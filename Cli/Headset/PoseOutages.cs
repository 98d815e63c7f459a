namespace Nowpose.Cli.Headset;

/// <summary>Reports when an outage of the pose begins, changes and ends, and collects the outages for the result.</summary>
/// <param name="say">Receives one line of text.</param>
sealed class PoseOutages(Action<string> say)
{
    /// <summary>
    /// Minimum duration of an outage. The value for the start of the run is larger, because the connections are established then.
    /// </summary>
    internal static readonly TimeSpan MinLength = TimeSpan.FromSeconds(0.5), MinLengthAtStart = TimeSpan.FromSeconds(3);

    /// <summary>Maximum number of finished outages in the result. Of more outages, the result has the longest ones.</summary>
    internal const int MaxCount = 100;

    static readonly TimeSpan Interval = TimeSpan.FromSeconds(0.25);

    /// <summary>Maximum number of reasons for one outage in the result.</summary>
    internal const int MaxReasons = 5;

    readonly List<HeadsetResult.OutageResult> _outages = [];
    // Reasons for the current outage. The first one is often the cause of the others.
    readonly List<string> _reasons = [];
    readonly SortedSet<string> _joints = new(StringComparer.Ordinal);
    (string Pose, string Reason)? _reported;
    TimeSpan? _since = TimeSpan.Zero;
    TimeSpan _next;
    bool _wasCurrent;
    HeadsetResult.OutageResult _now;

    /// <summary>Whether the last frame belongs to an outage: the time without a current pose exceeds the minimum duration.</summary>
    public bool IsOutage => _now != null;

    /// <param name="time">Start time of the frame since the start of the run; must increase.</param>
    /// <param name="describe">
    /// Gets the pose state, the joints without data and the reason. Called a few times per second while the pose is not current.
    /// </param>
    public void Add(TimeSpan time, bool isCurrent, Func<(string Pose, IReadOnlyList<string> Joints, string Reason)> describe)
    {
        if (isCurrent)
        {
            End(time);
            return;
        }

        _since ??= time;
        if (time - _since < (_wasCurrent ? MinLength : MinLengthAtStart) || time < _next) return;
        _next = time + Interval;
        var (pose, joints, reason) = describe();
        var isNew = _reported != (pose, reason);
        _reported = (pose, reason);
        if (reason.Length > 0 && _reasons.Count < MaxReasons && !_reasons.Contains(reason)) _reasons.Add(reason);
        _joints.UnionWith(joints);
        _now = new HeadsetResult.OutageResult(_since.Value.TotalSeconds, null, pose, [.. _joints], string.Join("; then ", _reasons));
        if (isNew) say(HeadsetMessages.Pose(time.TotalSeconds, pose, reason));
    }

    /// <summary>Number of finished outages that are not in the result. None of them is longer than those in the result.</summary>
    public int NotListed { get; private set; }

    public IReadOnlyList<HeadsetResult.OutageResult> Result() => _now == null ? _outages : [.. _outages, _now];

    void End(TimeSpan time)
    {
        _wasCurrent = true;
        if (_now != null)
        {
            _outages.Add(_now with { ToS = time.TotalSeconds });
            if (_outages.Count > MaxCount)
            {
                _outages.Remove(_outages.MinBy(outage => outage.ToS - outage.FromS));
                NotListed++;
            }
            say(HeadsetMessages.CurrentAgain(time.TotalSeconds, (time - _since.Value).TotalSeconds));
        }

        (_since, _now, _reported, _next) = (null, null, null, TimeSpan.Zero);
        _reasons.Clear();
        _joints.Clear();
    }
}
