using System.Runtime.InteropServices;
using Microsoft.Win32.SafeHandles;

namespace Nowpose.Benchmarks.Links;

/// <summary>Linux system calls that .NET does not provide.</summary>
static class LinuxCalls
{
    const int ReadWrite = 2, NonBlocking = 0x800, CloseOnExec = 0x80000;
    const int NetworkNamespaceType = 0x40000000;
    const nuint CreateDevice = 0x400454ca; // TUNSETIFF
    const short IpPacketsOnly = 0x0001 | 0x1000; // IFF_TUN | IFF_NO_PI
    const int TimerSlack = 29; // PR_SET_TIMERSLACK
    const short Readable = 1; // POLLIN
    const int NameLength = 16; // IFNAMSIZ
    const int FirstInFirstOut = 1; // SCHED_FIFO

    static readonly int[] RealTimePriority = [1];

    public static bool IsRoot => geteuid() == 0;

    /// <summary>Moves the calling thread to a network namespace.</summary>
    public static void Enter(string namespacePath)
    {
        using var handle = Open(namespacePath, CloseOnExec);
        Check(setns(handle, NetworkNamespaceType), "setns");
    }

    /// <summary>Creates a TUN device in the network namespace of the calling thread. The device exists until the handle is closed.</summary>
    public static SafeFileHandle CreateTun(string device)
    {
        var handle = Open("/dev/net/tun", ReadWrite | NonBlocking | CloseOnExec);
        var request = new byte[40];
        System.Text.Encoding.ASCII.GetBytes(device.AsSpan(0, Math.Min(device.Length, NameLength - 1)), request);
        BitConverter.TryWriteBytes(request.AsSpan(NameLength), IpPacketsOnly);
        if (ioctl(handle, CreateDevice, request) >= 0) return handle;
        var error = Error("ioctl TUNSETIFF");
        handle.Dispose();
        throw error;
    }

    /// <summary>Reads one packet.</summary>
    /// <returns>Length of the packet; 0 if there is none.</returns>
    public static int Read(SafeFileHandle tun, byte[] packet) => (int)Math.Max(0, read(tun, packet, (nuint)packet.Length));

    /// <returns>Whether the device accepted the packet.</returns>
    public static bool Write(SafeFileHandle tun, byte[] packet, int length) => write(tun, packet, (nuint)length) == length;

    /// <summary>Waits until a packet can be read or the timeout has expired.</summary>
    public static void WaitReadable(SafeFileHandle tun, TimeSpan timeout)
    {
        var polled = new PolledFile { File = (int)tun.DangerousGetHandle(), Events = Readable };
        var time = new UnixTime
        {
            Seconds = (nint)(timeout.Ticks / TimeSpan.TicksPerSecond), Nanoseconds = (nint)(timeout.Ticks % TimeSpan.TicksPerSecond * 100),
        };
        // If a signal interrupts the wait, it only ends early. The caller checks the time anyway.
        _ = ppoll(ref polled, 1, ref time, 0);
    }

    /// <summary>Makes timeouts of the calling thread accurate to microseconds and increases its priority.</summary>
    public static void SetAccurateTimeouts()
    {
        Check(prctl(TimerSlack, 1, 0, 0, 0), "prctl PR_SET_TIMERSLACK");
        // Errors are ignored, because a container can forbid these calls.
        if (sched_setscheduler(0, FirstInFirstOut, RealTimePriority) < 0) _ = setpriority(0, 0, -20);
    }

    static SafeFileHandle Open(string path, int flags)
    {
        var handle = open(path, flags);
        return handle.IsInvalid ? throw Error("open " + path) : handle;
    }

    static void Check(int result, string call)
    {
        if (result < 0) throw Error(call);
    }

    static IOException Error(string call) => new($"{call}: {Marshal.GetLastPInvokeErrorMessage()}");

    [DllImport("libc", SetLastError = true)]
    static extern SafeFileHandle open(string path, int flags);

    [DllImport("libc", SetLastError = true)]
    static extern int setns(SafeFileHandle file, int type);

    [DllImport("libc", SetLastError = true)]
    static extern int ioctl(SafeFileHandle file, nuint request, byte[] argument);

    [DllImport("libc", SetLastError = true)]
    static extern nint read(SafeFileHandle file, byte[] buffer, nuint count);

    [DllImport("libc", SetLastError = true)]
    static extern nint write(SafeFileHandle file, byte[] buffer, nuint count);

    [DllImport("libc", SetLastError = true)]
    static extern int ppoll(ref PolledFile files, nuint count, ref UnixTime timeout, nint signals);

    [DllImport("libc", SetLastError = true)]
    static extern int prctl(int option, nuint argument2, nuint argument3, nuint argument4, nuint argument5);

    [DllImport("libc", SetLastError = true)]
    static extern int sched_setscheduler(int thread, int policy, int[] priority);

    [DllImport("libc", SetLastError = true)]
    static extern int setpriority(int which, uint who, int priority);

    [DllImport("libc")]
    static extern uint geteuid();

    [StructLayout(LayoutKind.Sequential)]
    struct PolledFile
    {
        public int File;
        public short Events;
        public short Returned;
    }

    [StructLayout(LayoutKind.Sequential)]
    struct UnixTime
    {
        public nint Seconds;
        public nint Nanoseconds;
    }
}
