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

    /// <summary>Starts to measure a time that does not depend on the load of the machine.</summary>
    /// <returns>
    /// A function that returns the time since the start, without the time during which a task of this machine waited for a processor; null if the
    /// kernel does not measure that time.
    /// </returns>
    public static Func<TimeSpan?> StartWatch()
    {
        var (since, before) = (Stopwatch.GetTimestamp(), Waited());
        return () =>
        {
            // Reads the waiting time last, so that a pause between the readings cannot lengthen the result.
            var elapsed = Stopwatch.GetElapsedTime(since);
            return elapsed - (Waited() - before);
        };
    }
}
