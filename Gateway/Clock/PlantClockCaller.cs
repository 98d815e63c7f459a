using Nowpose.Gateway.Hub;
using Nowpose.Sync;

namespace Nowpose.Gateway.Clock;

/// <summary>Requests the time of the control system from one adapter at the pace of a headset's sync exchanges, one request at a time.</summary>
/// <remarks>The gateway sends the requests, so that t1 and t4 are times of this machine, even if the adapter runs on another one.</remarks>
sealed class PlantClockCaller : IDisposable
{
    static readonly TimeSpan PauseAfterFailure = TimeSpan.FromSeconds(1);

    readonly PlantClock _clock;
    readonly IHeadsetClock _counter;
    readonly Action<string> _call;
    readonly TimeProvider _time;
    readonly CancellationTokenSource _stop = new();
    // Never slow, because the error after a step of the clock or a pause of this machine is passed on to all headsets until it is found.
    readonly ExchangePace _pace = new(
        TimeSpan.FromMilliseconds(ProtocolLimits.SyncIntervalMs), ClockSettings.Default.HoldoverAfter, new Random(), maySlow: false);
    volatile Question _open;
    long _asked;

    /// <param name="call">Sends a request with the given id; must not block.</param>
    public PlantClockCaller(PlantClock clock, IHeadsetClock counter, TimeProvider time, Action<string> call) =>
        (_clock, _counter, _time, _call) = (clock, counter, time, call);

    /// <summary>The client that answers the requests, for messages.</summary>
    public HubSource Client { get; init; }

    /// <summary>Starts the requests.</summary>
    public void Start() => _ = Task.Run(AskAsync);

    /// <summary>
    /// Processes a response from the adapter. Thread-safe. Ignores a late response, because its request has already been counted as a failure.
    /// </summary>
    /// <param name="arrival">Time at which the last byte of the response was read.</param>
    public void Answer(RosbridgeMessage response, HeadsetTime arrival)
    {
        var question = _open;
        if (question == null || response.Id != question.Id) return;
        // Copies the values, because the connection reuses the response object for its next message.
        question.Answered.TrySetResult(new Reply(response.PlantTime, response.Text, arrival));
    }

    public void Dispose()
    {
        _stop.Cancel();
        _clock.Detach(this);
    }

    async Task AskAsync()
    {
        try
        {
            while (true)
            {
                var begun = _counter.Now;
                var isAnswered = await AskOnceAsync();
                var ended = _counter.Now;
                var pause = begun + (isAnswered ? _pace.Next(_clock.Synchroniser, ended) : PauseAfterFailure) - ended;
                if (pause > TimeSpan.Zero) await Task.Delay(pause, _time, _stop.Token);
            }
        }
        catch (OperationCanceledException)
        {
            // The requests have been stopped.
        }
    }

    /// <returns>False if the adapter could not read the clock, or did not respond in time.</returns>
    async Task<bool> AskOnceAsync()
    {
        var question = new Question($"plant_time:{++_asked}", _counter.Now);
        _open = question;
        _call(question.Id);
        try
        {
            var reply = await question.Answered.Task.WaitAsync(ProtocolLimits.SyncReplyTimeout, _time, _stop.Token);
            return IsTaken(question, reply);
        }
        catch (TimeoutException)
        {
            _clock.Failed(PlantClockMessages.NoResponse(ProtocolLimits.SyncReplyTimeout.TotalSeconds));
            return false;
        }
        finally
        {
            _open = null;
        }
    }

    bool IsTaken(Question question, Reply reply)
    {
        // Another adapter has taken over: estimates from two clocks must not be mixed.
        if (!_clock.TryHear(this)) return false;
        if (reply.Time is not { } time)
        {
            _clock.Failed(reply.Text ?? PlantClockMessages.NoTime);
            return false;
        }

        _clock.Add(new SyncExchange(
            question.Asked, time.Received, time.Sent, reply.Arrival, time.Resolution, time.ErrorBound, time.IsSynchronised));
        return true;
    }

    sealed record Reply(PlantTimeMessage Time, string Text, HeadsetTime Arrival);

    sealed record Question(string Id, HeadsetTime Asked)
    {
        // Completed on the thread that reads the connection, which must not be blocked by the continuation.
        public TaskCompletionSource<Reply> Answered { get; } = new(TaskCreationOptions.RunContinuationsAsynchronously);
    }
}
