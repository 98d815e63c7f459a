using NUnit.Framework;
using Nowpose.Gateway.Clock;
using Nowpose.Sync;

namespace Nowpose.Headless.Tests.Gateway.Clock;

/// <summary>Tests, in virtual time, that a clock of the plant with a wrong rate is found, and that no other disturbance is taken for one.</summary>
public class ClockRateTests
{
    [TestCase(0.001)]
    [TestCase(0.5)]
    [TestCase(0.9)]
    [TestCase(0.997)]
    [TestCase(1.01)]
    [TestCase(2)]
    [TestCase(1000)]
    public void Wrong_WrongRate_IsFoundWithinSixSeconds(double rate)
    {
        var clock = new SimulatedClock { Rate = rate };

        clock.Run(6);

        Assert.That(clock.Found, Is.EqualTo(rate).Within(0.0005 * Math.Max(1, rate)));
    }

    [TestCase(0.5)]
    [TestCase(0.9)]
    [TestCase(0.997)]
    [TestCase(2)]
    public void Wrong_WrongRateOverWiFi_IsFoundWithinAMinuteAndRemains(double rate)
    {
        var clock = new SimulatedClock { Rate = rate, Delay = SimulatedClock.WiFi };

        clock.Run(65);
        var lost = clock.Count(60, found => found == null);

        Assert.That(clock.Found, Is.EqualTo(rate).Within(0.002 * rate));
        Assert.That(lost, Is.Zero);
    }

    [Test]
    public void Wrong_RateOfARealClock_IsNull([Values] bool isWiFi, [Values(0.9995, 1, 1.0005)] double rate)
    {
        var clock = new SimulatedClock { Rate = rate, Delay = isWiFi ? SimulatedClock.WiFi : SimulatedClock.Lan };

        Assert.That(clock.Count(600, found => found != null), Is.Zero);
    }

    // A time service slews a clock that was wrong by up to 120 ms.
    [Test]
    public void Wrong_TimeServiceCorrectsTheClock_IsNull([Values] bool isWiFi, [Values(-2000, -1000, 1000, 2000)] double ppm)
    {
        var clock = new SimulatedClock { Delay = isWiFi ? SimulatedClock.WiFi : SimulatedClock.Lan };
        clock.Run(70);

        clock.Rate = 1 + ppm * 1e-6;
        var wrong = clock.Count(60, found => found != null);
        clock.Rate = 1;

        Assert.That(wrong + clock.Count(90, found => found != null), Is.Zero);
    }

    [TestCase(-3600)]
    [TestCase(-0.5)]
    [TestCase(0.005)]
    [TestCase(3)]
    public void Wrong_Step_IsNull(double seconds)
    {
        var clock = new SimulatedClock();
        clock.Run(30);
        clock.Step(seconds);

        Assert.That(clock.Count(90, found => found != null), Is.Zero);
    }

    // Without exchanges, as when the adapter reports that the clock has stopped, and with exchanges that contain the same time.
    [Test]
    public void Wrong_Pause_IsNull([Values(0.1, 0.3, 0.9, 1.5, 4, 30)] double seconds, [Values] bool isRead)
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
    public void Wrong_DelayOfOneDirectionGrowsSlowly_IsNull(bool isRequest)
    {
        var clock = new SimulatedClock();
        clock.Delay = (_, isThere) => 0.001 + (isThere == isRequest ? 0.1 * Math.Abs(clock.Seconds % 100 / 50 - 1) : 0);

        Assert.That(clock.Count(200, found => found != null), Is.Zero);
    }

    [TestCase(0.9, 10)]
    [TestCase(0.05, 1)]
    [TestCase(0.05, 2)]
    [TestCase(0.1, 4)]
    [TestCase(0.1, 20)]
    [TestCase(0.1, 50)]
    public void Wrong_WrongRateOfAClockWithSteps_IsFound(double rate, double stepMs)
    {
        var clock = new SimulatedClock { Rate = rate, Resolution = TimeSpan.FromMilliseconds(stepMs), Interval = 0.05 };

        clock.Run(10);

        Assert.That(clock.Found, Is.EqualTo(rate).Within(0.03));
        Assert.That(clock.Count(60, found => found == null), Is.Zero);
    }

    [TestCase(4)]
    [TestCase(10)]
    [TestCase(15.6)]
    public void Wrong_StepsWithoutAStatedResolution_IsNull(double stepMs)
    {
        var clock = new SimulatedClock { Resolution = TimeSpan.FromMilliseconds(stepMs), IsResolutionStated = false };

        Assert.That(clock.Count(300, found => found != null), Is.Zero);
    }

    [TestCase(0.5, 6)]
    [TestCase(0.99, 65)]
    public void Wrong_WrongRateWithoutAStatedResolution_IsFound(double rate, double seconds)
    {
        var clock = new SimulatedClock { Rate = rate, Resolution = TimeSpan.FromMilliseconds(10), IsResolutionStated = false };

        clock.Run(seconds);

        Assert.That(clock.Found, Is.EqualTo(rate).Within(0.005));
    }

    [Test]
    public void Wrong_RateBecomesRight_IsNullAfterSixSeconds([Values(0.5, 0.997, 2)] double rate)
    {
        var clock = new SimulatedClock { Rate = rate };
        clock.Run(70);

        clock.Rate = 1;
        clock.Run(6);

        Assert.That(clock.Found, Is.Null);
        Assert.That(clock.Count(60, found => found != null), Is.Zero);
    }

    [Test]
    public void Wrong_RateVaries_IsFoundWithoutInterruption()
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

    // The exchanges are too inaccurate to show that the rate is right.
    [Test]
    public void Wrong_RateBecomesRightBehindASlowNetwork_IsNullWithinThreeMinutes()
    {
        var clock = new SimulatedClock { Rate = 0.997 };
        clock.Run(60);
        var before = clock.Found;

        (clock.Rate, clock.Delay) = (1, (random, _) => 0.2 + 0.004 * random.NextDouble());
        clock.Run(180);

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

        /// <summary>The time between two exchanges, s.</summary>
        public double Interval { get; init; } = 0.2;

        public bool IsResolutionStated { get; init; } = true;

        /// <summary>The delay in one direction, s; the second argument is true for a request.</summary>
        public Func<Random, bool, double> Delay { get; set; } = Lan;

        public double? Found => _rate.Wrong;

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
            for (var end = Seconds + seconds; Seconds < end; Pass(Math.Min(Interval, end - Seconds)))
            {
                var asked = Seconds;
                Pass(Delay(Random, true));
                var shown = new TimeSpan((long)(_shown * TimeSpan.TicksPerSecond) / Resolution.Ticks * Resolution.Ticks);
                Pass(Delay(Random, false));
                _rate.Add(new SyncExchange(
                    HeadsetTime.FromSeconds(asked), new ControlTime(shown), new ControlTime(shown), HeadsetTime.FromSeconds(Seconds),
                    IsResolutionStated ? Resolution : default));
                if (condition(Found)) count++;
            }

            return count;
        }
    }
}
