using System.Globalization;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Plants;
using Nowpose.Gateway.Recording;
using Nowpose.Gateway.Rosbridge;
using Nowpose.Gateway.Status.Cell;
using Nowpose.Gateway.Status.Joints;
using Nowpose.Kinematics;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Status.Events;

/// <summary>Finds all present faults. Thread-safe.</summary>
sealed class Conditions(
    GatewayOptions options, ServedClock clock, DiagnosticsBoard diagnostics, RecentRefusals refusals, CellReports cell, LimitAlarm limits,
    Recorder recorder)
{
    /// <summary>Time without a report after which an adapter or headset is silent. Both report once per second.</summary>
    static readonly TimeSpan Silence = TimeSpan.FromSeconds(3);

    /// <summary>Remaining validity below which a certificate is reported.</summary>
    static readonly TimeSpan CertificateNotice = TimeSpan.FromDays(30);

    const string DoesNotReport = "does not report";

    /// <summary>Text by which an adapter's reason for an uncertain rest contains a remedy.</summary>
    const string OwnRemedy = "; set ";

    static readonly string[] CurrentPoses = ["current", "coarse"];

    /// <summary>State of each adapter that this gateway started.</summary>
    public IReadOnlyList<Func<AdapterState>> Adapters { get; set; } = [];

    /// <summary>Gets the conditions, the worst first.</summary>
    /// <param name="joints">The latest states of the joint board.</param>
    public IReadOnlyList<Condition> Read(IReadOnlyList<JointStatus> joints)
    {
        var reports = diagnostics.Read();
        return
        [
            .. OfClock().Concat(OfStamps()).Concat(OfSources(joints)).Concat(OfAdapters(reports)).Concat(joints.Where(row => !row.IsGood).Select(Of)).Concat(OfUncertainRests(joints))
                .Concat(OfCell("frame", AdapterReport.FramePrefix)).Concat(OfCell("signal", AdapterReport.SignalPrefix))
                .Concat(reports.SelectMany(Of)).Concat(OfRefusals()).Concat(OfLimits()).Concat(OfRecording()).Concat(OfCertificate())
                .DistinctBy(condition => condition.Key).OrderByDescending(condition => condition.Level),
        ];
    }

    internal static Condition Of(JointStatus row) =>
        new("joint", $"{row.Name} ({row.Source})", $"is {(row.State == JointDataState.Fault ? "in fault" : row.Word)}", row.Reason, Level.Error, true, row.Since)
        {
            Remedy = row.State switch
            {
                JointDataState.Stale => "Check that its source runs and reaches the gateway.",
                JointDataState.Missing => "Check that the plant offers the joint's value and that the plant's configuration names it correctly.",
                JointDataState.Refused => "Check the values that its source sends.",
                JointDataState.Fault => "Check the plant and its connection.",
                _ => "",
            },
            IsNormalAtStart = row.State == JointDataState.Missing || IsClockAwaited(row),
        };

    // Whether samples are refused only because the adapter's clock is not measured yet, as for its first samples.
    static bool IsClockAwaited(JointStatus row) => row.State == JointDataState.Refused
        && row.Reason.Contains(DropText.Of(DropReason.Unsynchronised), StringComparison.Ordinal);

    static IEnumerable<Condition> OfUncertainRests(IReadOnlyList<JointStatus> joints) => joints.Where(row => row.Uncertainty.Length > 0).Select(
        row => new Condition("joint", $"{row.Name} ({row.Source})", "may not be at rest", row.Uncertainty, Level.Warning, Since: row.Since)
        {
            Remedy = "Check that the joint is at rest" + (row.Uncertainty.Contains(OwnRemedy, StringComparison.Ordinal)
                ? "." : "; if it is, set its max_deceleration in the plant's configuration."),
        });

    // These conditions do not block, because the robot can be shown without objects and signals.
    IEnumerable<Condition> OfCell(string kind, string prefix) => cell.Troubled(prefix).Select(
        one => new Condition(
            kind, $"{one.Name} ({one.Adapter})", $"is {(one.Report.State == JointDataState.Fault ? "in fault" : JointDataStates.Of(one.Report.State))}", one.Report.Reason,
            Level.Error, Since: one.Report.Since)
        {
            Remedy = "Check its variables in the plant and its entry in the plant's configuration.",
            IsNormalAtStart = one.Report.State == JointDataState.Missing,
        });

    string ClockName => clock.Source == PlantClocks.Own ? "the gateway's own control clock" : $"the control clock {clock.Source}";

    IEnumerable<Condition> OfClock()
    {
        if (!clock.IsSynchronised)
            yield return new("clock", clock.Source, "is not served", $"its state is {clock.State.Word()}", Level.Error, true)
            {
                Headline = $"{ClockName} is not served to headsets",
                Remedy = clock.Source == PlantClocks.Own ? "" : "Check the adapter that reads this clock.",
                // Not normal in holdover, which means that the clock was synchronised before.
                IsNormalAtStart = clock.State is ClockState.Unsynchronised or ClockState.Converging,
            };
        var stamps = clock.Stamps;
        if (stamps.Found is not { } found) yield break;
        yield return found.IsContradiction
            ? new("clock", clock.Source, "contradicts the stamps of samples", found.Reason, Level.Error, true)
            {
                Headline = $"{ClockName} and the stamps of samples contradict each other",
                Remedy = found.Remedy,
            }
            : new("clock", clock.Source, "does not follow the system clock", found.Reason, Level.Warning)
            {
                Headline = $"{ClockName} does not follow the system clock",
                Remedy = found.Remedy,
            };
    }

    IEnumerable<Condition> OfStamps() => clock.Stamps.Ahead.Select(
        one => new Condition("source", one.Source, "sends time stamps in the future", $"they are {one.By} ahead of the control clock", Level.Warning)
        {
            Headline = $"source {one.Source} sends time stamps in the future",
            Remedy = StampWatch.SourceRemedy,
        });

    IEnumerable<Condition> OfSources(IReadOnlyList<JointStatus> rows)
    {
        if (!options.ExpectsSources || rows.Count > 0) return [];
        return
        [
            new("source", "of joint positions", "is missing", "no adapter has reported a joint and no sample has arrived", Level.Error, true)
            {
                Headline = "a source of joint positions is missing",
                Remedy = "Check that the adapter of each plant runs and is connected.",
                IsNormalAtStart = true,
            },
        ];
    }

    // Finds adapters that have not reported since their start. SilentAdapter covers adapters whose reports stop later.
    IEnumerable<Condition> OfAdapters(IReadOnlyList<(string Name, TimeSpan Ago, IReadOnlyList<KeyValuePair<string, string>>)> reports) =>
        from state in Adapters.Select(adapter => adapter())
        let isReporting = reports.Any(one => StatusObjects.IsAdapter(one.Name) && StatusObjects.AdapterName(one.Name) == state.Name && one.Ago < state.RunTime)
        where !isReporting
        let end = state.End is { } end ? $"its program ended with {end}" : null
        select new Condition(
            "adapter", state.Name, DoesNotReport, end == null ? "its program has just started" : $"{end} and is started again", Level.Error, true)
        {
            Remedy = end == null ? "" : "Read its lines in the gateway's log.",
            IsNormalAtStart = end == null,
        };

    IEnumerable<Condition> Of((string Name, TimeSpan Ago, IReadOnlyList<KeyValuePair<string, string>> Values) report)
    {
        var isAdapter = StatusObjects.IsAdapter(report.Name);
        var (kind, name) = isAdapter ? ("adapter", StatusObjects.AdapterName(report.Name)) : ("headset", report.Name);
        if (report.Ago > Silence)
        {
            yield return isAdapter ? SilentAdapter(name, report.Ago) : LostHeadset(name, report.Ago);
            yield break;
        }

        string Value(string key) => report.Values.FirstOrDefault(pair => pair.Key == key).Value;
        if (isAdapter && Value("state") is { } state && state != "connected")
            yield return new(kind, name, "is not connected", Value("reason") is { } why ? $"{state}: {why}" : state, Level.Error)
            {
                Headline = $"adapter {name} is not connected to its plant",
                // Normal only before the first samples; later, it means that the connection was lost.
                IsNormalAtStart = Value("samples") is null or "0",
            };
        if (NowposeVersion.MismatchOf(Value("version"), "it", "this gateway") is { } mismatch)
            yield return new(kind, name, "does not fit this gateway", mismatch, Level.Warning);
        if (!isAdapter && Value("pose") is { } pose && !CurrentPoses.Contains(pose))
            yield return new(kind, name, "shows no current pose", ReasonOf(pose, Value("missing_joints")), Level.Warning)
            {
                Remedy = RemedyOf(pose, Value("missing_joints")),
            };
    }

    Condition SilentAdapter(string name, TimeSpan ago) =>
        new("adapter", name, DoesNotReport, "its reports stopped", Level.Error, Since: options.Time.GetUtcNow() - ago)
        {
            Remedy = "Check that the adapter runs and reaches the gateway.",
        };

    Condition LostHeadset(string name, TimeSpan ago) =>
        new("headset", name, "is lost", "its reports stopped without a normal end of the connection", Level.Warning, Since: options.Time.GetUtcNow() - ago)
        {
            Remedy = "Check its power and its network.",
        };

    static string RemedyOf(string pose, string missing) => !string.IsNullOrEmpty(missing) ? "Check the sources of these joints." : pose switch
    {
        "unsynchronised" => "Check the network between the headset and the gateway.",
        "held" => "Check that samples reach the headset in time.",
        _ => "Look at the status panel of the headset.",
    };

    static string ReasonOf(string pose, string missing) =>
        string.IsNullOrEmpty(missing) ? $"the pose is {pose}" : $"the pose is {pose}; missing joints: {missing}";

    IEnumerable<Condition> OfRefusals() => refusals.Read().Select(
        one => new Condition("source", $"{one.Source} of joint {one.Joint}", "is refused", $"the source {one.Owner} already publishes this joint", Level.Warning)
        {
            Headline = $"source {one.Source} is refused for joint {one.Joint}",
            Remedy = "Stop one of the two sources.",
        });

    IEnumerable<Condition> OfLimits() => limits.Beyond.Select(Of);

    static Condition Of(JointBeyondLimits found)
    {
        var (joint, allowed) = (found.Joint, found.Joint.Limits);
        var (unit, other) = joint.Kind == JointKind.Prismatic ? ("m", "mm") : ("rad", "degrees");
        return new Condition("limit", joint.Name, "is exceeded", string.Create(
            CultureInfo.InvariantCulture, $"its position was {found.Position:0.###} {unit}; allowed: {allowed.Lower:0.###} to {allowed.Upper:0.###} {unit}"), Level.Warning)
        {
            Headline = $"joint {joint.Name} is outside the limits of the robot description",
            Remedy = $"Check that the description belongs to this robot and that the source sends {unit}, not {other}.",
        };
    }

    IEnumerable<Condition> OfRecording()
    {
        var status = recorder.Status;
        if (status.Problem != null)
            yield return new("recording", status.File, "stopped", status.Problem, Level.Warning)
            {
                Remedy = status.IsDeletedWhileWritten ? "Start the recording again to write a new file." : "Correct this, then start the recording again.",
            };
    }

    IEnumerable<Condition> OfCertificate()
    {
        var left = options.CertificateExpires - options.Time.GetUtcNow().UtcDateTime;
        if (left > CertificateNotice || left == null) yield break;
        var day = options.CertificateExpires.Value.ToString("yyyy-MM-dd HH:mm 'UTC'", CultureInfo.InvariantCulture);
        const string Remedy = "renew the file with the same key; the gateway needs no restart";
        yield return left > TimeSpan.Zero
            ? new("certificate", "of the gateway", "is about to expire", $"it expires on {day}; {Remedy}", Level.Warning)
            {
                Headline = "the gateway's certificate is about to expire",
            }
            : new("certificate", "of the gateway", "has expired", $"headsets have refused it since {day}; {Remedy}", Level.Error, true)
            {
                Headline = "the gateway's certificate has expired",
            };
    }
}
