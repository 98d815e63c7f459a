using System.Text.Json.Nodes;
using System.Text.Json.Serialization;
using Nowpose.Gateway.Status.Events;

namespace Nowpose.Gateway.Status;

/// <summary>The state of a gateway at an instant, as answered by /operations/state with names in snake case. Names contain the units.</summary>
/// <param name="ControlTimeS">The control clock's time.</param>
/// <param name="Adapters">The latest diagnostics of each adapter, with their age.</param>
/// <param name="Headsets">The latest diagnostics of each headset, with their age and the share of each hop in the latency.</param>
/// <param name="Messages">Number of forwarded messages by topic.</param>
/// <param name="Drops">Number of dropped messages by reason.</param>
/// <param name="Role">Role of the requesting client.</param>
/// <param name="CertificateExpiresUtc">Expiry of the certificate, after which headsets refuse it; null without TLS.</param>
sealed record StatusSnapshot(
    string Cell, string Host, string Version, OverallStatus Status, string StartedUtc, double UptimeS, double ControlTimeS, ClockStatus Clock, IReadOnlyList<PlantClockView> PlantClocks,
    IReadOnlyList<JsonObject> Adapters, IReadOnlyList<SourceStatus> Sources, IReadOnlyList<JointView> Joints,
    IReadOnlyList<FrameView> Frames, IReadOnlyList<SignalView> Signals,
    IReadOnlyList<JsonObject> Headsets, SpanStatus ForwardMs,
    IReadOnlyDictionary<string, ConnectionStatus> Connections, IReadOnlyDictionary<string, long> Messages, IReadOnlyDictionary<string, long> Drops,
    RecordingStatus Recording, bool PairsHeadsets, bool IsReady, IReadOnlyList<EventView> Events, string Role = null,
    DateTime? CertificateExpiresUtc = null);

/// <param name="Source">Name of the adapter; gateway for the gateway's own robot, rosbridge for another client.</param>
/// <param name="State">live, rest, stale, refused, fault or missing.</param>
/// <param name="AgeS">Control time minus the newest sample's stamp; null before the first sample.</param>
/// <param name="Reason">One sentence; empty for a live joint.</param>
/// <param name="Uncertain">The reason why it is uncertain that a resting joint rests; null if it is certain, and for other states.</param>
sealed record JointView(
    string Name, string Source, string State, string SinceUtc, double? AgeS, double RateHz, string Reason, string Uncertain = null);

/// <param name="Source">The frame's source, like that of a joint.</param>
/// <param name="Parent">Null before the first pose.</param>
/// <param name="State">stationary; live; stale: no pose for a second; or the state that its adapter reports: refused, fault or missing.</param>
/// <param name="AgeS">Control time minus the newest pose's stamp; null for a stationary frame, and before the first pose.</param>
/// <param name="Reason">The adapter's reason for its state; null for none.</param>
sealed record FrameView(string Name, string Parent, string Source, string State, double? AgeS, string Reason = null);

/// <param name="Source">The signal's source, like that of a joint.</param>
/// <param name="Value">Null before the first value, like the age.</param>
/// <param name="State">live; ended: its source has ended; or the state that its adapter reports: refused, fault or missing.</param>
/// <param name="AgeS">Control time minus the stamp of the message with which the signal got its value.</param>
/// <param name="Reason">The adapter's reason for its state; null for none.</param>
sealed record SignalView(string Name, double? Value, string Source, string State, double? AgeS, string Reason = null);

/// <param name="Source">"own", or the name of the plant clock that is served.</param>
/// <param name="State">unsynchronised, converging, coarse, synchronised or holdover.</param>
/// <param name="IsServed">Whether headsets are informed that the clock is synchronised.</param>
/// <param name="ErrorBoundUs">Null while unknown, like the following values.</param>
/// <param name="EstimatedErrorUs">Estimated maximum error of a plant's clock, either way; null while unknown, and for the gateway's own.</param>
/// <param name="SkewPpm">Its rate relative to the gateway's counter, minus one.</param>
/// <param name="Warning">Contradiction to the stamps of sources, with its remedy; null for none.</param>
sealed record ClockStatus(
    string Source, string State, bool IsServed, double? ErrorBoundUs, double? SkewPpm, double? RttMs, double? ResolutionUs, long? Steps,
    double? EstimatedErrorUs = null, string Warning = null);

/// <param name="OffsetToControlMs">Time of this clock minus the control clock; null while either is unknown.</param>
/// <param name="SkewPpm">Rate of this clock relative to the control clock, minus one.</param>
/// <param name="RttMs">Null before the first exchange, because 0 would be the best value; the same for the following values.</param>
/// <param name="EstimatedErrorUs">Estimated maximum error in either direction; null while the clock is unknown.</param>
sealed record PlantClockView(
    string Name, bool Connected, bool IsControlClock, string State, double? OffsetToControlMs, double? SkewPpm, double? RttMs, double? ErrorBoundUs,
    double? ResolutionUs, long Exchanges, long Failures, string LastFailure, double? EstimatedErrorUs = null)
{
    /// <summary>Former name of <see cref="SkewPpm"/>, for programs that still read it.</summary>
    public double? DriftPpm => SkewPpm;
}

/// <param name="Joints">Joints that are published together, or in sets with common joints.</param>
/// <param name="RateHz">Messages per second.</param>
/// <param name="AgeMs">C1 at the gateway minus t_k.</param>
/// <param name="BeyondLimits">Joints whose published position is beyond the limits of the described robot.</param>
sealed record SourceStatus(IReadOnlyList<string> Joints, double RateHz, AgeStatus AgeMs, IReadOnlyList<string> BeyondLimits);

sealed record AgeStatus(double P50, double P95);

/// <summary>Time from a sample's receipt to the sockets, over the last half minute to minute; null without samples.</summary>
sealed record SpanStatus(double P50, double P99);

/// <param name="Closures">Number of ended connections by reason.</param>
sealed record ConnectionStatus(int Open, long Accepted, IReadOnlyDictionary<string, long> Closures);

/// <param name="Can">Whether a folder for recordings is configured.</param>
/// <param name="File">Name of the current or last file, without the folder.</param>
/// <param name="Lost">Number of missing lines.</param>
/// <param name="Problem">The reason why it stopped because of an error; null otherwise.</param>
/// <param name="Deleted">Whether the newest recording has ended and its file was deleted afterwards.</param>
sealed record RecordingStatus(bool Can, bool On, string File, long Lines, long Bytes, long Lost, string Problem, bool Deleted = false)
{
    public static readonly RecordingStatus None = new(false, false, null, 0, 0, 0, null);

    /// <summary>Whether the problem is that the file was deleted while it was written.</summary>
    [JsonIgnore]
    public bool IsDeletedWhileWritten { get; init; }
}
