using NUnit.Framework;
using Nowpose.Gateway;
using Nowpose.Gateway.Rosbridge;

namespace Nowpose.Headless.Tests.Gateway;

[Parallelizable(ParallelScope.All)]
public class ReaderProgressTests
{
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

    [TestCase(SendWindow.NearPingBytes)]
    [TestCase(RosbridgeConnection.MinFragmentBytes)]
    [TestCase(100_000)]
    public void IsSilent_ClientStopsAnsweringPings_IsTrueAfterTheTimeoutForAnyNumberOfUnreadBytes(int unreadBytes)
    {
        var time = new SteppedTimers();
        var pings = new List<byte[]>();
        using var progress = Progress(time, pings);
        progress.OnSent(SendWindow.FirstBytes);
        time.Advance(ReaderProgress.PingDelay);
        progress.OnPong(pings[0]);
        progress.OnSent(unreadBytes);
        time.Advance(ReaderProgress.NearPingDelay);
        Assert.That(pings, Has.Count.EqualTo(2));

        time.Advance(PongTimeout - TimeSpan.FromMilliseconds(1));
        Assert.That(progress.IsSilent(), Is.False);
        time.Advance(TimeSpan.FromMilliseconds(1));
        Assert.That(progress.IsSilent(), Is.True);
    }

    [TestCase(3000)]
    [TestCase(15_000)]
    public async Task WatchAsync_ClientReadsALongMessageSlowly_Continues(double bytesPerSecond)
    {
        var time = new SteppedTimers();
        var pings = new List<byte[]>();
        using var progress = Progress(time, pings);
        using var stop = new CancellationTokenSource();
        var watching = progress.WatchAsync(stop.Token);

        for (var sent = 0; sent < 300_000; sent += RosbridgeConnection.MinFragmentBytes)
        {
            progress.OnSent(RosbridgeConnection.MinFragmentBytes, isEnd: false);
            time.Advance(ReaderProgress.PingDelay);
            time.Advance(TimeSpan.FromSeconds(RosbridgeConnection.MinFragmentBytes / bytesPerSecond));
            Assert.That(watching.IsCompleted, Is.False, $"after {sent} bytes");
            progress.OnPong(pings[^1]);
        }

        await stop.CancelAsync();
    }

    [Test]
    public async Task WatchAsync_ClientStopsAnsweringPings_RepeatsThePingUntilTheTimeout()
    {
        var time = new SteppedTimers();
        var pings = new List<(TimeSpan At, long Payload)>();
        using var progress = new ReaderProgress(
            payload =>
            {
                pings.Add((time.GetElapsedTime(0), BitConverter.ToInt64(payload.Span)));
                return Task.CompletedTask;
            },
            TimeSpan.FromSeconds(2), PongTimeout, time);
        var watching = progress.WatchAsync(default);

        while (!watching.IsCompleted && time.GetElapsedTime(0) < 5 * PongTimeout) time.Advance(TimeSpan.FromMilliseconds(100));

        Assert.That(await watching.Bounded(), Is.EqualTo(Closure.Silence));
        Assert.That(time.GetElapsedTime(0), Is.EqualTo(pings[0].At + PongTimeout));
        Assert.That(pings.Select(ping => ping.At.TotalSeconds), Is.EqualTo(new[] { 2, 4, 6 }), "seconds");
        Assert.That(pings.Select(ping => ping.Payload).Distinct().Count(), Is.EqualTo(1), "the pong of each of them confirms the same bytes");
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
