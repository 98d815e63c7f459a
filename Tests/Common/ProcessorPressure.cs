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
}
