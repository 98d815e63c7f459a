namespace Nowpose.Gateway.Clock;

/// <summary>The system clock (CLOCK_REALTIME) as the control clock: Unix time, with every correction that is made to it.</summary>
/// <remarks>For cells whose sources stamp with a system time that NTP or PTP keeps. Headsets see a correction as a step of the control clock.</remarks>
public sealed class SystemControlClock : IControlClock
{
    public ControlTime Now => new(DateTime.UtcNow - DateTime.UnixEpoch);

    public TimeSpan Resolution => new(1);
}
