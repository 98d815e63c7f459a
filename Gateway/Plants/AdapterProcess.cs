using System.Diagnostics;
using Nowpose.Gateway.Messages;

namespace Nowpose.Gateway.Plants;

/// <summary>Keeps the program of one control system's adapter running: restarts it when it ends, and ends it with the gateway.</summary>
sealed class AdapterProcess : IAsyncDisposable
{
    static readonly TimeSpan FirstPause = TimeSpan.FromSeconds(0.5), MaxPause = TimeSpan.FromSeconds(30);

    /// <summary>Minimum run time of a successful start.</summary>
    static readonly TimeSpan Steady = TimeSpan.FromSeconds(60);

    static readonly TimeSpan TimeToEnd = TimeSpan.FromSeconds(4);

    readonly PlantFile _plant;
    readonly AdapterAccess _access;
    readonly Action<string> _log;
    readonly TimeProvider _time;
    readonly CancellationTokenSource _stop = new();
    readonly Task _running;
    volatile Process _process;
    volatile string _end;
    long _startedAt;
    int _starts;

    /// <summary>Starts the program immediately.</summary>
    /// <param name="log">Also receives the lines of the program.</param>
    public AdapterProcess(PlantFile plant, AdapterAccess access, TimeProvider time, Action<string> log)
    {
        _plant = plant;
        _access = access;
        _time = time;
        _log = log;
        _running = Task.Run(RunAsync);
    }

    /// <summary>Number of starts.</summary>
    public int Starts => Volatile.Read(ref _starts);

    public AdapterState State =>
        new(_plant.Name, _process == null ? null : _time.GetElapsedTime(Interlocked.Read(ref _startedAt)), _end);

    /// <summary>Id of the running program; null while it is not running.</summary>
    internal int? ProcessId => _process?.Id;

    public async ValueTask DisposeAsync()
    {
        await _stop.CancelAsync();
        await _running;
        _stop.Dispose();
    }

    async Task RunAsync()
    {
        var pause = FirstPause;
        while (!_stop.IsCancellationRequested)
        {
            var started = Stopwatch.GetTimestamp();
            var end = await RunOnceAsync();
            _end = end;
            _process = null;
            if (_stop.IsCancellationRequested) return;
            if (Stopwatch.GetElapsedTime(started) > Steady) pause = FirstPause;
            _log(AdapterMessages.Ended(_plant.Path, end, pause.TotalSeconds));
            await Task.Delay(pause, _stop.Token).ConfigureAwait(ConfigureAwaitOptions.SuppressThrowing);
            pause = pause * 2 < MaxPause ? pause * 2 : MaxPause;
        }
    }

    // Returns how it ended.
    async Task<string> RunOnceAsync()
    {
        try
        {
            using var process = AdapterProgram.Start(_plant.Path, [], _access);
            Interlocked.Increment(ref _starts);
            Interlocked.Exchange(ref _startedAt, _time.GetTimestamp());
            _process = process;
            process.OutputDataReceived += (_, line) => Tell(line.Data);
            process.ErrorDataReceived += (_, line) => Tell(line.Data);
            process.BeginOutputReadLine();
            process.BeginErrorReadLine();
            await using (_stop.Token.Register(() => _ = EndAsync(process)))
                await process.WaitForExitAsync();
            return $"status {process.ExitCode}";
        }
        catch (InputException cannotStart)
        {
            return cannotStart.Message;
        }
    }

    void Tell(string line)
    {
        if (!string.IsNullOrEmpty(line)) _log(line);
    }

    static async Task EndAsync(Process process)
    {
        try
        {
            process.StandardInput.Close();
            using var timeout = new CancellationTokenSource(TimeToEnd);
            await process.WaitForExitAsync(timeout.Token).ConfigureAwait(ConfigureAwaitOptions.SuppressThrowing);
            if (!process.HasExited) process.Kill(entireProcessTree: true);
        }
        catch (Exception e) when (e is InvalidOperationException or IOException or ObjectDisposedException)
        {
            // The process has already ended.
        }
    }
}
