using Nowpose.Protocol;
using Nowpose.Sync;

namespace Nowpose.Gateway.Clock;

/// <summary>Asks one adapter for the time of its control system again and again, one question at a time, as a headset asks the gateway.</summary>
/// <remarks>The gateway asks, and not the adapter, so that t1 and t4 are this machine's wherever the adapter runs.</remarks>
sealed class PlantClockCaller : IDisposable
{
    readonly PlantClock _clock;
    readonly IHeadsetClock _counter;
    readonly Action<string> _call;
    readonly TimeProvider _time;
    readonly CancellationTokenSource _stop = new();
    readonly ExchangePace _pace = new(
        TimeSpan.FromMilliseconds(ProtocolLimits.SyncIntervalMs), ClockSettings.Default.HoldoverAfter, new Random());
    volatile Question _open;
    long _asked;

    /// <param name="call">Sends a question with this id; must not wait.</param>
    public PlantClockCaller(PlantClock clock, IHeadsetClock counter, TimeProvider time, Action<string> call)
    {
        _clock = clock;
        _counter = counter;
        _time = time;
        _call = call;
    }

    public PlantClock Clock => _clock;

    /// <summary>Begins to ask.</summary>
    public void Start() => _ = Task.Run(AskAsync);

    /// <summary>An answer; any thread. One to no open question is passed over: it came too late, and was counted then.</summary>
    /// <param name="arrival">When its last byte had been read.</param>
    public void Answer(RosbridgeMessage response, HeadsetTime arrival)
    {
        var question = _open;
        if (question == null || response.Id != question.Id) return;
        // The response itself is overwritten by the next message.
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
                await AskOnceAsync();
                var ended = _counter.Now;
                var pause = begun + _pace.Next(_clock.Synchroniser, ended) - ended;
                if (pause > TimeSpan.Zero) await Task.Delay(pause, _time, _stop.Token);
            }
        }
        catch (OperationCanceledException)
        {
            _open = null;
        }
    }

    async Task AskOnceAsync()
    {
        var question = new Question($"plant_time:{++_asked}", _counter.Now);
        _open = question;
        _call(question.Id);
        try
        {
            var reply = await question.Answered.Task.WaitAsync(ProtocolLimits.SyncReplyTimeout, _time, _stop.Token);
            Take(question, reply);
        }
        catch (TimeoutException)
        {
            _clock.Failed($"no answer within {ProtocolLimits.SyncReplyTimeout.TotalSeconds} s");
        }

        _open = null;
    }

    void Take(Question question, Reply reply)
    {
        // Another's place by now: two clocks of one name would be one line.
        if (!_clock.TryHear(this)) return;
        if (reply.Time is not { } time)
        {
            _clock.Failed(reply.Text ?? "the adapter has no time");
            return;
        }

        _clock.Add(new SyncExchange(
            question.Asked, time.Received, time.Sent, reply.Arrival, time.Resolution, time.ErrorBound, time.IsSynchronised));
    }

    sealed record Reply(PlantTimeMessage Time, string Text, HeadsetTime Arrival);

    sealed record Question(string Id, HeadsetTime Asked)
    {
        // Answered on the thread that reads the connection: what follows must not hold it up.
        public TaskCompletionSource<Reply> Answered { get; } = new(TaskCreationOptions.RunContinuationsAsynchronously);
    }
}
