using System.Runtime.InteropServices;

namespace Nowpose.Gateway.Options;

/// <summary>Handles Ctrl-C and other requests to end, for example from a service manager. A second request ends the process immediately.</summary>
sealed class EndRequest : IDisposable
{
    /// <summary>Maximum time for the command to write its results after the request. The process then ends.</summary>
    static readonly TimeSpan TimeToEnd = TimeSpan.FromSeconds(15);

    static readonly PosixSignal[] Signals = [PosixSignal.SIGINT, PosixSignal.SIGTERM, PosixSignal.SIGHUP, PosixSignal.SIGQUIT];

    readonly CancellationTokenSource _stop;
    readonly PosixSignalRegistration[] _registrations;
    readonly Predicate<PosixSignal> _endsProcess;
    readonly Action<TimeSpan> _sleep;
    Timer _timeout;
    int _requests;
    bool _isHandlerBlocked;

    /// <param name="cancel">Has the effect of Ctrl-C, without the time limit.</param>
    /// <param name="endsProcess">Whether the system ends the process as soon as the handler of a signal returns; null for this system.</param>
    /// <param name="sleep">Blocks the thread of the handler; null to sleep.</param>
    public EndRequest(CancellationToken cancel, Predicate<PosixSignal> endsProcess = null, Action<TimeSpan> sleep = null)
    {
        _endsProcess = endsProcess ?? WindowsProcess.EndsAfter;
        _sleep = sleep ?? Thread.Sleep;
        _stop = CancellationTokenSource.CreateLinkedTokenSource(cancel);
        _registrations = [.. Signals.Select(signal => PosixSignalRegistration.Create(signal, End))];
    }

    public CancellationToken Token => _stop.Token;

    /// <summary>Whether the request was Ctrl-C. True also for a cancellation without a signal.</summary>
    public bool IsInterrupt { get; private set; } = true;

    public void Dispose()
    {
        _timeout?.Dispose();
        // While a handler runs, Windows does not return from the removal of a handler.
        if (!_isHandlerBlocked) Unregister();
    }

    internal void Unregister()
    {
        foreach (var registration in _registrations) registration.Dispose();
    }

    internal void End(PosixSignalContext context)
    {
        if (Interlocked.Increment(ref _requests) > 1) return;
        context.Cancel = true;
        IsInterrupt = context.Signal == PosixSignal.SIGINT;
        _timeout = new Timer(_ => Environment.Exit(IsInterrupt ? ExitStatus.Interrupted : ExitStatus.Terminated), null, TimeToEnd, Timeout.InfiniteTimeSpan);
        _isHandlerBlocked = _endsProcess(context.Signal);
        // Cancels on another thread, so that continuations do not run on the thread that delivers signals.
        Task.Run(_stop.Cancel);
        // The end of the program ends this thread.
        if (_isHandlerBlocked) _sleep(TimeToEnd);
    }
}
