using System.Collections.Concurrent;
using System.Diagnostics;

namespace Nowpose.Headless.Tests;

/// <summary>A second process, as from another machine, with its lines; ended with the test whatever happens.</summary>
sealed class PeerProcess : IDisposable
{
    readonly Process _process;
    readonly ConcurrentQueue<string> _lines = [];

    /// <param name="assembly">File name of the program, beside the tests.</param>
    public PeerProcess(string assembly, params string[] arguments)
    {
        var start = new ProcessStartInfo("dotnet") { RedirectStandardInput = true, RedirectStandardOutput = true, RedirectStandardError = true };
        start.ArgumentList.Add(Path.Combine(AppContext.BaseDirectory, assembly));
        foreach (var argument in arguments) start.ArgumentList.Add(argument);
        _process = new Process { StartInfo = start };
        _process.OutputDataReceived += (_, line) => Add(line.Data);
        _process.ErrorDataReceived += (_, line) => Add(line.Data);
        _process.Start();
        _process.BeginOutputReadLine();
        _process.BeginErrorReadLine();
    }

    /// <summary>What it printed so far, on either stream.</summary>
    public IReadOnlyCollection<string> Lines => _lines;

    public string All => string.Join('\n', _lines);

    public void Send(string line) => _process.StandardInput.WriteLine(line);

    public bool Printed(string words) => _lines.Any(line => line.Contains(words));

    /// <summary>Sends what Ctrl-C sends, and waits for the end.</summary>
    /// <returns>The exit status.</returns>
    public async Task<int> InterruptAsync()
    {
        using var kill = Process.Start("kill", ["-INT", _process.Id.ToString()]);
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

    void Add(string line)
    {
        if (line != null) _lines.Enqueue(line);
    }
}
