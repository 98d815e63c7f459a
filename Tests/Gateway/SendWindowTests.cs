using NUnit.Framework;
using Nowpose.Gateway.Rosbridge;

namespace Nowpose.Headless.Tests.Gateway;

[Parallelizable(ParallelScope.All)]
public class SendWindowTests
{
    internal static readonly TimeSpan Step = TimeSpan.FromMilliseconds(1);

    /// <summary>Maximum age of a received message: one second minus the 0.25 s that queue and acquisition take.</summary>
    const double MaxAgeSeconds = 0.75;

    [Test]
    public void Reader_At4KilobytesPerSecond_ReceivesOnlyRecentMessages(
        [Values(350, 450, 900)] int messageBytes, [Values(5, 20, 50)] int intervalMs, [Values(1, 40, 120)] int roundTripMs)
    {
        var run = new Run(bytesPerSecond: 4000, messageBytes, intervalMs, roundTripMs);

        run.Continue(TimeSpan.FromSeconds(60));

        Assert.That(run.MaxAge.TotalSeconds, Is.LessThan(MaxAgeSeconds), $"window {run.Window.Size} bytes");
        Assert.That(run.ReadMessages * messageBytes, Is.GreaterThan(0.75 * 60 * Math.Min(4000, messageBytes * 1000.0 / intervalMs)), "used");
    }

    [Test]
    public void Reader_BelowTwoKilobytesPerSecond_ReceivesOneMessageAtATime(
        [Values(600, 800, 1000, 1200, 1500, 2000)] double bytesPerSecond, [Values(370, 450)] int messageBytes, [Values(1, 40)] int roundTripMs)
    {
        var run = new Run(bytesPerSecond, messageBytes, intervalMs: 20, roundTripMs);

        run.Continue(TimeSpan.FromSeconds(60));

        Assert.That(run.MaxAge, Is.LessThanOrEqualTo(SendWindow.MaxReadTime), $"window {run.Window.Size} bytes");
        Assert.That(run.Window.IsTooSlow, Is.False);
        Assert.That(run.ReadMessages * messageBytes, Is.GreaterThan(0.75 * 60 * bytesPerSecond), "used");
    }

    // A simulated cell sends joint positions and poses with these lengths alternately.
    [Test]
    public void Reader_OfShortAndLongMessages_ReceivesOnlyRecentMessagesOrIsTooSlow(
        [Values(600, 800, 1000, 1200, 1300, 1500, 1800, 2200, 3000, 4000)] double bytesPerSecond, [Values(1, 40)] int roundTripMs)
    {
        var run = new Run(bytesPerSecond, messageBytes: 385, intervalMs: 10, roundTripMs) { SecondBytes = 1041 };

        run.Continue(TimeSpan.FromSeconds(25));

        var isReadInTime = 1041 / bytesPerSecond < SendWindow.MaxReadTime.TotalSeconds;
        Assert.That(run.Window.IsTooSlow, Is.EqualTo(!isReadInTime), $"maximum age {run.MaxAge.TotalSeconds:0.00} s, window {run.Window.Size} bytes");
        if (isReadInTime) Assert.That(run.MaxAge, Is.LessThanOrEqualTo(SendWindow.MaxReadTime + TimeSpan.FromMilliseconds(roundTripMs)));
    }

    [Test]
    public void IsTooSlow_ReadingAMessageTakesASecond_IsTrueAfterAFewMessages()
    {
        var run = new Run(bytesPerSecond: 450, messageBytes: 450, intervalMs: 20, roundTripMs: 1);

        run.Continue(TimeSpan.FromSeconds(SendWindow.MaxLatePongs));
        Assert.That(run.Window.IsTooSlow, Is.False);
        run.Continue(TimeSpan.FromSeconds(2));

        Assert.That(run.Window.IsTooSlow, Is.True);
    }

    // The manual states these results (gateway-capacity.md).
    [TestCase(250, false)]
    [TestCase(500, false)]
    [TestCase(750, false)]
    [TestCase(1000, true)]
    [TestCase(2000, true)]
    public void Reader_PausesBetweenItsReads_ReceivesSamplesAsOldAsThePauseAndIsTooSlowFromASecondOn(int pauseMs, bool isTooSlow)
    {
        var run = new Run(bytesPerSecond: 1e9, messageBytes: 385, intervalMs: 20, roundTripMs: 1) { ReadPauseMs = pauseMs };

        run.Continue(TimeSpan.FromMilliseconds((SendWindow.MaxLatePongs - 1) * pauseMs));
        Assert.That(run.Window.IsTooSlow, Is.False, "after a few reads");
        run.Continue(TimeSpan.FromMilliseconds(3 * pauseMs));

        Assert.That(run.Window.IsTooSlow, Is.EqualTo(isTooSlow));
        Assert.That(run.MaxAge.TotalMilliseconds, Is.EqualTo(pauseMs).Within(25));
    }

