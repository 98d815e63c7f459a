using System.Text.Json.Nodes;
using System.Text.Json.Serialization;
using Nowpose.Gateway.Status.Events;

namespace Nowpose.Gateway.Status;

/// <summary>How a gateway does at one moment: what /operations/state answers, its names in snake case. Units stand in the names.</summary>
/// <param name="ControlTimeS">What the control clock shows.</param>
/// <param name="Adapters">What each said last of itself, and how long ago.</param>
/// <param name="Headsets">Likewise, with what each hop takes of its latency.</param>
/// <param name="Messages">That passed, by topic.</param>
/// <param name="Drops">Messages that did not, by reason.</param>
/// <param name="Role">Of whoever asks.</param>
/// <param name="CertificateExpiresUtc">From then on headsets refuse it; null without TLS.</param>
sealed record StatusSnapshot(
    string Cell, string Host, string Version, OverallStatus Status, string StartedUtc, double UptimeS, double ControlTimeS, ClockStatus Clock, IReadOnlyList<PlantClockView> PlantClocks,
    IReadOnlyList<JsonObject> Adapters, IReadOnlyList<SourceStatus> Sources, IReadOnlyList<JointView> Joints,
    IReadOnlyList<JsonObject> Headsets, SpanStatus ForwardMs,
    IReadOnlyDictionary<string, ConnectionStatus> Connections, IReadOnlyDictionary<string, long> Messages, IReadOnlyDictionary<string, long> Drops,
    RecordingStatus Recording, bool PairsHeadsets, bool IsReady, IReadOnlyList<EventView> Events, string Role = null,
    DateTime? CertificateExpiresUtc = null);

/// <param name="Source">Name of the adapter; gateway for the gateway's own robot, rosbridge for another client.</param>
/// <param name="State">live, rest, stale, refused, fault or missing.</param>
/// <param name="AgeS">Control time minus the newest sample's stamp; null before the first sample.</param>
/// <param name="Reason">One sentence; empty for a live joint.</param>
/// <param name="Uncertain">Why it is not certain that a joint at rest rests; null where it is, and for other states.</param>
sealed record JointView(
    string Name, string Source, string State, string SinceUtc, double? AgeS, double RateHz, string Reason, string Uncertain = null);

/// <param name="Source">"own", or the name of the plant clock that is served.</param>
/// <param name="State">unsynchronised, converging, coarse, synchronised or holdover.</param>
/// <param name="IsServed">Whether headsets are told that they may trust it.</param>
/// <param name="ErrorBoundUs">Null while nothing is known of it; likewise what follows.</param>
/// <param name="EstimatedErrorUs">The ± of a plant's clock; null while it is not known, and for the gateway's own.</param>
/// <param name="SkewPpm">Its rate over that of the gateway's counter, less one.</param>
/// <param name="Warning">How the stamps of sources contradict it, and what to do; null while they do not.</param>
sealed record ClockStatus(
    string Source, string State, bool IsServed, double? ErrorBoundUs, double? SkewPpm, double? RttMs, double? ResolutionUs, long? Steps,
    double? EstimatedErrorUs = null, string Warning = null);

/// <param name="OffsetToControlMs">This clock less the control clock; null while one of them is not known.</param>
/// <param name="RttMs">Null before the first exchange: 0 would be the best there is. Likewise what follows.</param>
/// <param name="EstimatedErrorUs">The ±; null while the clock is not known.</param>
sealed record PlantClockView(
    string Name, bool Connected, bool IsControlClock, string State, double? OffsetToControlMs, double? DriftPpm, double? RttMs, double? ErrorBoundUs,
    double? ResolutionUs, long Exchanges, long Failures, string LastFailure, double? EstimatedErrorUs = null);

/// <param name="Joints">That are published together, or in sets that have joints in common.</param>
/// <param name="RateHz">Messages a second.</param>
/// <param name="AgeMs">C1 at the gateway less t_k.</param>
/// <param name="BeyondLimits">Those of its joints that are told to be where the robot described cannot be.</param>
sealed record SourceStatus(IReadOnlyList<string> Joints, double RateHz, AgeStatus AgeMs, IReadOnlyList<string> BeyondLimits);

sealed record AgeStatus(double P50, double P95);

/// <summary>From a sample's receipt to the sockets, of the last half minute to minute; null while there were none.</summary>
sealed record SpanStatus(double P50, double P99);

/// <param name="Closures">How many ended, by reason.</param>
sealed record ConnectionStatus(int Open, long Accepted, IReadOnlyDictionary<string, long> Closures);

/// <param name="Can">Whether there is a folder to record into.</param>
/// <param name="File">The one that is written, or was last; its name without the folder.</param>
/// <param name="Lost">Lines that are missing in it.</param>
/// <param name="Problem">Why it stopped by itself; null otherwise.</param>
/// <param name="Deleted">The newest recording was ended and its file was deleted since.</param>
sealed record RecordingStatus(bool Can, bool On, string File, long Lines, long Bytes, long Lost, string Problem, bool Deleted = false)
{
    public static readonly RecordingStatus None = new(false, false, null, 0, 0, 0, null);

    /// <summary>Whether the problem is that the file was deleted while it was written.</summary>
    [JsonIgnore]
    public bool IsDeletedWhileWritten { get; init; }
}
