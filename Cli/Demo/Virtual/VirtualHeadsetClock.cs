namespace Nowpose.Cli.Demo.Virtual;

/// <summary>A headset clock that is set. Each reading advances it by a microsecond, like some work.</summary>
sealed class VirtualHeadsetClock : IHeadsetClock
{
    static readonly TimeSpan Work = TimeSpan.FromMicroseconds(1);

    public HeadsetTime Now => Read += Work;

    /// <summary>The time of the last reading.</summary>
    public HeadsetTime Read { get; private set; }

    public void Set(HeadsetTime time) => Read = time;
}