    [Test]
    public void IsTooSlow_SinglePongsAreLate_IsFalse()
    {
        var window = new SendWindow();
        var now = TimeSpan.Zero;
        for (var i = 0; i < 100; i++)
        {
            window.OnSent(450, now);
            var ping = window.OnPing(now);
            now += i % SendWindow.MaxLatePongs != 0 ? Step : SendWindow.MaxReadTime + Step;
            window.OnPong(ping, now);

            Assert.That(window.IsTooSlow, Is.False);
        }
    }

    [Test]
    public void Reader_FastWithALongRoundTrip_ReceivesAllMessages([Values(1, 40, 120, 180)] int roundTripMs)
    {
        var run = new Run(bytesPerSecond: 1e7, messageBytes: 450, intervalMs: 20, roundTripMs);
        run.Continue(TimeSpan.FromSeconds(5));
        var refused = run.Refused;

        run.Continue(TimeSpan.FromSeconds(60));

        Assert.That(run.Refused - refused, Is.Zero, "messages that the window refused after its first seconds");
    }

    [Test]
    public void Reader_FastOverALossyPath_ReceivesNearlyAllMessages([Values(250, 350)] int stallMs, [Values(20, 40)] int roundTripMs)
    {
        // The gateway sends 30 kB/s of joint positions and poses. After a lost packet, TCP delivers nothing until it has sent the packet again.
        var run = new Run(bytesPerSecond: 1e7, messageBytes: 750, intervalMs: 25, roundTripMs) { StallMs = stallMs };
        run.Continue(TimeSpan.FromSeconds(10));
        var refused = run.Refused;

        run.Continue(TimeSpan.FromSeconds(60));

        Assert.That((run.Refused - refused) / (60 / 0.025), Is.LessThan(0.05), "fraction of the messages that the window refused");
    }

    [Test]
    public void Reader_At4KilobytesPerSecondOverALossyPath_ReceivesOnlyRecentMessages([Values(250, 350)] int stallMs)
    {
        var run = new Run(bytesPerSecond: 4000, messageBytes: 450, intervalMs: 20, roundTripMs: 40) { StallMs = stallMs };

        run.Continue(TimeSpan.FromSeconds(60));

        Assert.That(run.MaxAge.TotalSeconds, Is.LessThan(MaxAgeSeconds + (stallMs / 1000.0)), $"window {run.Window.Size} bytes");
    }

    [Test]
    public void Reader_BecomesFast_ReceivesAllMessagesAgain()
    {
        var run = new Run(bytesPerSecond: 4000, messageBytes: 450, intervalMs: 20, roundTripMs: 40);
        run.Continue(TimeSpan.FromSeconds(20));

        run.BytesPerSecond = 1e7;
        run.Continue(TimeSpan.FromSeconds(2));
        var refused = run.Refused;
        run.Continue(TimeSpan.FromSeconds(20));

        Assert.That(run.Refused - refused, Is.Zero);
    }

    [Test]
    public void Reader_SlowsDownTo4KilobytesPerSecond_ReceivesOnlyRecentMessages(
        [Values(20, 50)] int intervalMs, [Values(1, 20)] int roundTripMs, [Values(0, 40_000)] int burstBytes, [Range(0, 80, 16)] int phaseMs)
    {
        var run = new Run(bytesPerSecond: 1e7, messageBytes: 450, intervalMs, roundTripMs);
        run.Continue(TimeSpan.FromSeconds(1));
        run.SendBurst(burstBytes);
        run.Continue(TimeSpan.FromSeconds(2) + (phaseMs * Step));

        run.BytesPerSecond = 4000;
        run.Continue(TimeSpan.FromSeconds(10));

        Assert.That(run.MaxAge.TotalSeconds, Is.LessThan(MaxAgeSeconds), $"window {run.Window.Size} bytes");
    }

    [Test]
    public void Reader_At4KilobytesPerSecondWithoutPongs_ReceivesOnlyRecentMessages(
        [Values(350, 450, 900)] int messageBytes, [Values(5, 20, 50)] int intervalMs, [Values(1, 40, 120)] int roundTripMs)
    {
        var run = new Run(bytesPerSecond: 4000, messageBytes, intervalMs, roundTripMs) { AnswersPings = false };

        run.Continue(TimeSpan.FromSeconds(60));

        Assert.That(run.MaxAge.TotalSeconds, Is.LessThan(MaxAgeSeconds));
        Assert.That(run.ReadMessages * messageBytes, Is.GreaterThan(0.9 * 58 * SendWindow.AssumedBytesPerSecond), "used");
    }

