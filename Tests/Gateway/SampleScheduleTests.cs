using NUnit.Framework;
using Nowpose.Gateway.Plants;

namespace Nowpose.Headless.Tests.Gateway;

public class SampleScheduleTests
{
    static TimeSpan Ms(double value) => TimeSpan.FromMicroseconds(value * 1000);

    static List<(ControlTime Taken, ControlTime Sent)> First(int count, double samplingMs, double min, double max, int seed = 1)
    {
        var schedule = new SampleSchedule(ControlTime.FromSeconds(100.0123456), new CellTiming(Ms(samplingMs), Ms(min), Ms(max)), seed);
        var samples = new List<(ControlTime, ControlTime)>();
        for (var i = 0; i < count; i++)
        {
            schedule.Next();
            samples.Add((schedule.Taken, schedule.Sent));
        }

        return samples;
    }

    [Test]
    public void Taken_AllSamples_AreOneIntervalApart()
    {
        var samples = First(100, 50, 0, 0);

        var expected = Enumerable.Range(0, 100).Select(k => ControlTime.FromSeconds(100.05) + Ms(50 * k));
        Assert.That(samples.Select(sample => sample.Taken), Is.EqualTo(expected));
        Assert.That(samples.Select(sample => sample.Sent), Is.EqualTo(samples.Select(sample => sample.Taken)));
    }

    [Test]
    public void Taken_IntervalNotAMultipleOfTheCycle_IsRoundedToCyclesWithoutDrift()
    {
        var samples = First(1001, 12.5, 0, 0);

        Assert.That(samples.Select(sample => sample.Taken.SinceEpoch.Ticks % TimeSpan.TicksPerMillisecond), Has.All.Zero);
        Assert.That(samples[1000].Taken - samples[0].Taken, Is.EqualTo(Ms(12_500)).Within(Ms(1)));
    }

    [Test]
    public void Sent_DelaysShorterThanTheInterval_CoverTheWholeRange()
    {
        var samples = First(2000, 200, 55, 105);
        var delays = samples.Select(sample => (sample.Sent - sample.Taken).TotalMilliseconds).ToArray();

        Assert.That(delays, Has.All.InRange(55.0, 105.0));
        Assert.That(delays.Average(), Is.EqualTo(80).Within(1.5));
        Assert.That(delays.Max() - delays.Min(), Is.GreaterThan(49));
    }

    [Test]
    public void Sent_DelaysLongerThanTheInterval_StayInOrder()
    {
        var sent = First(2000, 10, 0, 100).Select(sample => sample.Sent).ToArray();

        Assert.That(sent, Is.Ordered);
    }

    [Test]
    public void Sent_SameSeed_ReturnsTheSameTimes()
    {
        Assert.That(First(50, 50, 55, 105, 7), Is.EqualTo(First(50, 50, 55, 105, 7)));
        Assert.That(First(50, 50, 55, 105, 7), Is.Not.EqualTo(First(50, 50, 55, 105, 8)));
    }
}
