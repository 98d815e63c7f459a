using System;
using System.Runtime.InteropServices;

namespace Nowpose.Counter
{
    /// <summary>The unscaled performance counter of Windows. UWP apps may call QueryPerformanceCounter and QueryPerformanceFrequency.</summary>
    sealed class WindowsPerformanceCounter : ICounter
    {
        /// <exception cref="TypeLoadException">The platform is not Windows: kernel32 or its functions are missing.</exception>
        public WindowsPerformanceCounter() => Frequency = QueryPerformanceFrequency(out var frequency) ? frequency : 0;

        public long Frequency { get; }

        public long Read() => QueryPerformanceCounter(out var count) ? count : 0;

        [DllImport("kernel32.dll", ExactSpelling = true)]
        [return: MarshalAs(UnmanagedType.Bool)]
        static extern bool QueryPerformanceFrequency(out long frequency);

        [DllImport("kernel32.dll", ExactSpelling = true)]
        [return: MarshalAs(UnmanagedType.Bool)]
        static extern bool QueryPerformanceCounter(out long count);
    }
}
