using System.Diagnostics;
using System.Globalization;
using System.Net;

namespace Nowpose.Benchmarks.Load;

/// <summary>A gateway in a separate process with a simulated robot. Each sample is sent at the time of its time stamp.</summary>
sealed class GatewayUnderLoad : IDisposable
{
    static readonly TimeSpan StartTimeout = TimeSpan.FromSeconds(30);

    /// <summary>Path of the gateway that was built together with this program.</summary>
    public static readonly string OwnProgram = Path.Combine(AppContext.BaseDirectory, "Nowpose.Gateway.dll");

    readonly Process _process;
    readonly TaskCompletionSource _serves = new(TaskCreationOptions.RunContinuationsAsynchronously);

    GatewayUnderLoad(Process process) => _process = process;

    public IPEndPoint Sync { get; private set; }
    public IPEndPoint WebSocket { get; private set; }

    /// <summary>Resident memory of the process, bytes.</summary>
    public long ResidentBytes
    {
        get
        {
            _process.Refresh();
            return _process.WorkingSet64;
        }
    }

    public TimeSpan ProcessorTime
    {
        get
        {
            _process.Refresh();
            return _process.TotalProcessorTime;
        }
    }

    /// <param name="connections">Maximum number of connections on each port.</param>
    /// <param name="program">Path of Nowpose.Gateway.dll; null for <see cref="OwnProgram"/>.</param>
    public static async Task<GatewayUnderLoad> StartAsync(double rateHz, int connections, string program = null)
    {
        string[] arguments =
        [
            program ?? OwnProgram, "simulate", "--sync-port", "0", "--ws-port", "0",
            "--sampling-ms", (1000 / rateHz).ToString(CultureInfo.InvariantCulture), "--acquisition-ms", "0",
            "--max-connections", connections.ToString(CultureInfo.InvariantCulture),
        ];
        var start = new ProcessStartInfo("dotnet") { RedirectStandardOutput = true };
        foreach (var argument in arguments) start.ArgumentList.Add(argument);
        // The systemd unit and the container set this, too. With a single arena, all threads can reuse freed memory.
        start.Environment["MALLOC_ARENA_MAX"] = "1";
        var gateway = new GatewayUnderLoad(new Process { StartInfo = start, EnableRaisingEvents = true });
        gateway._process.OutputDataReceived += (_, line) => gateway.Take(line.Data);
        gateway._process.Exited += (_, _) => gateway._serves.TrySetException(new InputException("the gateway ended before it was ready"));
        gateway._process.Start();
        gateway._process.BeginOutputReadLine();
        try
        {
            await gateway._serves.Task.WaitAsync(StartTimeout);
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

    void Take(string line)
    {
        var words = line?.Split(' ', 2) ?? [];
        switch (words)
        {
            case ["sync", var address]: Sync = IPEndPoint.Parse(address); break;
            case ["websocket", var uri]: WebSocket = IPEndPoint.Parse(new Uri(uri).Authority); break;
            case ["state", "serving"]: _serves.TrySetResult(); break;
            default: break;
        }
    }
}
