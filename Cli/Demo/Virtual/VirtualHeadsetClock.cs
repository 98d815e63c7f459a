namespace Nowpose.Cli.Demo.Virtual;

/// <summary>A headset clock whose time is set by its owner. Each reading advances it by a microsecond, as if work had been done.</summary>
sealed class VirtualHeadsetClock : IHeadsetClock
{
    static readonly TimeSpan Work = TimeSpan.FromMicroseconds(1);

    public HeadsetTime Now => Read += Work;

    /// <summary>The time of the last reading.</summary>
    public HeadsetTime Read { get; private set; }

    public void Set(HeadsetTime time) => Read = time;
}
