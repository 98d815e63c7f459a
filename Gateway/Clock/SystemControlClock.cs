namespace Nowpose.Gateway.Clock;

/// <summary>The system clock (CLOCK_REALTIME) as the control clock: Unix time, including all corrections of the system clock.</summary>
/// <remarks>
/// For cells whose sources stamp their samples with a system time that NTP or PTP synchronises. To headsets, a correction is a step of the
/// control clock.
/// </remarks>
/// <param name="system">The system clock; null for the one of this machine.</param>
public sealed class SystemControlClock(TimeProvider system = null) : IControlClock
{
    readonly TimeProvider _system = system ?? TimeProvider.System;

    public ControlTime Now => new(_system.GetUtcNow().UtcDateTime - DateTime.UnixEpoch);

    public TimeSpan Resolution => new(1);
}
