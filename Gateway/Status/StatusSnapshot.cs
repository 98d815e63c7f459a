using System.Text.Json.Nodes;
using System.Text.Json.Serialization;
using Nowpose.Gateway.Status.Events;
using Nowpose.Gateway.Status.Joints;

namespace Nowpose.Gateway.Status;

/// <summary>
/// The state of a gateway at an instant. /operations/state returns it as JSON with names in snake case, in the order of the properties. The name of a
/// quantity ends with its unit.
/// </summary>
sealed record StatusSnapshot
{
    public required string Cell { get; init; }
    public required string Host { get; init; }
    public required string Version { get; init; }
    public required OverallStatus Status { get; init; }
    public required string StartedUtc { get; init; }
    public required double UptimeS { get; init; }

    /// <summary>Current time of the control clock.</summary>
    public required double ControlTimeS { get; init; }

    public required ClockStatus Clock { get; init; }
    public required IReadOnlyList<PlantClockView> PlantClocks { get; init; }

    /// <summary>The latest diagnostics of each adapter, with their age.</summary>
    public required IReadOnlyList<JsonObject> Adapters { get; init; }

    public required IReadOnlyList<SourceStatus> Sources { get; init; }
    public required IReadOnlyList<JointView> Joints { get; init; }
    public required IReadOnlyList<FrameView> Frames { get; init; }
    public required IReadOnlyList<SignalView> Signals { get; init; }

    /// <summary>The latest diagnostics of each headset, with their age and the latency budget.</summary>
    public required IReadOnlyList<JsonObject> Headsets { get; init; }

    public required SpanStatus ForwardMs { get; init; }
    public required IReadOnlyDictionary<string, ConnectionStatus> Connections { get; init; }

    /// <summary>Number of forwarded messages by topic.</summary>
    public required IReadOnlyDictionary<string, long> Messages { get; init; }

    /// <summary>Number of dropped messages by reason.</summary>
    public required IReadOnlyDictionary<string, long> Drops { get; init; }

    public required RecordingStatus Recording { get; init; }
    public required bool PairsHeadsets { get; init; }
    public required bool IsReady { get; init; }
    public required IReadOnlyList<EventView> Events { get; init; }

    /// <summary>Role of the requesting client.</summary>
    public string Role { get; init; }

    /// <summary>Whether the requesting client is a browser that has logged in, so that it can log out.</summary>
    public bool IsLoggedIn { get; init; }

    /// <summary>Expiry of the certificate, after which headsets refuse it; null without TLS.</summary>
    public DateTime? CertificateExpiresUtc { get; init; }
}

/// <summary>The state of one joint of one source.</summary>
/// <param name="Source">Name of the adapter; "gateway" for the gateway's own robot, "rosbridge" for another client.</param>
/// <param name="State">live, rest, stale, refused, fault or missing.</param>
/// <param name="AgeS">Control time minus the newest sample's stamp; null before the first sample.</param>
/// <param name="Reason">The reason for the state as one sentence; empty for a live joint.</param>
/// <param name="Uncertain">The reason why a joint in the state rest may not be at rest; null if there is none.</param>
/// <param name="ReasonWord">One of <see cref="JointFaultReasons"/>; null for a joint that is live or at rest.</param>
/// <param name="Robot">Namespace of the robot; empty for a robot without one, null before the first sample.</param>
sealed record JointView(
    string Name, string Source, string State, string SinceUtc, double? AgeS, double RateHz, string Reason, string Uncertain = null,
    string ReasonWord = null, string Robot = null);

/// <summary>The state of one frame.</summary>
/// <param name="Source">Source of the frame, named like the source of a joint.</param>
/// <param name="Parent">Parent frame; null before the first pose.</param>
/// <param name="State">
/// stationary; live; stale: no pose for a second; orphan: its parents reach neither the world nor a link of a described robot; parent-stale: one of
/// its parents is not current; or the state that its adapter reports: refused, fault or missing.
/// </param>
/// <param name="AgeS">Control time minus the newest pose's stamp; null for a stationary frame, and before the first pose.</param>
/// <param name="Reason">The reason for the state; null for a frame that is live or stationary.</param>
sealed record FrameView(string Name, string Parent, string Source, string State, double? AgeS, string Reason = null)
{
    /// <summary>Start of the state; null for a frame that is live or stationary.</summary>
    [JsonIgnore]
    public DateTimeOffset? Since { get; init; }

    /// <summary>Time since the state of a frame with a pose was first detected. Unlike <see cref="Since"/>, it does not depend on the system clock.</summary>
    [JsonIgnore]
    public TimeSpan KnownFor { get; init; }

    /// <summary>Whether the frame is stale because its adapter sends only changes and assumes the frame at rest.</summary>
    [JsonIgnore]
    public bool IsAtRest { get; init; }

    /// <summary>The frame that makes this frame an orphan: the missing parent, or the orphan above this frame; null for a frame in another state.</summary>
    [JsonIgnore]
    public string Cause { get; init; }

