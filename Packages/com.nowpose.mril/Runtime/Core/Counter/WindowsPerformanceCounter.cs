using System;
using System.Runtime.InteropServices;

namespace Nowpose.Counter
{
    /// <summary>The unscaled performance counter of Windows.</summary>
    sealed class WindowsPerformanceCounter : ICounter
    {
        // A UWP app cannot load a system library by name: the call would throw DllNotFoundException. With "__Internal", the linker of the build
        // resolves the function, which IL2CPP itself uses.
#if UNITY_WSA && !UNITY_EDITOR
        const string Library = "__Internal";
#else
        const string Library = "kernel32.dll";
#endif

        /// <exception cref="TypeLoadException">The platform is not Windows: kernel32 or its functions are missing.</exception>
        public WindowsPerformanceCounter() => Frequency = QueryPerformanceFrequency(out var frequency) ? frequency : 0;

        public long Frequency { get; }

        public long Read() => QueryPerformanceCounter(out var count) ? count : 0;

        [DllImport(Library, ExactSpelling = true)]
        [return: MarshalAs(UnmanagedType.Bool)]
        static extern bool QueryPerformanceFrequency(out long frequency);

        [DllImport(Library, ExactSpelling = true)]
        [return: MarshalAs(UnmanagedType.Bool)]
        static extern bool QueryPerformanceCounter(out long count);
    }
}
