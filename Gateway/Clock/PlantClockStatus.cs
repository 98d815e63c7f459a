namespace Nowpose.Gateway.Clock;

/// <summary>The status of one clock of the control system, as shown to users.</summary>
/// <param name="OffsetToControl">Time of this clock minus C1 at the same instant; null while either is unknown.</param>
/// <param name="SkewPpm">Rate of this clock relative to C1, minus one, in ppm; null while either is unknown.</param>
/// <param name="EstimatedError">
/// Estimated maximum error, in either direction, of this clock's time as computed on this machine; null while unknown.
/// </param>
/// <param name="ErrorBound">Bound of the error of this clock's time as computed on this machine.</param>
/// <param name="Exchanges">Number of usable exchanges since the gateway started.</param>
/// <param name="Failures">Number of requests without a usable response since the gateway started.</param>
/// <param name="LastFailure">The reason for the newest failure; null if there is none.</param>
/// <param name="WrongRate">See <see cref="PlantClock.WrongRate"/>.</param>
public sealed record PlantClockStatus(
    string Name, bool IsConnected, bool IsControlClock, ClockState State, TimeSpan? OffsetToControl, double? SkewPpm,
    TimeSpan RoundTripTime, TimeSpan? EstimatedError, TimeSpan ErrorBound, TimeSpan Resolution, long Exchanges, long Failures, string LastFailure,
    double? WrongRate);
