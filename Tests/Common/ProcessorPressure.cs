using System.Globalization;

namespace Nowpose.Tests.Common;

/// <summary>Time in which at least one task of this machine waited for a processor, as the Linux kernel counts it.</summary>
static class ProcessorPressure
{
    const string File = "/proc/pressure/cpu";

    /// <summary>Gets that time since the start of the machine; null where the kernel does not count it.</summary>
    public static TimeSpan? Waited()
    {
        if (!System.IO.File.Exists(File)) return null;
        var some = System.IO.File.ReadLines(File).First(line => line.StartsWith("some ", StringComparison.Ordinal));
        return TimeSpan.FromMicroseconds(long.Parse(some[(some.LastIndexOf('=') + 1)..], CultureInfo.InvariantCulture));
    }
}
