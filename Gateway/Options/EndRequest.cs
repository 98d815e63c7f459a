using System.Runtime.InteropServices;

namespace Nowpose.Gateway.Options;

/// <summary>Ctrl-C, and what else asks a process to end: a service manager, a terminal that is closed. The second one ends it at once.</summary>
sealed class EndRequest : IDisposable
{
    /// <summary>Room to write what was measured or recorded so far.</summary>
    static readonly TimeSpan TimeToEnd = TimeSpan.FromSeconds(15);

    static readonly PosixSignal[] Signals = [PosixSignal.SIGINT, PosixSignal.SIGTERM, PosixSignal.SIGHUP, PosixSignal.SIGQUIT];

    readonly CancellationTokenSource _stop = new();
    readonly PosixSignalRegistration[] _registrations;
    Timer _patience;
    int _requests;

    public EndRequest() => _registrations = [.. Signals.Select(signal => PosixSignalRegistration.Create(signal, End))];

    public CancellationToken Token => _stop.Token;

    /// <summary>Whether it was Ctrl-C; so is whatever else cancelled.</summary>
    public bool IsInterrupt { get; private set; } = true;

    public void Dispose()
    {
        foreach (var registration in _registrations) registration.Dispose();
        _patience?.Dispose();
    }

    void End(PosixSignalContext context)
    {
        if (Interlocked.Increment(ref _requests) > 1) return;
        context.Cancel = true;
        IsInterrupt = context.Signal == PosixSignal.SIGINT;
        _patience = new Timer(_ => Environment.Exit(IsInterrupt ? ExitStatus.Interrupted : ExitStatus.Terminated), null, TimeToEnd, Timeout.InfiniteTimeSpan);
        // Whoever waits for it goes on where it waits: not on the thread that brings signals.
        Task.Run(_stop.Cancel);
    }
}