    [Test]
    public void Reader_AnswersItsFirstPingLate_ReceivesAllLaterMessages()
    {
        var run = new Run(bytesPerSecond: 1e7, messageBytes: 450, intervalMs: 20, roundTripMs: 1) { AnswersPings = false };
        run.Continue(TimeSpan.FromSeconds(10));

        run.AnswersPings = true;
        run.Continue(TimeSpan.FromSeconds(2));
        var refused = run.Refused;
        run.Continue(TimeSpan.FromSeconds(20));

        Assert.That(run.Refused - refused, Is.Zero);
    }

    /// <summary>Simulates a reader, buffers of unlimited size and a path with a delay, in steps of a millisecond.</summary>
    sealed class Run(double bytesPerSecond, int messageBytes, int intervalMs, int roundTripMs)
    {
        const int PingBytes = 10;

        // Messages and pings in transit: time of arrival, remaining bytes, time of creation, and the number of the ping (0 for a message).
        readonly Queue<(TimeSpan Arrives, double Bytes, TimeSpan Made, long Ping)> _way = [];
        readonly Queue<(TimeSpan Arrives, long Ping)> _pongs = [];
        TimeSpan _now;
        TimeSpan? _nextPing;
        int _burst;
        bool _isSecond;
        double _credit;

        public double BytesPerSecond { get; set; } = bytesPerSecond;
        public bool AnswersPings { get; set; } = true;

        /// <summary>Length of every second message, in bytes; 0 if all messages have the same length.</summary>
        public int SecondBytes { get; init; }

        public SendWindow Window { get; } = new();
        public TimeSpan MaxAge { get; private set; }
        public int ReadMessages { get; private set; }
        public int Refused { get; private set; }

        /// <summary>At the start of each period of two seconds, nothing arrives at the client for this time in ms.</summary>
        public int StallMs { get; init; }

        /// <summary>Interval of the client's reads, in each of which it reads all data that have arrived, in ms; 1 for a client that always reads.</summary>
        public int ReadPauseMs { get; init; } = 1;

        TimeSpan OneWay => TimeSpan.FromMilliseconds(roundTripMs / 2.0);

        TimeSpan Arrival
        {
            get
            {
                var arrival = _now + OneWay;
                var inStall = TimeSpan.FromMilliseconds(arrival.TotalMilliseconds % 2000);
                var stall = TimeSpan.FromMilliseconds(StallMs);
                return inStall < stall ? arrival - inStall + stall : arrival;
            }
        }

        public void Continue(TimeSpan time)
        {
            for (var end = _now + time; _now < end; _now += Step)
            {
                while (AnswersPings && _pongs.TryPeek(out var pong) && pong.Arrives <= _now)
                {
                    Window.OnPong(_pongs.Dequeue().Ping, _now);
                    PlanPing();
                }

                for (; _burst > 0 && Window.IsOpen(_now); _burst -= messageBytes) Send();
                if ((long)_now.TotalMilliseconds % intervalMs == 0) SendWhenOpen();
                if (_nextPing <= _now) Ping();
                Read();
            }
        }

        /// <summary>Sends messages with this total number of bytes as soon as the window is open.</summary>
        public void SendBurst(int bytes) => _burst = bytes;

        void SendWhenOpen()
        {
            if (Window.IsOpen(_now)) Send();
            else Refused++;
        }

        void Send()
        {
            var bytes = _isSecond && SecondBytes > 0 ? SecondBytes : messageBytes;
            _isSecond = !_isSecond;
            Window.OnSent(bytes, _now);
            _way.Enqueue((Arrival, bytes, _now, 0));
            PlanPing();
        }

        void PlanPing()
        {
            if (Window.IsPingDue) _nextPing ??= _now + (Window.IsNear ? ReaderProgress.NearPingDelay : ReaderProgress.PingDelay);
        }

        void Ping()
        {
            _nextPing = null;
            _way.Enqueue((Arrival, PingBytes, _now, Window.OnPing(_now)));
        }

        void Read()
        {
            if ((long)_now.TotalMilliseconds % ReadPauseMs != 0) return;
            _credit = Math.Min(_credit + (BytesPerSecond * Step.TotalSeconds), BytesPerSecond * Step.TotalSeconds + Math.Max(messageBytes, SecondBytes));
            while (_way.TryPeek(out var next) && next.Arrives <= _now && next.Bytes <= _credit)
            {
                _way.Dequeue();
                _credit -= next.Bytes;
                if (next.Ping != 0)
                {
                    _pongs.Enqueue((_now + OneWay, next.Ping));
                    continue;
                }

                ReadMessages++;
                if (_now - next.Made > MaxAge) MaxAge = _now - next.Made;
            }
        }
    }
}
