using System.Net;
using System.Text.Json;
using Nowpose.Gateway.Messages;
using NUnit.Framework;
using Nowpose.Gateway;
using Nowpose.Gateway.Clock;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Gateway.Clock;

/// <summary>Tests, over real sockets, a step of the system clock while a source publishes samples with time stamps of this clock.</summary>
public class SystemClockStepTests
{
    static readonly TimeSpan Acquisition = TimeSpan.FromMilliseconds(70);

    /// <summary>Length of the past period whose samples the gateway compares with its clocks, as documented in clock-reference.md.</summary>
    static readonly TimeSpan Window = TimeSpan.FromSeconds(5);

    readonly List<string> _log = [];
    CorrectedTime _system;
    GatewayServer _gateway;
    RawRosbridgeClient _source;

    async Task StartAsync(IControlClock own)
    {
        _gateway = await GatewayServer.StartAsync(Gateways.Options() with { SystemClock = _system }, own, Log).Bounded();
        _source = await RawRosbridgeClient.ConnectAsync(_gateway);
        await _source.SubscribeAsync(RosTopics.JointStates);
    }

    [SetUp]
    public void SetUp()
    {
        _system = new CorrectedTime();
        _log.Clear();
    }

    [TearDown]
    public async Task Close()
    {
        _source?.Dispose();
        if (_gateway != null) await _gateway.DisposeAsync();
        (_source, _gateway) = (null, null);
    }

    void Log(string line)
    {
        lock (_log) _log.Add(line);
    }

    bool IsLogged(string part)
    {
        lock (_log) return _log.Exists(line => line.Contains(part, StringComparison.Ordinal));
    }

    ControlTime SystemTime => new(_system.GetUtcNow().UtcDateTime - DateTime.UnixEpoch);

    // The source has subscribed, so it receives its own sample, or a status with the reason why the sample is refused.
    async Task<RosbridgeMessage> PublishAsync(TimeSpan sourceAhead = default)
    {
        var state = new JointStateMessage(SystemTime + sourceAhead - Acquisition, ["a"], [0.5]);
        await _source.SendAsync(RosbridgeWriter.Publish(RosTopics.JointStates, state, RosTimeForm.Sec));
        return await _source.ReceiveAsync();
    }

    async Task ExpectAcceptedAsync(int samples)
    {
        for (var i = 0; i < samples; i++)
        {
            var message = await PublishAsync();
            Assert.That(message.Op, Is.EqualTo(RosbridgeOp.Publish), message.Text);
        }
    }

    async Task<(HttpStatusCode Status, string Text)> GetAsync(string path)
    {
        using var http = new HttpClient();
        using var response = await http.GetAsync(new Uri($"http://127.0.0.1:{_gateway.WebSocketEndPoint.Port}{path}")).Bounded();
        return (response.StatusCode, await response.Content.ReadAsStringAsync().Bounded());
    }

    async Task<JsonElement> StateAsync() => JsonDocument.Parse((await GetAsync("/operations/state")).Text).RootElement;

    async Task<string> BecomesNotReadyAsync(TimeSpan sourceAhead = default)
    {
        var ready = default((HttpStatusCode Status, string Text));
        await Soon.BecomesAsync(
            () =>
            {
                PublishAsync(sourceAhead).GetAwaiter().GetResult();
                ready = GetAsync("/readyz").GetAwaiter().GetResult();
                return ready.Status == HttpStatusCode.ServiceUnavailable && ready.Text.Contains("contradict", StringComparison.Ordinal);
            },
            () => ready.Text);
        return ready.Text;
    }

    async Task BecomesReadyAsync()
    {
        var ready = default((HttpStatusCode Status, string Text));
        await Soon.BecomesAsync(
            () =>
            {
                PublishAsync().GetAwaiter().GetResult();
                ready = GetAsync("/readyz").GetAwaiter().GetResult();
                return ready.Status == HttpStatusCode.OK;
            },
            () => ready.Text);
    }

    [TestCase(3600.0)]
    [TestCase(-3600.0)]
    [TestCase(2.5)]
    [TestCase(-2.5)]
    [TestCase(-0.1)]
    [TestCase(-0.3)]
    [TestCase(-1.0)]
    public async Task Step_SystemClockServed_HeadsetsFollowWithoutRefusedSamples(double seconds)
    {
        await StartAsync(new SystemControlClock(_system));
        using var headset = await RawSyncClient.ConnectAsync(_gateway);
        await ExpectAcceptedAsync(20);

        _system.Correct(TimeSpan.FromSeconds(seconds));

        await ExpectAcceptedAsync(20);
        var before = SystemTime;
        var reply = (await headset.ExchangeAsync(SyncFrame.Request(1, 42))).Value;
        Assert.That(ControlTime.FromNanoseconds(reply.T2Ns), Is.InRange(before, SystemTime), "a headset sees the step");
        Assert.That(_gateway.Drops.Total, Is.Zero);
        Assert.That((await GetAsync("/readyz")).Text, Is.EqualTo("ready\n"));
        Assert.That((await StateAsync()).GetProperty("clock").TryGetProperty("warning", out _), Is.False);
    }

