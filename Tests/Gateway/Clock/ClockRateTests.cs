using NUnit.Framework;
using Nowpose.Gateway.Clock;
using Nowpose.Sync;

namespace Nowpose.Headless.Tests.Gateway.Clock;

/// <summary>Tests, in virtual time, that a clock of the plant with a wrong rate is found, and that no other disturbance is taken for one.</summary>
public class ClockRateTests
{
    static readonly TimeSpan Interval = TimeSpan.FromSeconds(0.2);

    [TestCase(0.001)]
    [TestCase(0.5)]
    [TestCase(0.9)]
    [TestCase(0.997)]
    [TestCase(1.01)]
    [TestCase(2)]
    [TestCase(1000)]
    public void WrongAt_WrongRate_IsFoundWithinSixSeconds(double rate)
    {
        var clock = new SimulatedClock { Rate = rate };

        clock.Run(6);

        Assert.That(clock.Found, Is.EqualTo(rate).Within(0.0005 * Math.Max(1, rate)));
    }

    [TestCase(0.5)]
    [TestCase(0.9)]
    [TestCase(0.997)]
    [TestCase(2)]
    public void WrongAt_WrongRateOverWiFi_IsFoundWithinAMinuteAndRemains(double rate)
    {
        var clock = new SimulatedClock { Rate = rate, Delay = SimulatedClock.WiFi };

        clock.Run(65);
        var lost = clock.Count(60, found => found == null);

        Assert.That(clock.Found, Is.EqualTo(rate).Within(0.002 * rate));
        Assert.That(lost, Is.Zero);
    }

    [Test]
    public void WrongAt_RateOfARealClock_IsNull([Values] bool isWiFi, [Values(0.9995, 1, 1.0005)] double rate)
    {
        var clock = new SimulatedClock { Rate = rate, Delay = isWiFi ? SimulatedClock.WiFi : SimulatedClock.Lan };

        Assert.That(clock.Count(600, found => found != null), Is.Zero);
    }

    [TestCase(-3600)]
    [TestCase(-0.5)]
    [TestCase(0.005)]
    [TestCase(3)]
    public void WrongAt_Step_IsNull(double seconds)
    {
        var clock = new SimulatedClock();
        clock.Run(30);
        clock.Step(seconds);

        Assert.That(clock.Count(90, found => found != null), Is.Zero);
    }

    // Without exchanges, as when the adapter reports that the clock has stopped, and with exchanges that contain the same time.
    [Test]
    public void WrongAt_Pause_IsNull([Values(0.1, 0.3, 0.9, 1.5, 4, 30)] double seconds, [Values] bool isRead)
    {
        var clock = new SimulatedClock();
        clock.Run(30);

        clock.Rate = 0;
        var wrong = isRead ? clock.Count(seconds, found => found != null) : 0;
        if (!isRead) clock.Pass(seconds);
        clock.Rate = 1;

        Assert.That(wrong + clock.Count(90, found => found != null), Is.Zero);
    }

    // A busy network: the delay in one direction grows by 100 ms within 50 s, and decreases again.
    [TestCase(true)]
    [TestCase(false)]
    public void WrongAt_DelayOfOneDirectionGrowsSlowly_IsNull(bool isRequest)
    {
        var clock = new SimulatedClock();
        clock.Delay = (_, isThere) => 0.001 + (isThere == isRequest ? 0.1 * Math.Abs(clock.Seconds % 100 / 50 - 1) : 0);

        Assert.That(clock.Count(200, found => found != null), Is.Zero);
    }

    [Test]
    public void WrongAt_WrongRateOfAClockWithStepsOf10Ms_IsFound()
    {
        var clock = new SimulatedClock { Rate = 0.9, Resolution = TimeSpan.FromMilliseconds(10) };

        clock.Run(10);

        Assert.That(clock.Found, Is.EqualTo(0.9).Within(0.005));
    }

    [Test]
    public void WrongAt_RateBecomesRight_IsNullAfterSixSeconds([Values(0.5, 0.997, 2)] double rate)
    {
        var clock = new SimulatedClock { Rate = rate };
        clock.Run(70);

        clock.Rate = 1;
        clock.Run(6);

        Assert.That(clock.Found, Is.Null);
        Assert.That(clock.Count(60, found => found != null), Is.Zero);
    }

    [Test]
    public void WrongAt_RateVaries_IsFoundWithoutInterruption()
    {
        var clock = new SimulatedClock { Rate = 0.9 };
        clock.Run(6);

        var lost = 0;
        for (var i = 0; i < 60; i++)
        {
            clock.Rate = 0.7 + 0.25 * clock.Random.NextDouble();
            lost += clock.Count(1, found => found == null);
        }

        Assert.That(lost, Is.Zero);
    }

    [Test]
    public void WrongAt_NoMoreExchanges_IsNull()
    {
        var clock = new SimulatedClock { Rate = 0.5 };
        clock.Run(10);
        var before = clock.Found;

        clock.Pass(2.5);

        Assert.That(before, Is.Not.Null);
        Assert.That(clock.Found, Is.Null);
    }

    sealed class SimulatedClock
    {
        readonly ClockRate _rate = new();
        double _shown = 1_700_000_000;

        public Random Random { get; } = new(3);
        public double Seconds { get; private set; } = 50;
        public double Rate { get; set; } = 1;
        public TimeSpan Resolution { get; init; } = new(1);

        /// <summary>The delay in one direction, s; the second argument is true for a request.</summary>
        public Func<Random, bool, double> Delay { get; set; } = Lan;

        public double? Found => _rate.WrongAt(HeadsetTime.FromSeconds(Seconds));

        public static double Lan(Random random, bool isThere) => 0.0004 + 0.0002 * random.NextDouble();

        // Delays of 2 ms and an exponentially distributed part of 5 ms, and one of twenty with up to 150 ms more.
        public static double WiFi(Random random, bool isThere) =>
            0.002 - 0.005 * Math.Log(1 - random.NextDouble()) + (random.Next(20) == 0 ? 0.15 * random.NextDouble() : 0);

        public void Step(double seconds) => _shown += seconds;

        public void Pass(double seconds) => (Seconds, _shown) = (Seconds + seconds, _shown + seconds * Rate);

        public void Run(double seconds) => Count(seconds, _ => false);

        /// <summary>Simulates exchanges, and returns the number of those after which the result meets the condition.</summary>
        public int Count(double seconds, Predicate<double?> condition)
        {
            var count = 0;
            for (var end = Seconds + seconds; Seconds < end; Pass(Math.Min(Interval.TotalSeconds, end - Seconds)))
            {
                var asked = Seconds;
                Pass(Delay(Random, true));
                var shown = new TimeSpan((long)(_shown * TimeSpan.TicksPerSecond) / Resolution.Ticks * Resolution.Ticks);
                Pass(Delay(Random, false));
                _rate.Add(new SyncExchange(
                    HeadsetTime.FromSeconds(asked), new ControlTime(shown), new ControlTime(shown), HeadsetTime.FromSeconds(Seconds), Resolution));
                if (condition(Found)) count++;
            }

            return count;
        }
    }
}
