using System.Collections.Concurrent;
using System.Diagnostics;

namespace Nowpose.Tests.Common;

/// <summary>A second process, as from another machine, with its lines; ended with the test whatever happens.</summary>
sealed class PeerProcess : IDisposable
{
    readonly Process _process;
    readonly ConcurrentQueue<string> _lines = [];

    /// <param name="assembly">File name of the program, beside the tests.</param>
    public PeerProcess(string assembly, params string[] arguments)
        : this(new ProcessStartInfo("dotnet", [Path.Combine(AppContext.BaseDirectory, assembly), .. arguments])) { }

    PeerProcess(ProcessStartInfo start)
    {
        start.RedirectStandardInput = start.RedirectStandardOutput = start.RedirectStandardError = true;
        _process = new Process { StartInfo = start };
        _process.OutputDataReceived += (_, line) => Add(line.Data);
        _process.ErrorDataReceived += (_, line) => Add(line.Data);
        using (DefaultSignals.Restore()) _process.Start();
        _process.BeginOutputReadLine();
        _process.BeginErrorReadLine();
    }

    /// <summary>A program of Node.js.</summary>
    /// <param name="script">Its path below the repository.</param>
    public static PeerProcess OfNode(string script, params string[] arguments) =>
        new(new ProcessStartInfo("node", [Path.Combine(RepositoryFiles.Root, script), .. arguments]));

    /// <summary>A command line of the shell.</summary>
    public static PeerProcess OfShell(string command) => new(new ProcessStartInfo("sh", ["-c", command]));

    /// <summary>Waits for the end.</summary>
    /// <returns>The exit status.</returns>
    public async Task<int> EndsAsync()
    {
        await _process.WaitForExitAsync().Bounded();
        return _process.ExitCode;
    }

    public int Id => _process.Id;

    /// <summary>Of the newest line "key value"; null without one.</summary>
    public string ValueOf(string key) => _lines.LastOrDefault(line => line.StartsWith(key + " ", StringComparison.Ordinal))?[(key.Length + 1)..];

    /// <summary>Waits until it has printed this.</summary>
    public Task PrintsAsync(string words) => Soon.BecomesAsync(() => Printed(words) || _process.HasExited && !Printed(words) && Fail(words), words);

    /// <summary>What it printed so far, on either stream.</summary>
    public IReadOnlyCollection<string> Lines => _lines;

    public string All => string.Join('\n', _lines);

    public void Send(string line) => _process.StandardInput.WriteLine(line);

    public bool Printed(string words) => _lines.Any(line => line.Contains(words));

    /// <summary>Sends what Ctrl-C sends, and waits for the end.</summary>
    /// <returns>The exit status.</returns>
    public Task<int> InterruptAsync() => SignalAsync("INT");

    /// <summary>Sends a signal by its name without SIG, and waits for the end.</summary>
    /// <returns>The exit status.</returns>
    public async Task<int> SignalAsync(string signal)
    {
        using var kill = Process.Start("kill", [$"-{signal}", _process.Id.ToString()]);
        await _process.WaitForExitAsync().Bounded();
        return _process.ExitCode;
    }

    public void Dispose()
    {
        // Ends at once, as a headset that lost its power.
        _process.Kill(entireProcessTree: true);
        _process.WaitForExit();
        _process.Dispose();
    }

    bool Fail(string words) => throw new InvalidOperationException($"ended with status {_process.ExitCode} before it said '{words}':\n{All}");

    void Add(string line)
    {
        if (line != null) _lines.Enqueue(line);
    }
}
