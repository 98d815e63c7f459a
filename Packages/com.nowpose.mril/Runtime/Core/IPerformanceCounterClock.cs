namespace Nowpose
{
    /// <summary>A headset clock that runs with <see cref="System.Diagnostics.Stopwatch"/>: its readings can be converted to headset time.</summary>
    public interface IPerformanceCounterClock : IHeadsetClock
    {
        /// <summary>Converts a reading of <see cref="System.Diagnostics.Stopwatch.GetTimestamp"/> to headset time.</summary>
        /// <param name="count">
        /// At <see cref="System.Diagnostics.Stopwatch.Frequency"/>. Under Mono and IL2CPP that is 10 MHz on every device:
        /// counts of QueryPerformanceCounter have another frequency.
        /// </param>
        HeadsetTime At(long count);
    }
}