    [Test]
    public async Task Step_SourceFollowsLater_IsReportedUntilTheSourceFollows()
    {
        await StartAsync(new SystemControlClock(_system));
        await ExpectAcceptedAsync(5);

        _system.Correct(TimeSpan.FromSeconds(-30));
        var refused = await PublishAsync(TimeSpan.FromSeconds(30));
        var reason = await BecomesNotReadyAsync(TimeSpan.FromSeconds(30));

        Assert.That(refused.Text, Does.Contain(nameof(DropReason.StampInFuture)));
        Assert.That(reason, Does.Match($"29[.][0-9] s .*: {StampMessages.NotCorrected} [(]since [^)]*[)][.] {StampMessages.SourceRemedy}"));
        Assert.That(IsLogged("clock: "), Is.True, string.Join('\n', _log));
        Assert.That((await StateAsync()).GetProperty("clock").GetProperty("warning").GetString(), Does.Contain(StampMessages.NotCorrected));

        await ExpectAcceptedAsync(1);
        _system.Skip(Window);
        await BecomesReadyAsync();
        Assert.That(IsLogged(StampMessages.AgreeAgain), Is.True);
    }

    [TestCase(3600.0)]
    [TestCase(-3600.0)]
    [TestCase(2.5)]
    public async Task Step_MonotonicClockServed_IsReportedWithARemedyUntilReversed(double seconds)
    {
        await StartAsync(new StopwatchControlClock(SystemTime));
        await ExpectAcceptedAsync(5);

        _system.Correct(TimeSpan.FromSeconds(seconds));
        var reason = await BecomesNotReadyAsync();

        Assert.That(reason, Does.StartWith($"waiting\n{EventTexts.StampsContradictClock(EventTexts.OwnClock)}: ")
            .And.Match($"{StampMessages.FitsSystemClock} [(]since [^)]*[)][.] {StampMessages.SystemRemedy}"));
        var state = await StateAsync();
        Assert.That(state.GetProperty("clock").GetProperty("warning").GetString(), Does.Contain(StampMessages.FitsSystemClock));
        Assert.That(state.GetProperty("status").GetProperty("level").GetString(), Is.EqualTo("error"));
        Assert.That(state.GetProperty("status").GetProperty("text").GetString(), Does.Contain(EventTexts.StampsContradictClock(EventTexts.OwnClock)));
        Assert.That(IsLogged(StampMessages.FitsSystemClock), Is.True, string.Join('\n', _log));
        Assert.That(_gateway.Drops[DropReason.StampInFuture], seconds > 0 ? Is.Positive : Is.Zero);

        _system.Correct(TimeSpan.FromSeconds(-seconds));
        await ExpectAcceptedAsync(1);
        _system.Skip(Window);
        await BecomesReadyAsync();
    }

    // The time stamps of the other source are far behind or ahead of the control time.
    [TestCase(-755.0)]
    [TestCase(755.0)]
    public async Task Publish_JointOfAnotherSourceWithWrongTimeStamps_CausesNoContradiction(double seconds)
    {
        await StartAsync(new StopwatchControlClock(SystemTime));
        using var owner = _gateway.Hub.OpenSource();
        owner.Publish(new JointStateMessage(SystemTime, ["a"], [0.5]));
        await _source.ReceiveAsync();
        _system.Correct(TimeSpan.FromSeconds(seconds));

        for (var i = 0; i < 20; i++) Assert.That((await PublishAsync()).Text, Does.Contain("dropped"));
        _gateway.Clock.Stamps.Look(_ => { });

        Assert.That(_gateway.Clock.Stamps.IsContradicted, Is.False, _gateway.Clock.Stamps.Warning);
        Assert.That((await GetAsync("/readyz")).Text, Does.Not.Contain("contradict"));
    }

    [TestCase(0.3)]
    [TestCase(-5)]
    public async Task State_SourceAheadOfTheControlClockOrFarBehind_WarnsAndStaysReady(double seconds)
    {
        await StartAsync(new SystemControlClock(_system));
        var ahead = Acquisition + TimeSpan.FromSeconds(seconds);
        // Publishes for longer than the compared period, in each second.
        for (var i = 0; i <= StampWatch.Seconds; i++)
        {
            Assert.That((await PublishAsync(ahead)).Op, Is.EqualTo(RosbridgeOp.Publish));
            _system.Skip(TimeSpan.FromSeconds(1));
        }

        JsonElement Status() => StateAsync().Result.GetProperty("status");
        // On a busy machine a sample may arrive so late that its time stamp is no longer ahead, so more samples are published.
        await Soon.BecomesAsync(
            () =>
            {
                PublishAsync(ahead).Wait();
                _gateway.Clock.Stamps.Look(_ => { });
                return Status().GetProperty("level").GetString() == "warning";
            },
            () => Status().ToString());

        Assert.That((await GetAsync("/readyz")).Text, Is.EqualTo("ready\n"));
        const string source = "rosbridge 127[.]0[.]0[.]1";
        Assert.That(Status().GetProperty("text").GetString(), Does.Match(seconds > 0
            ? $"^{EventTexts.SourceDoes(source, EventTexts.Future)}: {EventTexts.FutureBy("[0-9]+ ms")}[.] {StampMessages.SourceRemedy}$"
            : $"^{EventTexts.SourceDoes(source, EventTexts.TooOld)}: {EventTexts.TooOldBy("[0-9.]+ s")}[.] {StampMessages.LateSourceRemedy}$"));
    }

    /// <summary>Simulates the system's clock and counter. A test can correct the clock and advance the counter.</summary>
    sealed class CorrectedTime : TimeProvider
    {
        long _correction, _skipped;

        public override long TimestampFrequency => TimeSpan.TicksPerSecond;
        public override DateTimeOffset GetUtcNow() => System.GetUtcNow() + new TimeSpan(Interlocked.Read(ref _correction));
        public override long GetTimestamp() => System.GetElapsedTime(0).Ticks + Interlocked.Read(ref _skipped);

        public void Correct(TimeSpan by) => Interlocked.Add(ref _correction, by.Ticks);

        public void Skip(TimeSpan by) => Interlocked.Add(ref _skipped, by.Ticks);
    }
}
