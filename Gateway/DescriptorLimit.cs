using System.Net.Sockets;
using System.Runtime.InteropServices;

namespace Nowpose.Gateway;

/// <summary>Compares the number of files and sockets that the system allows this process with the number that its connections need.</summary>
/// <remarks>The .NET runtime raises the soft limit to the hard one when it starts.</remarks>
static class DescriptorLimit
{
    /// <summary>
    /// Number of descriptors that the process needs besides its connections: 155 after the start, plus a margin for adapters, files and pages.
    /// </summary>
    internal const int Reserve = 250;

    /// <summary>Number of descriptors that connections must leave free.</summary>
    const ulong Spare = 32;

    const int LinuxOpenFiles = 7;
    const int MacOpenFiles = 8;

    /// <exception cref="InputException">The system's limit is too low.</exception>
    public static void Check(int maxConnections)
    {
        if (Problem(maxConnections, Allowed()) is { } problem) throw new InputException(problem);
    }

    /// <summary>Refuses a connection that uses one of the last descriptors.</summary>
    /// <remarks>The .NET runtime needs descriptors to start a thread, and ends the process if it cannot start one.</remarks>
    /// <exception cref="SocketException">Too few descriptors are left. The connection is closed.</exception>
    public static void Guard(Socket accepted) => Guard(accepted, Allowed());

    /// <inheritdoc cref="Guard(Socket)"/>
    /// <param name="allowed">The system's limit.</param>
    internal static void Guard(Socket accepted, ulong allowed)
    {
        // The system assigns the lowest free number, so a high number means that few are left.
        var number = (ulong)(long)accepted.Handle;
        if (OperatingSystem.IsWindows() || number + Spare < allowed) return;
        accepted.Dispose();
        throw new SocketException((int)SocketError.TooManyOpenSockets, LimitMessages.NoDescriptor(number, allowed, Spare));
    }

    /// <summary>Whether a connection could not be accepted because too few descriptors are left in the process or in the system.</summary>
    public static bool IsReached(Exception e) => e is SocketException { SocketErrorCode: SocketError.TooManyOpenSockets };

    /// <returns>The message about a limit that is too low; null if the limit is high enough.</returns>
    internal static string Problem(int maxConnections, ulong allowed)
    {
        var needed = Reserve + (2L * maxConnections);
        if (allowed >= (ulong)needed) return null;
        var possible = ((long)allowed - Reserve) / 2;
        return LimitMessages.TooFewDescriptors(maxConnections, needed, allowed, possible);
    }

    /// <summary>Gets the system's limit; <see cref="ulong.MaxValue"/> if there is none or it cannot be read.</summary>
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
