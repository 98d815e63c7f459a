namespace Nowpose
{
    /// <summary>The headset clock C2. Never jumps, never goes back; may be read from any thread.</summary>
    public interface IHeadsetClock
    {
        HeadsetTime Now { get; }
    }
}
