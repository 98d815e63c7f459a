using System.Runtime.InteropServices;

namespace Nowpose.Benchmarks.Cell;

/// <summary>Measures the CPU time of the calling thread. Other programs affect it less than elapsed time. Supported on Linux only.</summary>
static class ThreadTime
{
    const int ThreadCpuTime = 3; // CLOCK_THREAD_CPUTIME_ID

    /// <summary>Gets the CPU time since the start of the thread, s.</summary>
    public static double Seconds
    {
        get
        {
            if (clock_gettime(ThreadCpuTime, out var time) != 0)
                throw new InvalidOperationException($"clock_gettime failed with error {Marshal.GetLastPInvokeError()}");
            return time.Seconds + time.Nanoseconds * 1e-9;
        }
    }

    [DllImport("libc", SetLastError = true)]
    static extern int clock_gettime(int clock, out TimeSpec time);

    [StructLayout(LayoutKind.Sequential)]
    struct TimeSpec
    {
        public nint Seconds;
        public nint Nanoseconds;
    }
}
