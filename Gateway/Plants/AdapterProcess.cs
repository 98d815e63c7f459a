using System.Diagnostics;

namespace Nowpose.Gateway.Plants;

/// <summary>Keeps one adapter program running: restarts it when it ends, and ends it when the gateway stops.</summary>
sealed class AdapterProcess : IAsyncDisposable
{
    static readonly TimeSpan FirstPause = TimeSpan.FromSeconds(0.5), MaxPause = TimeSpan.FromSeconds(30);

    /// <summary>Run time after which the next restart waits for <see cref="FirstPause"/> again.</summary>
    static readonly TimeSpan MinRunTime = TimeSpan.FromSeconds(60);

    static readonly TimeSpan TimeToEnd = TimeSpan.FromSeconds(4);

    readonly PlantFile _plant;
    readonly AdapterAccess _access;
    readonly Action<string> _log;
    readonly TimeProvider _time;
    readonly CancellationTokenSource _stop = new();
    readonly Task _running;

    // Id of the running program; 0 while it is not running.
    volatile int _processId;

    volatile string _end;
    long _startedAt;

    /// <summary>Starts the program immediately.</summary>
    /// <param name="log">Receives the lines that the program prints, and its restarts.</param>
    public AdapterProcess(PlantFile plant, AdapterAccess access, TimeProvider time, Action<string> log)
    {
        _plant = plant;
        _access = access;
        _time = time;
        _log = log;
        _running = Task.Run(RunAsync);
    }

    public AdapterState State =>
        new(_plant.Name, _processId == 0 ? null : _time.GetElapsedTime(Interlocked.Read(ref _startedAt)), _end);

    /// <summary>Id of the running program; null while it is not running.</summary>
    internal int? ProcessId => _processId is var id and not 0 ? id : null;

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
            _processId = 0;
            if (_stop.IsCancellationRequested) return;
            if (Stopwatch.GetElapsedTime(started) > MinRunTime) pause = FirstPause;
            _log(AdapterMessages.Ended(_plant.Path, end, pause.TotalSeconds));
            await Task.Delay(pause, _stop.Token).ConfigureAwait(ConfigureAwaitOptions.SuppressThrowing);
            pause = pause * 2 < MaxPause ? pause * 2 : MaxPause;
        }
    }

    // Returns the exit status, or the reason why the program could not start.
    async Task<string> RunOnceAsync()
    {
        try
        {
            using var process = AdapterProgram.Start(_plant.Path, [], _access);
            Interlocked.Exchange(ref _startedAt, _time.GetTimestamp());
            _processId = process.Id;
            process.OutputDataReceived += (_, line) => Log(line.Data);
            process.ErrorDataReceived += (_, line) => Log(line.Data);
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

    void Log(string line)
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
