using System.Globalization;
using System.Runtime.InteropServices;

namespace Nowpose.Tests.Common;

/// <summary>Restores the default action of SIGHUP and SIGINT while a test starts a program. Linux only.</summary>
/// <remarks>
/// A program that is started with nohup, or in the background by a script, ignores these signals, and so do all programs that it starts.
/// </remarks>
static class DefaultSignals
{
    const nint Default = 0, Ignored = 1;

    static readonly int[] Signals = [1, 2];
    static readonly Lock Gate = new();

    /// <summary>Restores the default action until the same thread disposes of the returned object.</summary>
    public static IDisposable Restore()
    {
        Gate.Enter();
        return new Restored();
    }

    // Returns the ignored signals. Only their action is changed, because signal() could not restore a handler of the runtime afterwards.
    static int[] FindIgnored()
    {
        const string Field = "SigIgn:";
        if (!OperatingSystem.IsLinux()) return [];
        var line = File.ReadLines("/proc/self/status").First(line => line.StartsWith(Field, StringComparison.Ordinal));
        var mask = ulong.Parse(line[Field.Length..].Trim(), NumberStyles.HexNumber, CultureInfo.InvariantCulture);
        return [.. Signals.Where(signal => (mask >> (signal - 1) & 1) != 0)];
    }

    [DllImport("libc", EntryPoint = "signal")]
    static extern nint SetReaction(int signal, nint reaction);

    sealed class Restored : IDisposable
    {
        readonly int[] _ignored = FindIgnored();

        public Restored() => Set(Default);

        public void Dispose()
        {
            Set(Ignored);
            Gate.Exit();
        }

        void Set(nint reaction)
        {
            foreach (var signal in _ignored) _ = SetReaction(signal, reaction);
        }
    }
}
