namespace Nowpose.Cli.Demo.Virtual;

/// <summary>A headset clock for virtual time. Each reading advances it by 1 µs to simulate the time that code takes.</summary>
sealed class VirtualHeadsetClock : IHeadsetClock
{
    static readonly TimeSpan Work = TimeSpan.FromMicroseconds(1);

    public HeadsetTime Now => Read += Work;

    /// <summary>The time of the last reading, or the time that was set since.</summary>
    public HeadsetTime Read { get; private set; }

    public void Set(HeadsetTime time) => Read = time;
}
