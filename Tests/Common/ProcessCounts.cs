using System.Diagnostics;

namespace Nowpose.Tests.Common;

/// <summary>Counts the threads and open files of this process. Fixtures that use it are marked NonParallelizable.</summary>
static class ProcessCounts
{
    public static int Threads()
    {
        using var process = Process.GetCurrentProcess();
        return process.Threads.Count;
    }

    /// <summary>Number of open files and sockets; 0 on other systems than Linux.</summary>
    public static int OpenFiles() => OperatingSystem.IsLinux() ? Directory.GetFiles("/proc/self/fd").Length : 0;
}
