using System.Diagnostics;
using System.Globalization;
using System.Net;

namespace Nowpose.Benchmarks;

/// <summary>A gateway with a simulated robot in a separate process.</summary>
sealed class GatewayProcess : IDisposable
{
    static readonly TimeSpan StartTimeout = TimeSpan.FromSeconds(60);

    /// <summary>Path of the gateway that was built together with this program.</summary>
    public static readonly string OwnProgram = Path.Combine(AppContext.BaseDirectory, "Nowpose.Gateway.dll");

    readonly Process _process;
    readonly Dictionary<string, string> _values = [];

    GatewayProcess(Process process) => _process = process;

    /// <summary>Gets the value of a line "key value" that the gateway printed when it started.</summary>
    public string this[string key] => _values.TryGetValue(key, out var value)
        ? value : throw new InputException($"the gateway printed no line '{key}'");

    public IPEndPoint Sync => IPEndPoint.Parse(this["sync"]);
    public IPEndPoint WebSocket => IPEndPoint.Parse(new Uri(this["websocket"]).Authority);

    /// <summary>Resident memory of the process, bytes.</summary>
    public long ResidentBytes => Refreshed.WorkingSet64;

    public TimeSpan ProcessorTime => Refreshed.TotalProcessorTime;

    Process Refreshed
    {
        get
        {
            _process.Refresh();
            return _process;
        }
    }

    /// <summary>Starts a gateway on free ports, which sends each sample at the time of its time stamp.</summary>
    /// <param name="connections">Maximum number of connections on each port.</param>
    /// <param name="program">Path of Nowpose.Gateway.dll; null for <see cref="OwnProgram"/>.</param>
    public static Task<GatewayProcess> StartAsync(double rateHz, int connections, string program = null)
    {
        var start = new ProcessStartInfo("dotnet",
        [
            program ?? OwnProgram, "simulate", "--sync-port", "0", "--ws-port", "0",
            "--sampling-ms", (1000 / rateHz).ToString(CultureInfo.InvariantCulture), "--acquisition-ms", "0",
            "--max-connections", connections.ToString(CultureInfo.InvariantCulture),
        ]);
        // The systemd unit and the container set this, too. With a single arena, all threads can reuse freed memory.
        start.Environment["MALLOC_ARENA_MAX"] = "1";
        return StartAsync(start);
    }

    /// <param name="start">The command that starts the gateway. Its error output appears in the terminal unless the command redirects it.</param>
    /// <exception cref="InputException">The gateway ended before it was ready.</exception>
    public static async Task<GatewayProcess> StartAsync(ProcessStartInfo start, CancellationToken stop = default)
    {
        start.RedirectStandardOutput = true;
        var gateway = new GatewayProcess(Process.Start(start));
        try
        {
            // Reads the streams all the time, because a full pipe would block the gateway.
            var errors = start.RedirectStandardError ? gateway._process.StandardError.ReadToEndAsync(CancellationToken.None) : Task.FromResult("");
            if (!await gateway.ReadAsync().WaitAsync(StartTimeout, stop))
                throw new InputException("the gateway ended before it was ready: " + (await errors).ReplaceLineEndings(" "));
            _ = gateway._process.StandardOutput.ReadToEndAsync(CancellationToken.None);
            return gateway;
        }
        catch
        {
            gateway.Dispose();
            throw;
        }
    }

    public void Dispose()
    {
        _process.Kill(entireProcessTree: true);
        _process.WaitForExit();
        _process.Dispose();
    }

    // Reads the lines of the start. Returns false if the gateway exited before it was ready.
    async Task<bool> ReadAsync()
    {
        while (await _process.StandardOutput.ReadLineAsync() is string line)
        {
            if (line == "state serving") return true;
            if (line.Split(' ', 2) is [var key, var value]) _values[key] = value;
        }

        return false;
    }
}
