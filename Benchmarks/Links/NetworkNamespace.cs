using System.Diagnostics;
using System.Globalization;
using Microsoft.Win32.SafeHandles;

namespace Nowpose.Benchmarks.Links;

/// <summary>A network namespace with one TUN device. Dispose ends the processes in the namespace and removes it.</summary>
sealed class NetworkNamespace : IDisposable
{
    const string Folder = "/run/netns";
    const string Device = "tun0";

    readonly string _name;

    NetworkNamespace(string name) => _name = name;

    public SafeFileHandle Tun { get; private set; }

    /// <param name="role">Role of the namespace, which is part of its name; unique in this process.</param>
    /// <param name="address">Address of the device with the prefix length.</param>
    public static NetworkNamespace Create(string role, string address)
    {
        var created = new NetworkNamespace(RunName.Create(role));
        Ip("netns", "add", created._name);
        try
        {
            created.Tun = RunOnNewThread(() =>
            {
                LinuxCalls.Enter(Path.Combine(Folder, created._name));
                return LinuxCalls.CreateTun(Device);
            });
            Ip("-n", created._name, "address", "add", address, "dev", Device);
            Ip("-n", created._name, "link", "set", "lo", "up");
            Ip("-n", created._name, "link", "set", Device, "up");
            return created;
        }
        catch
        {
            created.Dispose();
            throw;
        }
    }

    /// <summary>Removes the namespaces of earlier runs that were killed, and ends the processes in them.</summary>
    public static void RemoveLeftovers()
    {
        foreach (var name in RunName.Leftovers(Folder)) new NetworkNamespace(name).Dispose();
    }

    /// <summary>Gets the start information for running a program in the namespace.</summary>
    public ProcessStartInfo Inside(params string[] command) => new("ip", ["netns", "exec", _name, .. command])
    {
        RedirectStandardOutput = true, RedirectStandardError = true,
    };

    public void Dispose()
    {
        Tun?.Dispose();
        foreach (var line in Ip("netns", "pids", _name).Split('\n', StringSplitOptions.RemoveEmptyEntries))
            Kill(int.Parse(line, CultureInfo.InvariantCulture));
        Ip("netns", "delete", _name);
    }

    static void Kill(int id)
    {
        try
        {
            using var process = Process.GetProcessById(id);
            process.Kill();
            process.WaitForExit();
        }
        catch (ArgumentException)
        {
            // The process has already ended.
        }
    }

    // Runs work on a new thread. A thread stays in the namespace that it entered, so it must not be reused.
    static T RunOnNewThread<T>(Func<T> work) =>
        Task.Factory.StartNew(work, CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default).GetAwaiter().GetResult();

    static string Ip(params string[] arguments)
    {
        using var ip = Process.Start(new ProcessStartInfo("ip", arguments) { RedirectStandardOutput = true, RedirectStandardError = true });
        var errors = ip.StandardError.ReadToEndAsync();
        var output = ip.StandardOutput.ReadToEnd();
        ip.WaitForExit();
        return ip.ExitCode == 0
            ? output : throw new IOException($"ip {string.Join(' ', arguments)}: {errors.GetAwaiter().GetResult().Trim().ReplaceLineEndings(" ")}");
    }
}
