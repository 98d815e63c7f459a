using System.Diagnostics;
using Nowpose.Gateway.Status.Events;

namespace Nowpose.Gateway.Plants;

/// <summary>Keeps the program that reads one control system running: starts it again when it ends, and ends it with the gateway.</summary>
sealed class AdapterProcess : IAsyncDisposable
{
    static readonly TimeSpan FirstPause = TimeSpan.FromSeconds(0.5), LongestPause = TimeSpan.FromSeconds(30);

    /// <summary>One that ran for so long did not fail at its start.</summary>
    static readonly TimeSpan Steady = TimeSpan.FromSeconds(60);

    static readonly TimeSpan TimeToEnd = TimeSpan.FromSeconds(4);

    readonly string _file;
    readonly AdapterAccess _access;
    readonly Action<string> _log;
    readonly Action<Condition> _note;
    readonly CancellationTokenSource _stop = new();
    readonly Task _running;
    volatile Process _process;
    int _starts;

    /// <summary>Starts it at once.</summary>
    /// <param name="file">The plant's configuration, checked already.</param>
    /// <param name="log">Takes its lines as well.</param>
    /// <param name="note">Takes its unexpected ends.</param>
    public AdapterProcess(string file, AdapterAccess access, Action<string> log, Action<Condition> note)
    {
        _file = file;
        _access = access;
        _log = log;
        _note = note;
        _running = Task.Run(RunAsync);
    }

    /// <summary>How often it was started.</summary>
    public int Starts => Volatile.Read(ref _starts);

    /// <summary>Of the program at present; null while it does not run.</summary>
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
            if (_stop.IsCancellationRequested) return;
            if (Stopwatch.GetElapsedTime(started) > Steady) pause = FirstPause;
            _log($"{_file}: its adapter ended, {end}; it is started again in {pause.TotalSeconds:0.#} s");
            // One event for a series of ends: an adapter that cannot start would fill the list.
            if (pause == FirstPause) _note(Ended(end));
            await Task.Delay(pause, _stop.Token).ConfigureAwait(ConfigureAwaitOptions.SuppressThrowing);
            pause = pause * 2 < LongestPause ? pause * 2 : LongestPause;
        }
    }

    // Returns how it ended.
    async Task<string> RunOnceAsync()
    {
        try
        {
            using var process = AdapterProgram.Start(_file, [], _access);
            Interlocked.Increment(ref _starts);
            _process = process;
            process.OutputDataReceived += (_, line) => Tell(line.Data);
            process.ErrorDataReceived += (_, line) => Tell(line.Data);
            process.BeginOutputReadLine();
            process.BeginErrorReadLine();
            await using (_stop.Token.Register(() => _ = EndAsync(process)))
                await process.WaitForExitAsync();
            _process = null;
            return $"status {process.ExitCode}";
        }
        catch (InputException cannotStart)
        {
            return cannotStart.Message;
        }
    }

    Condition Ended(string end) => new("adapter", _file, "ended", $"{end}; the gateway starts it again", Level.Error)
    {
        Headline = $"the adapter of {_file} ended",
        Remedy = "See its lines in the log of the gateway.",
    };

    void Tell(string line)
    {
        if (!string.IsNullOrEmpty(line)) _log(line);
    }

    static async Task EndAsync(Process process)
    {
        try
        {
            process.StandardInput.Close();
            using var patience = new CancellationTokenSource(TimeToEnd);
            await process.WaitForExitAsync(patience.Token).ConfigureAwait(ConfigureAwaitOptions.SuppressThrowing);
            if (!process.HasExited) process.Kill(entireProcessTree: true);
        }
        catch (Exception e) when (e is InvalidOperationException or IOException or ObjectDisposedException)
        {
            // Has ended by itself.
        }
    }
}
