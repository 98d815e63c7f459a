using System.Collections.Concurrent;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Plants;
using Nowpose.Gateway.Recording;
using Nowpose.Gateway.Status.Cell;
using Nowpose.Gateway.Status.Joints;
using Nowpose.Kinematics;

namespace Nowpose.Gateway.Status.Events;

/// <summary>Finds all present faults. Thread-safe.</summary>
sealed class Conditions(
    GatewayOptions options, ServedClock clock, DiagnosticsBoard diagnostics, RefusalConditions refusals,
    ConnectionLimits connections, CellReports cell, CellBoard board, LimitAlarm limits, Recorder recorder)
{
    /// <summary>
    /// Time for which a frame must be an orphan. In this time, the sources of a cell can start one after the other, and the gateway can read the description
    /// of a robot.
    /// </summary>
    static readonly TimeSpan OrphanTimeout = TimeSpan.FromSeconds(1);

    /// <summary>Start of the remedy in the text with which an adapter explains why a joint may not be at rest.</summary>
    const string OwnRemedy = "; set ";

    static readonly string[] CurrentPoses = ["current", "coarse"];

    // Last time at which each adapter was not connected, for adapters that are not, or were not until recently.
    readonly ConcurrentDictionary<string, long> _unconnected = new();

    /// <summary>State of each adapter that this gateway started.</summary>
    public IReadOnlyList<Func<AdapterState>> Adapters { get; set; } = [];

    /// <summary>Gets the conditions, the worst first.</summary>
    /// <param name="joints">The latest states of the joint board.</param>
    public IReadOnlyList<Condition> Read(IReadOnlyList<JointSnapshot> joints)
    {
        var reports = diagnostics.Read();
        // The joints, frames and signals of an adapter that is not connected have the same fault as the adapter, and a wrong rate of the control
        // clock makes all joints faulty.
        var lost = reports.Select(one => (Report: one, Reason: NotConnectedReason(one))).Where(one => one.Reason != null).ToArray();
        var unconnected = lost.Select(one => StatusObjects.AdapterName(one.Report.Name)).ToHashSet();
        NoteUnconnected(unconnected);
        var faulty = joints.Where(row => !row.IsGood).ToLookup(row => unconnected.Contains(row.Source));
        return
        [
            .. lost.Select(one => OfConnection(one.Report, one.Reason, faulty[true])).Concat(ClockConditions.Of(clock)).Concat(OfSources(joints))
                .Concat(OfAdapters(reports))
                .Concat(faulty[false].Where(row => row.ReasonWord != JointFaultReasons.ClockRate).Select(row => Of(row) with { Age = ConnectionTime(row) }))
                .Concat(OfUncertainRests(joints))
                .Concat(OfCell("frame", AdapterReport.FramePrefix, unconnected)).Concat(OfCell("signal", AdapterReport.SignalPrefix, unconnected))
                .Concat(OfFrames(joints, unconnected)).Concat(OfSignals(unconnected))
                .Concat(reports.SelectMany(Of)).Concat(refusals.Read()).Concat(limits.Invalid.Select(OfDescription)).Concat(OfLimits(joints)).Concat(OfRecording())
                .Concat(connections.Read()).Concat(AccessConditions.Of(options))
                .DistinctBy(condition => condition.Key).OrderByDescending(condition => condition.Level),
        ];
    }

    void NoteUnconnected(IEnumerable<string> names)
    {
        foreach (var name in names) _unconnected[name] = options.Time.GetTimestamp();
        foreach (var (name, last) in _unconnected)
            if (options.Time.GetElapsedTime(last) > EventList.StartGrace) _unconnected.TryRemove(name, out _);
    }

    // Until the first samples after a lost connection, joints are missing as they are at the start.
    TimeSpan? ConnectionTime(JointSnapshot row) => _unconnected.TryGetValue(row.Source, out var last) ? options.Time.GetElapsedTime(last) : null;

    internal static Condition Of(JointSnapshot row) =>
        new(
            "joint", $"{row.Name} ({row.Source})", row.State == JointDataState.Fault ? EventTexts.InFault : EventTexts.Is(row.Word), row.Reason,
            Level.Error, true, row.Since)
        {
            Remedy = row.State switch
            {
                JointDataState.Stale => EventRemedies.Source,
                JointDataState.Missing => JointFaultReasons.IsOfValue(row.ReasonWord) ? EventRemedies.Values : EventRemedies.MissingJoint,
                JointDataState.Refused => EventRemedies.Values,
                JointDataState.Fault => EventRemedies.Plant,
                _ => "",
            },
            IsNormalAtStart = row.State == JointDataState.Missing || row.State == JointDataState.Refused && IsClockAwaited(row.Reason),
        };

    // Whether samples are refused only because the adapter's clock is not measured yet, which is normal for the first samples.
    static bool IsClockAwaited(string reason) => reason.Contains(DropMessages.Of(DropReason.Unsynchronised), StringComparison.Ordinal);

    static IEnumerable<Condition> OfUncertainRests(IReadOnlyList<JointSnapshot> joints) => joints.Where(row => row.Uncertainty.Length > 0).Select(
        row => new Condition("joint", $"{row.Name} ({row.Source})", EventTexts.UncertainRest, row.Uncertainty, Level.Warning, Since: row.Since)
        {
            Remedy = row.Uncertainty.Contains(OwnRemedy, StringComparison.Ordinal) ? EventRemedies.CheckRest : EventRemedies.SetDeceleration,
        });

    // These conditions do not affect the gateway's readiness, because headsets can show the robot without objects or signals.
    IEnumerable<Condition> OfCell(string kind, string prefix, HashSet<string> unconnected) =>
        from one in cell.Troubled(prefix)
        where !unconnected.Contains(one.Adapter)
        select new Condition(
            kind, $"{one.Name} ({one.Adapter})",
            one.Report.State == JointDataState.Fault ? EventTexts.InFault : EventTexts.Is(JointDataStates.Of(one.Report.State)), one.Report.Reason,
            Level.Error, Since: one.Report.Since)
        {
            Remedy = EventRemedies.CellVariables,
            IsNormalAtStart = one.Report.State == JointDataState.Missing,
        };

    // Frames whose adapter reports a fault have a condition of OfCell. A parent that is not current has a condition of its own, or its robot's joints have.
    IEnumerable<Condition> OfFrames(IReadOnlyList<JointSnapshot> joints, HashSet<string> unconnected)
    {
        var frames = board.Frames(clock.Now, joints);
        var reported = frames.Where(HasFault).Select(frame => frame.Name).ToHashSet(StringComparer.Ordinal);
        return
            from frame in frames
            where !unconnected.Contains(frame.Source)
            where frame is { State: CellStates.Stale, IsAtRest: false } || IsRefused(frame.State) || IsMissing(frame.State)
                || frame.State == CellStates.Orphan && frame.KnownFor >= OrphanTimeout && !reported.Contains(frame.Cause)
            select Of(frame);
    }

    // Whether the frame has a condition, or will have one as soon as its state has lasted long enough.
    static bool HasFault(FrameView frame) => frame.Since != null && frame.State != CellStates.ParentStale && !frame.IsAtRest;

    static Condition Of(FrameView frame)
    {
        var isOrphan = frame.State == CellStates.Orphan;
        return new(
            "frame", $"{frame.Name} ({frame.Source})", isOrphan ? EventTexts.IsOrphan : EventTexts.Is(frame.State), frame.Reason, Level.Warning,
            Since: frame.Since)
        {
            Remedy = isOrphan ? EventRemedies.Parent : IsRefused(frame.State) ? EventRemedies.Values : EventRemedies.Source,
            IsNormalAtStart = isOrphan || IsMissing(frame.State) || IsRefused(frame.State) && IsClockAwaited(frame.Reason),
        };
    }

    static bool IsMissing(string state) => state == JointDataStates.Of(JointDataState.Missing);

    static bool IsRefused(string state) => state == JointDataStates.Of(JointDataState.Refused);

    IEnumerable<Condition> OfSignals(HashSet<string> unconnected) =>
        from signal in board.Signals(clock.Now)
        where !unconnected.Contains(signal.Source)
        where signal.State == CellStates.Ended || IsRefused(signal.State)
        let isRefused = IsRefused(signal.State)
        select new Condition(
            "signal", $"{signal.Name} ({signal.Source})", isRefused ? EventTexts.IsRefused : EventTexts.HasNoSource, signal.Reason, Level.Warning,
            Since: signal.Since)
        {
            Remedy = isRefused ? EventRemedies.Values : EventRemedies.Source,
            IsNormalAtStart = isRefused && IsClockAwaited(signal.Reason),
        };

    IEnumerable<Condition> OfSources(IReadOnlyList<JointSnapshot> rows)
    {
        if (!options.ExpectsSources || rows.Count > 0) return [];
        return
        [
            new("source", EventTexts.OfJointPositions, EventTexts.IsMissing, EventTexts.NoSource, Level.Error, true)
            {
                Headline = EventTexts.SourceMissing,
                Remedy = EventRemedies.Adapters,
                IsNormalAtStart = true,
            },
        ];
    }

    // Finds adapters that have not reported since their start. SilentAdapter covers adapters whose reports stop later.
    IEnumerable<Condition> OfAdapters(IReadOnlyList<ClientReport> reports) =>
        from state in Adapters.Select(adapter => adapter())
        let isReporting = reports.Any(one => one.IsOfAdapter && StatusObjects.AdapterName(one.Name) == state.Name && one.Ago < state.RunTime)
        where !isReporting
        let end = state.End is { } end ? EventTexts.ProgramEnded(end) : null
        select new Condition(
            "adapter", state.Name, EventTexts.DoesNotReport, end == null ? EventTexts.ProgramStarted : EventTexts.StartedAgain(end), Level.Error,
            true)
        {
            Remedy = end == null ? "" : EventRemedies.GatewayLog,
            IsNormalAtStart = end == null,
        };

    static string ValueOf(ClientReport report, string key) => report.Values.FirstOrDefault(pair => pair.Key == key).Value;

    // Returns the state of an adapter that is not connected to its plant, with the reason if it reports one; null for another client.
    static string NotConnectedReason(ClientReport report)
    {
        if (!report.IsOfAdapter || report.Ago > StatusObjects.Silence) return null;
        if (ValueOf(report, "state") is not { } state || state == "connected") return null;
        return ValueOf(report, "reason") is { } why ? $"{state}: {why}" : state;
    }

    /// <param name="faulty">The faulty joints of all adapters that are not connected.</param>
    static Condition OfConnection(ClientReport report, string reason, IEnumerable<JointSnapshot> faulty)
    {
        var name = StatusObjects.AdapterName(report.Name);
        return new("adapter", name, EventTexts.IsNotConnected, reason, Level.Error, faulty.Any(row => row.Source == name))
        {
            Headline = EventTexts.NotConnected(name),
            // Normal only before the first samples; later, it means that the connection was lost.
            IsNormalAtStart = ValueOf(report, "samples") is null or "0",
            Age = report.Age,
        };
    }

    IEnumerable<Condition> Of(ClientReport report)
    {
        var isAdapter = report.IsOfAdapter;
        var (kind, name) = isAdapter ? ("adapter", StatusObjects.AdapterName(report.Name)) : ("headset", report.Name);
        if (report.Ago > StatusObjects.Silence)
        {
            yield return isAdapter ? SilentAdapter(name, report.Ago) : LostHeadset(name, report.Ago);
            yield break;
        }

        string Value(string key) => ValueOf(report, key);
        if (isAdapter && Value("notice") is { } notice)
            yield return new(kind, name, EventTexts.HasNotice, notice, Level.Warning);
        if (NowposeVersion.MismatchOf(Value("version"), "it", EventTexts.ThisGateway) is { } mismatch)
            yield return new(kind, name, EventTexts.OtherVersion, mismatch, Level.Warning);
        // While no control clock is served, no headset is synchronised, and the clock has a condition of its own.
        if (!isAdapter && Value(HeadsetKeys.Pose) is { } pose && !CurrentPoses.Contains(pose) && (pose != "unsynchronised" || clock.IsSynchronised))
            yield return new(kind, name, EventTexts.NoCurrentPose, ReasonOf(pose, Value(HeadsetKeys.MissingJoints)), Level.Warning)
            {
                Remedy = RemedyOf(pose, Value(HeadsetKeys.MissingJoints)),
                // The first frames come before the first samples and before enough sync exchanges.
                IsNormalAtStart = true,
                Age = report.Age,
            };
    }

    Condition SilentAdapter(string name, TimeSpan ago) =>
        new("adapter", name, EventTexts.DoesNotReport, EventTexts.ReportsStopped, Level.Error, Since: options.Time.GetUtcNow() - ago)
        {
            Remedy = EventRemedies.Adapter,
        };

    Condition LostHeadset(string name, TimeSpan ago) =>
        new("headset", name, EventTexts.IsLost, EventTexts.HeadsetLost, Level.Warning, Since: options.Time.GetUtcNow() - ago)
        {
            Remedy = EventRemedies.HeadsetPower,
        };

    static string RemedyOf(string pose, string missing) => !string.IsNullOrEmpty(missing) ? EventRemedies.MissingJoints : pose switch
    {
        "unsynchronised" => EventRemedies.HeadsetNetwork,
        "held" => EventRemedies.LateSamples,
        _ => EventRemedies.StatusPanel,
    };

    static string ReasonOf(string pose, string missing) =>
        string.IsNullOrEmpty(missing) ? EventTexts.Pose(pose) : EventTexts.MissingJoints(pose, missing);

    // Does not affect the gateway's readiness, because a headset can have a description of its own.
    static Condition OfDescription((string Namespace, string Fault) one) =>
        new("description", RobotTopic.NameOf(one.Namespace, RosTopics.RobotDescription), EventTexts.IsInvalid, one.Fault, Level.Error)
        {
            Headline = EventTexts.InvalidDescription(one.Namespace),
            Remedy = EventRemedies.Description,
        };

    // The position of a joint without current data is not known, and the joint has a condition of its own unless its source has ended normally.
    IEnumerable<Condition> OfLimits(IReadOnlyList<JointSnapshot> joints) =>
        limits.Beyond.Where(one => joints.Any(row => row.Name == one.Name && row.IsGood)).Select(Of);

    static Condition Of((string Name, JointBeyondLimits Found) one)
    {
        var (name, found) = one;
        var (joint, allowed) = (found.Joint, found.Joint.Limits);
        var (unit, other) = joint.Kind == JointKind.Prismatic ? ("m", "mm") : ("rad", "deg");
        return new Condition(
            "limit", name, EventTexts.IsExceeded, EventTexts.BeyondLimits(found.Position, unit, allowed.Lower, allowed.Upper), Level.Warning)
        {
            Headline = EventTexts.JointBeyondLimits(name),
            Remedy = EventRemedies.Limits(unit, other),
        };
    }

    IEnumerable<Condition> OfRecording()
    {
        var status = recorder.Status;
        if (status.Problem != null)
            yield return new("recording", status.File, EventTexts.Stopped, status.Problem, Level.Warning)
            {
                Remedy = status.IsDeletedWhileWritten ? EventRemedies.RecordAgain : EventRemedies.Recording,
            };
        else if (status is { On: true, Lost: > 0 })
            yield return new("recording", status.File, EventTexts.IsIncomplete, EventTexts.LinesMissing(status.Lost), Level.Warning)
            {
                Remedy = EventRemedies.RecordingDisk,
            };
    }
}
