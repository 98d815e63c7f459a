using System.Net.Sockets;
using System.Runtime.InteropServices;
using Nowpose.Gateway.Messages;

namespace Nowpose.Gateway;

/// <summary>Compares the number of files and sockets that the system allows this process with the number that its connections need.</summary>
/// <remarks>The .NET runtime raises the soft limit to the hard one when it starts.</remarks>
static class DescriptorLimit
{
    /// <summary>
    /// Descriptors of the process without connections: 155 for a gateway that has just started, plus adapters, files and pages.
    /// </summary>
    internal const int Reserve = 250;

    /// <summary>Descriptors that connections must not use.</summary>
    const ulong Spare = 32;

    const int LinuxOpenFiles = 7;
    const int MacOpenFiles = 8;

    /// <exception cref="InputException">The system's limit is too low.</exception>
    public static void Check(int maxConnections)
    {
        if (Problem(maxConnections, Allowed()) is { } problem) throw new InputException(problem);
    }

    /// <summary>Refuses a connection that takes one of the last descriptors.</summary>
    /// <remarks>The .NET runtime ends the process when it cannot start a thread, and it takes descriptors to start one.</remarks>
    /// <exception cref="IOException">Too few descriptors are left. The connection is closed.</exception>
    public static void Guard(Socket accepted)
    {
        // The system assigns the lowest free number.
        var number = (ulong)(long)accepted.Handle;
        var allowed = Allowed();
        if (OperatingSystem.IsWindows() || number + Spare < allowed) return;
        accepted.Dispose();
        throw new IOException(LimitMessages.NoDescriptor(number, allowed, Spare));
    }

    /// <returns>Null when the limit is high enough.</returns>
    internal static string Problem(int maxConnections, ulong allowed)
    {
        var needed = Reserve + (2L * maxConnections);
        if (allowed >= (ulong)needed) return null;
        var possible = ((long)allowed - Reserve) / 2;
        return LimitMessages.TooFewDescriptors(maxConnections, needed, allowed, possible);
    }

    /// <summary>Gets the limit; the maximum number if the system has no limit, or none that can be read.</summary>
    static ulong Allowed()
    {
        if (OperatingSystem.IsWindows()) return ulong.MaxValue;
        var resource = OperatingSystem.IsMacOS() ? MacOpenFiles : LinuxOpenFiles;
        return ReadLimit(resource, out var limit) == 0 ? limit.Soft : ulong.MaxValue;
    }

    [DllImport("libc", EntryPoint = "getrlimit")]
    static extern int ReadLimit(int resource, out Limit limit);

    // struct rlimit of 64-bit systems.
    [StructLayout(LayoutKind.Sequential)]
    struct Limit
    {
        public ulong Soft;
        public ulong Hard;
    }
}
