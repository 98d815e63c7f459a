using NUnit.Framework;
using Nowpose.Gateway;
using Nowpose.Gateway.Rosbridge;

namespace Nowpose.Headless.Tests.Gateway;

[Parallelizable(ParallelScope.All)]
public class ReaderProgressTests
{
    const int LongMessage = 30_000;
    static readonly TimeSpan PongTimeout = TimeSpan.FromSeconds(6);

    [Test]
    public void OnSent_PingIsDue_SendsItAfterTheDelay()
    {
        var time = new SteppedTimers();
        var pings = new List<byte[]>();
        using var progress = Progress(time, pings);
        var step = TimeSpan.FromMilliseconds(1);

        for (var sent = TimeSpan.Zero; sent < ReaderProgress.PingDelay; sent += step)
        {
            Assert.That(pings, Is.Empty);
            progress.OnSent(700);
            time.Advance(step);
        }

        Assert.That(pings, Has.Count.EqualTo(1), "the ping is sent after the first message that makes it due");
    }

    [Test]
    public async Task IsSilent_LongMessageInTransit_IsFalseForTheTimeThatASlowReaderNeeds()
    {
        var time = new SteppedTimers();
        var pings = new List<byte[]>();
        using var progress = Progress(time, pings);
        await progress.SendsAsync(LongMessage);
        progress.OnSent(LongMessage);
        progress.OnPong(pings[0]);
        time.Advance(ReaderProgress.PingDelay);

        time.Advance(TimeSpan.FromSeconds(LongMessage / 4000.0));

        Assert.That(pings, Has.Count.EqualTo(2), "one ping before the message and one after it");
        Assert.That(progress.IsSilent(), Is.False);
        time.Advance(TimeSpan.FromSeconds(9));
        Assert.That(progress.IsSilent(), Is.True, "the time for the message and for the pong is over");
    }

    [Test]
    public void IsSilent_ClientNeverAnswersPings_IsTrueAfterTheTimeout()
    {
        var time = new SteppedTimers();
        var pings = new List<byte[]>();
        using var progress = Progress(time, pings);
        var seconds = 0.0;

        for (; seconds < 60 && !progress.IsSilent(); seconds += 0.1)
        {
            progress.OnSent(600);
            time.Advance(TimeSpan.FromSeconds(0.1));
        }

        Assert.That(seconds, Is.InRange(6, 7.5));
    }

    [Test]
    public async Task OpensAsync_ClientNeverAnswersPings_ReportsTheClientOnce()
    {
        var time = new SteppedTimers();
        var reports = 0;
        using var progress = new ReaderProgress(_ => Task.CompletedTask, TimeSpan.FromSeconds(2), PongTimeout, time, () => reports++);
        progress.OnSent(SendWindow.FirstBytes);
        time.Advance(ReaderProgress.PingDelay);
        Assert.That(reports, Is.Zero);

        for (var i = 0; i < 3; i++)
        {
            time.Advance(SendWindow.FirstPongTimeout);
            await progress.OpensAsync(isReply: false, default).Bounded();
        }

        Assert.That(reports, Is.EqualTo(1));
    }

    [Test]
    public async Task WatchAsync_EachMessageIsReadLate_ReportsASlowReader()
    {
        var time = new SteppedTimers();
        var pings = new List<byte[]>();
        using var progress = Progress(time, pings);
        var watching = progress.WatchAsync(default);

        for (var i = 0; i < SendWindow.MaxLatePongs; i++)
        {
            Assert.That(watching.IsCompleted, Is.False);
            progress.OnSent(450);
            time.Advance(ReaderProgress.PingDelay);
            time.Advance(SendWindow.MaxReadTime + TimeSpan.FromMilliseconds(1));
            progress.OnPong(pings[^1]);
        }

        time.Advance(TimeSpan.FromSeconds(1));
        Assert.That(await watching.Bounded(), Is.EqualTo(Closure.SlowReader));
    }

    [Test]
    public async Task WatchAsync_ClientAnswersPings_ContinuesForLongerThanTheTimeout()
    {
        var time = new SteppedTimers();
        var pings = new List<byte[]>();
        using var progress = Progress(time, pings);
        using var stop = new CancellationTokenSource();
        var watching = progress.WatchAsync(stop.Token);

        for (var answered = 0; time.GetElapsedTime(0) < 5 * PongTimeout; time.Advance(TimeSpan.FromMilliseconds(100)))
            for (; answered < pings.Count; answered++) progress.OnPong(pings[answered]);

        Assert.That(watching.IsCompleted, Is.False);
        Assert.That(pings, Has.Count.InRange(10, 15), "a ping every two seconds");
        await stop.CancelAsync();
    }

    [Test]
    public async Task OpensAsync_PongWithoutAMatchingPing_IsIgnored()
    {
        var time = new SteppedTimers();
        var pings = new List<byte[]>();
        using var progress = Progress(time, pings);
        progress.OnSent(5000);
        time.Advance(ReaderProgress.PingDelay);
        using var stop = new CancellationTokenSource();
        var opens = progress.OpensAsync(isReply: false, stop.Token);

        progress.OnPong([1, 2, 3]);
        progress.OnPong(new byte[8]);
        Assert.That(opens.IsCompleted, Is.False);
        progress.OnPong(pings[0]);

        await opens.Bounded();
    }

    static ReaderProgress Progress(TimeProvider time, List<byte[]> pings) => new(
        payload =>
        {
            pings.Add(payload.ToArray());
            return Task.CompletedTask;
        },
        TimeSpan.FromSeconds(2), PongTimeout, time);
}
