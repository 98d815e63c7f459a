namespace Nowpose
{
    /// <summary>The headset clock C2. It never jumps or goes back; any thread may read it.</summary>
    public interface IHeadsetClock
    {
        HeadsetTime Now { get; }
    }
}
