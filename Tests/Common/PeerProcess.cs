using System.Collections.Concurrent;
using System.Diagnostics;

namespace Nowpose.Tests.Common;

/// <summary>Starts a second process that acts as another machine, and collects its output lines. Disposal kills the process.</summary>
sealed class PeerProcess : IDisposable
{
    // Disposal kills a program that has not ended by then.
    static readonly TimeSpan EndLimit = TimeSpan.FromSeconds(10);

    /// <summary>
    /// Settings of the .NET runtime, as in test projects (Directory.Build.targets). Most programs run for a few seconds. In this time, optimised code
    /// does not regain the time of its compilation. The runtime reads numbers as hexadecimal.
    /// </summary>
    static readonly (string Name, string Value)[] Runtime = [("DOTNET_TieredPGO", "0"), ("DOTNET_TC_CallCountThreshold", "1388")];

    readonly Process _process;
    readonly ConcurrentQueue<string> _lines = [];

    /// <param name="assembly">File name of the program's assembly in the folder of the test assembly.</param>
    public PeerProcess(string assembly, params string[] arguments)
        : this(new ProcessStartInfo("dotnet", [Path.Combine(AppContext.BaseDirectory, assembly), .. arguments])) { }

    PeerProcess(ProcessStartInfo start)
    {
        start.RedirectStandardInput = start.RedirectStandardOutput = start.RedirectStandardError = true;
        foreach (var (name, value) in Runtime) start.Environment[name] = value;
        _process = new Process { StartInfo = start };
        _process.OutputDataReceived += (_, line) => Add(line.Data);
        _process.ErrorDataReceived += (_, line) => Add(line.Data);
        using (DefaultSignals.Restore()) _process.Start();
        _process.BeginOutputReadLine();
        _process.BeginErrorReadLine();
    }

    /// <summary>Starts a program with Node.js.</summary>
    /// <param name="script">Path of the script relative to the repository.</param>
    public static PeerProcess OfNode(string script, params string[] arguments) =>
        new(new ProcessStartInfo("node", [Path.Combine(RepositoryFiles.Root, script), .. arguments]));

    /// <summary>Runs a command line in the shell.</summary>
    public static PeerProcess OfShell(string command) => new(new ProcessStartInfo("sh", ["-c", command]));

    /// <summary>Waits until the process ends.</summary>
    /// <returns>The exit status.</returns>
    public async Task<int> EndsAsync()
    {
        await _process.WaitForExitAsync().Bounded();
        return _process.ExitCode;
    }

    public int Id => _process.Id;

    /// <summary>Returns the value of the newest line "key value"; null if there is none.</summary>
    public string ValueOf(string key) => _lines.LastOrDefault(line => line.StartsWith(key + " ", StringComparison.Ordinal))?[(key.Length + 1)..];

    /// <summary>Waits until the process has printed the given text.</summary>
    public Task PrintsAsync(string words) => Soon.BecomesAsync(() => Printed(words) || _process.HasExited && !Printed(words) && Fail(words), words);

    /// <summary>Gets the lines that the process has printed so far on both streams.</summary>
    public IReadOnlyCollection<string> Lines => _lines;

    public string All => string.Join('\n', _lines);

    public void Send(string line) => _process.StandardInput.WriteLine(line);

    /// <summary>Closes the input of a program that then ends, and waits for its end.</summary>
    public void CloseInput()
    {
        _process.StandardInput.Close();
        _process.WaitForExit(EndLimit);
    }

    public bool Printed(string words) => _lines.Any(line => line.Contains(words));

    /// <summary>Sends the signal of Ctrl-C and waits until the process ends.</summary>
    /// <returns>The exit status.</returns>
    public Task<int> InterruptAsync() => SignalAsync("INT");

    /// <summary>Sends a signal, named without SIG, and waits until the process ends.</summary>
    /// <returns>The exit status.</returns>
    public async Task<int> SignalAsync(string signal)
    {
        using var kill = Process.Start("kill", [$"-{signal}", _process.Id.ToString()]);
        await _process.WaitForExitAsync().Bounded();
        return _process.ExitCode;
    }

    public void Dispose()
    {
        // Kills the process. The peer cannot distinguish this from a headset that loses power.
        _process.Kill(entireProcessTree: true);
        _process.WaitForExit();
        _process.Dispose();
    }

    bool Fail(string words) => throw new InvalidOperationException($"ended with status {_process.ExitCode} before it printed '{words}':\n{All}");

    void Add(string line)
    {
        if (line != null) _lines.Enqueue(line);
    }
}
