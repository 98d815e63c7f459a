using System.Globalization;

namespace Nowpose.Tests.Common;

/// <summary>Reads how long tasks of this machine have waited for a processor, as the Linux kernel counts it.</summary>
static class ProcessorPressure
{
    const string File = "/proc/pressure/cpu";

    /// <summary>
    /// Returns the time since the start of the machine in which at least one task waited for a processor; null if the kernel does not
    /// count it.
    /// </summary>
    public static TimeSpan? Waited()
    {
        if (!System.IO.File.Exists(File)) return null;
        var some = System.IO.File.ReadLines(File).First(line => line.StartsWith("some ", StringComparison.Ordinal));
        return TimeSpan.FromMicroseconds(long.Parse(some[(some.LastIndexOf('=') + 1)..], CultureInfo.InvariantCulture));
    }
}
