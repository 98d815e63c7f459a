namespace Nowpose.Gateway.Clock;

/// <summary>How a clock of the control system does, for people.</summary>
/// <param name="OffsetToControl">What it shows less what C1 shows at the same moment; null while either is unknown.</param>
/// <param name="DriftPpm">Its rate over that of C1, less one, ppm; null while either is unknown.</param>
/// <param name="EstimatedError">The ± of its time on this machine; null while it is unknown.</param>
/// <param name="ErrorBound">Of its time on this machine.</param>
/// <param name="Exchanges">That could be used, since the start.</param>
/// <param name="Failures">Questions that were not answered, or not usably, since the start.</param>
/// <param name="LastFailure">Why the newest of them; null without one.</param>
public sealed record PlantClockStatus(
    string Name, bool IsConnected, bool IsControlClock, ClockState State, TimeSpan? OffsetToControl, double? DriftPpm,
    TimeSpan RoundTripTime, TimeSpan? EstimatedError, TimeSpan ErrorBound, TimeSpan Resolution, long Exchanges, long Failures, string LastFailure);
