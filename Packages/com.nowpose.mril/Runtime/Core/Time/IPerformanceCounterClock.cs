namespace Nowpose
{
    /// <summary>A headset clock that is the device's performance counter: times that others read off that counter can be brought to it.</summary>
    public interface IPerformanceCounterClock : IHeadsetClock
    {
        /// <summary>
        /// The headset time of a count of the counter that <see cref="System.Diagnostics.Stopwatch.GetTimestamp"/> reads (on
        /// Windows: QPC).
        /// </summary>
        HeadsetTime At(long count);
    }
}
