namespace Nowpose
{
    /// <summary>A headset clock based on <see cref="System.Diagnostics.Stopwatch"/>, whose readings convert to headset time.</summary>
    public interface IPerformanceCounterClock : IHeadsetClock
    {
        /// <summary>Converts a reading of <see cref="System.Diagnostics.Stopwatch.GetTimestamp"/> to headset time.</summary>
        /// <param name="count">
        /// Reading in counts of <see cref="System.Diagnostics.Stopwatch.Frequency"/>. Under Mono and IL2CPP that is 10 MHz on every
        /// device; counts of QueryPerformanceCounter have another frequency.
        /// </param>
        HeadsetTime At(long count);
    }
}
