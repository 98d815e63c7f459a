using System.Diagnostics;
using System.Globalization;

namespace Nowpose.Tests.Common;

/// <summary>Reads how long tasks of this machine have waited for a processor, from the pressure stall information of the Linux kernel.</summary>
static class ProcessorPressure
{
    const string File = "/proc/pressure/cpu";

    /// <summary>
    /// Returns the total time since the start of the machine during which at least one task waited for a processor; null if the kernel does not
    /// measure it.
    /// </summary>
    public static TimeSpan? Waited()
    {
        if (!System.IO.File.Exists(File)) return null;
        var some = System.IO.File.ReadLines(File).First(line => line.StartsWith("some ", StringComparison.Ordinal));
        return TimeSpan.FromMicroseconds(long.Parse(some[(some.LastIndexOf('=') + 1)..], CultureInfo.InvariantCulture));
    }

    /// <summary>
    /// Returns the total time during which the calling thread waited for a processor or a garbage collection; null if the kernel does not measure it.
    /// </summary>
    public static TimeSpan? WaitedByThread()
    {
        const string schedule = "/proc/thread-self/schedstat";
        if (!System.IO.File.Exists(schedule)) return null;
        var nanoseconds = long.Parse(System.IO.File.ReadAllText(schedule).Split(' ')[1], CultureInfo.InvariantCulture);
        return TimeSpan.FromMicroseconds(nanoseconds / 1000.0) + GC.GetTotalPauseDuration();
    }

    /// <summary>Starts to measure a time that does not depend on the load of the machine.</summary>
    /// <param name="waited"><see cref="Waited"/>, or <see cref="WaitedByThread"/> for calls on the same thread.</param>
    /// <returns>
    /// A function that returns the time since the start, and that time without the waiting time, which is null if the kernel does not measure it.
    /// </returns>
    public static Func<(TimeSpan Elapsed, TimeSpan? WithoutWaiting)> StartWatch(Func<TimeSpan?> waited)
    {
        var (since, before) = (Stopwatch.GetTimestamp(), waited());
        return () =>
        {
            // Reads the waiting time last, so that a pause between the readings cannot lengthen the result.
            var elapsed = Stopwatch.GetElapsedTime(since);
            return (elapsed, elapsed - (waited() - before));
        };
    }
}
