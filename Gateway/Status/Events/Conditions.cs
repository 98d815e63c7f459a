using System.Globalization;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Recording;
using Nowpose.Gateway.Status.Joints;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Status.Events;

/// <summary>Finds everything that is wrong at the moment. Any thread.</summary>
sealed class Conditions(
    GatewayOptions options, ServedClock clock, DiagnosticsBoard diagnostics, RecentRefusals refusals, LimitAlarm limits,
    Recorder recorder)
{
    /// <summary>Timeout of the reports of adapters and headsets, which come once per second.</summary>
    static readonly TimeSpan Silence = TimeSpan.FromSeconds(3);

    /// <summary>Remaining validity from which on a certificate is reported.</summary>
    static readonly TimeSpan CertificateNotice = TimeSpan.FromDays(30);

    static readonly string[] CurrentPoses = ["current", "coarse"];

    /// <summary>The worst first.</summary>
    /// <param name="joints">As the joint board has just judged them.</param>
    public IReadOnlyList<Condition> Read(IReadOnlyList<JointStatus> joints) =>
    [
        .. OfClock().Concat(OfSources(joints)).Concat(joints.Where(row => !row.IsGood).Select(Of)).Concat(diagnostics.Read().SelectMany(Of))
            .Concat(OfRefusals()).Concat(OfLimits()).Concat(OfRecording()).Concat(OfCertificate()).OrderByDescending(condition => condition.Level),
    ];

    static Condition Of(JointStatus row) =>
        new("joint", $"{row.Name} ({row.Source})", $"is {(row.State == JointDataState.Fault ? "in fault" : row.Word)}", row.Reason, Level.Error, true, row.Since);

    IEnumerable<Condition> OfClock()
    {
        if (!clock.IsSynchronised)
            yield return new("clock", clock.Source, "is not served", $"its state is {clock.State.Word()}", Level.Error, true);
        var stamps = clock.Stamps;
        if (stamps.Warning is { } warning)
            yield return new(
                "clock", clock.Source, "contradicts the stamps of samples", warning, stamps.IsContradicted ? Level.Error : Level.Warning, stamps.IsContradicted);
    }

    IEnumerable<Condition> OfSources(IReadOnlyList<JointStatus> rows)
    {
        if (!options.ExpectsSources || rows.Count > 0) return [];
        return [new("source", "of joint positions", "is missing", "no adapter has reported a joint and no sample has arrived", Level.Error, true)];
    }

    IEnumerable<Condition> Of((string Name, TimeSpan Ago, IReadOnlyList<KeyValuePair<string, string>> Values) said)
    {
        var isAdapter = StatusObjects.IsAdapter(said.Name);
        var (kind, name) = isAdapter ? ("adapter", StatusObjects.AdapterName(said.Name)) : ("headset", said.Name);
        if (said.Ago > Silence)
        {
            yield return new(kind, name, isAdapter ? "does not report" : "is lost", "", isAdapter ? Level.Error : Level.Warning);
            yield break;
        }

        string Value(string key) => said.Values.FirstOrDefault(pair => pair.Key == key).Value;
        if (isAdapter && Value("state") is { } state && state != "connected")
            yield return new(kind, name, "is not connected", Value("reason") is { } why ? $"{state}: {why}" : state, Level.Error);
        if (!isAdapter && Value("pose") is { } pose && !CurrentPoses.Contains(pose))
            yield return new(kind, name, "shows no current pose", ReasonOf(pose, Value("missing_joints")), Level.Warning);
    }

    static string ReasonOf(string pose, string missing) =>
        string.IsNullOrEmpty(missing) ? $"the pose is {pose}" : $"the pose is {pose}; missing joints: {missing}";

    IEnumerable<Condition> OfRefusals() => refusals.Read().Select(
        one => new Condition("source", $"{one.Source} of joint {one.Joint}", "is refused", $"the source {one.Owner} already publishes this joint", Level.Warning));

    IEnumerable<Condition> OfLimits() => limits.Joints.Select(joint => new Condition(
        "limit", joint, "is exceeded", "the position is outside the limits of the robot description; check the description, and rad and m", Level.Warning));

    IEnumerable<Condition> OfRecording()
    {
        var status = recorder.Status;
        if (status.Problem != null) yield return new("recording", status.File, "stopped", status.Problem, Level.Warning);
    }

    IEnumerable<Condition> OfCertificate()
    {
        var left = options.CertificateExpires - options.Time.GetUtcNow().UtcDateTime;
        if (left > CertificateNotice || left == null) yield break;
        var day = options.CertificateExpires.Value.ToString("yyyy-MM-dd HH:mm 'UTC'", CultureInfo.InvariantCulture);
        const string Cure = "renew the file with the same key; the gateway takes it without a restart";
        yield return left > TimeSpan.Zero
            ? new("certificate", "of the gateway", "is about to expire", $"it expires on {day}; {Cure}", Level.Warning)
            : new("certificate", "of the gateway", "has expired", $"headsets refuse it since {day}; {Cure}", Level.Error, true);
    }
}