    public string SinceUtc => Since is { } since ? UtcText.Of(since) : null;
}

/// <summary>The state of one signal.</summary>
/// <param name="Source">Source of the signal, named like the source of a joint.</param>
/// <param name="Value">Current value; null before the first value.</param>
/// <param name="State">live; stale: its adapter has stopped reporting; ended: its source has ended; or the state that its adapter reports: refused, fault or missing.</param>
/// <param name="AgeS">Control time minus the stamp of the message that changed the value; null before the first value.</param>
/// <param name="Reason">The reason for the state; null for a live signal.</param>
sealed record SignalView(string Name, double? Value, string Source, string State, double? AgeS, string Reason = null)
{
    /// <summary>Start of the state; null for a live signal.</summary>
    [JsonIgnore]
    public DateTimeOffset? Since { get; init; }

    public string SinceUtc => Since is { } since ? UtcText.Of(since) : null;
}

/// <summary>The state of the control clock. Values are null while unknown.</summary>
/// <param name="Source">Name of the plant clock that is served; "own" for the gateway's own clock.</param>
/// <param name="State">unsynchronised, converging, coarse, synchronised or holdover.</param>
/// <param name="IsServed">Whether the gateway serves the clock to headsets as synchronised.</param>
/// <param name="ErrorBoundUs">Error bound of the clock.</param>
/// <param name="EstimatedErrorUs">Estimated maximum error in either direction; null for the gateway's own clock.</param>
/// <param name="SkewPpm">Rate of the clock relative to the gateway's counter, minus one.</param>
/// <param name="Warning">Message about a contradiction between the clock and the stamps of sources, with a remedy; null if there is none.</param>
sealed record ClockStatus(
    string Source, string State, bool IsServed, double? ErrorBoundUs, double? SkewPpm, double? RttMs, double? ResolutionUs, long? Steps,
    double? EstimatedErrorUs = null, string Warning = null);

/// <summary>The state of one clock of the plant. Values are null while unknown, because 0 would look like the best possible value.</summary>
/// <param name="OffsetToControlMs">Time of this clock minus the time of the control clock.</param>
/// <param name="SkewPpm">Rate of this clock relative to the control clock, minus one.</param>
/// <param name="RttMs">Round-trip time of an exchange.</param>
/// <param name="EstimatedErrorUs">Estimated maximum error in either direction.</param>
sealed record PlantClockView(
    string Name, bool Connected, bool IsControlClock, string State, double? OffsetToControlMs, double? SkewPpm, double? RttMs, double? ErrorBoundUs,
    double? ResolutionUs, long Exchanges, long Failures, string LastFailure, double? EstimatedErrorUs = null)
{
    /// <summary>Former name of <see cref="SkewPpm"/>, for programs that still read it.</summary>
    public double? DriftPpm => SkewPpm;
}

/// <summary>The samples of one source.</summary>
/// <param name="Joints">Joints that are published together, or in messages that have joints in common.</param>
/// <param name="RateHz">Messages per second.</param>
/// <param name="AgeMs">C1 at the gateway minus t_k.</param>
/// <param name="BeyondLimits">Joints whose published position is beyond the limits of the described robot.</param>
sealed record SourceStatus(IReadOnlyList<string> Joints, double RateHz, AgeStatus AgeMs, IReadOnlyList<string> BeyondLimits);

sealed record AgeStatus(double P50, double P95);

/// <summary>Percentiles of the time from a sample's receipt until it is written to a subscriber's socket, over the last minute.</summary>
sealed record SpanStatus(double P50, double P99);

/// <summary>The connections of one server.</summary>
/// <param name="Closures">Number of ended connections by reason.</param>
sealed record ConnectionStatus(int Open, long Accepted, IReadOnlyDictionary<string, long> Closures);

/// <summary>The state of the recorder.</summary>
/// <param name="Can">Whether a folder for recordings is configured.</param>
/// <param name="File">Name of the current or last file, without the folder.</param>
/// <param name="Lines">Number of lines of all files of the recording. The same applies to <paramref name="Bytes"/> and <paramref name="Lost"/>.</param>
/// <param name="Lost">Number of missing lines.</param>
/// <param name="Problem">The error that ended the recording; null if there is none.</param>
/// <param name="Deleted">Whether the newest recording has ended and a user has deleted its file afterwards.</param>
/// <param name="Files">Number of files since the recorder was enabled.</param>
sealed record RecordingStatus(bool Can, bool On, string File, long Lines, long Bytes, long Lost, string Problem, bool Deleted = false, int Files = 0)
{
    public static readonly RecordingStatus None = new(false, false, null, 0, 0, 0, null);

    /// <summary>Whether a user deleted the file while it was being written, which is then the <see cref="Problem"/>.</summary>
    [JsonIgnore]
    public bool IsDeletedWhileWritten { get; init; }
}
