using System.Text;
using Nowpose.Benchmarks.Load;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Benchmarks;

/// <summary>Tests that the load measurement reads and counts the received messages exactly.</summary>
public class LoadMeasureTests
{
    static readonly ControlTime Stamp = ControlTime.FromNanoseconds(5_000_000_123_400);

    static byte[] Message => Encoding.UTF8.GetBytes(
        RosbridgeWriter.Publish(RosTopics.JointStates, new JointStateMessage(Stamp, ["a"], [1]), RosTimeForm.Sec));

    [Test]
    public void TryRead_JointState_ReturnsItsTimeStamp()
    {
        Assert.That(StampReader.TryRead(Message, out var nanoseconds));
        Assert.That(nanoseconds, Is.EqualTo(Stamp.Nanoseconds));
    }

    [Test]
    public void TryRead_OtherMessage_ReturnsFalse()
    {
        Assert.That(StampReader.TryRead("{\"op\":\"status\",\"level\":\"error\",\"msg\":\"\"}"u8, out _), Is.False);
    }

    [Test]
    public void Quantile_HundredLatencies_IsAccurateToTenMicroseconds()
    {
        var counts = new LatencyCounts();
        for (var i = 1; i <= 100; i++) counts.Add(i * 1_000_000L);

        Assert.That(counts.Quantile(0.5).TotalMilliseconds, Is.EqualTo(50).Within(0.011));
        Assert.That(counts.Quantile(0.99).TotalMilliseconds, Is.EqualTo(99).Within(0.011));
        Assert.That(counts.Maximum.TotalMilliseconds, Is.EqualTo(100));
    }

    [Test]
    public void Ratio_LoadOfTheMachineChanges_EqualsTheRatioOfTheBuilds()
    {
        // The load differs in each round, and the fourth round has an outlier.
        double[] loads = [1, 4, 9, 2, 16];
        static LoadResult Result(double p99Ms) => new(200, 50, 10, 0, 0, 0, 0, 0, 1, p99Ms, 20, 0, 0, 0, 0, 0, 0, 0, 0);

        var comparison = new LoadComparison([.. loads.Select((load, i) => (Result(1.1 * load * (i == 3 ? 5 : 1)), Result(load)))]);

        Assert.That(comparison.Ratio, Is.EqualTo(1.1).Within(1e-9));
    }

    [Test]
    public void MemoryWatch_GrowingMemory_ExceedsTheLimit()
    {
        var (flat, growing) = (new MemoryWatch(), new MemoryWatch());
        for (var second = 0; second < 300; second++)
        {
            // The memory has a sawtooth shape, as with a garbage collection every few seconds.
            flat.Add(100_000_000 + (second % 7 * 3_000_000));
            growing.Add(100_000_000 + (second * 60_000));
        }

        Assert.That(flat.Deviation, Is.LessThan(0.02));
        Assert.That(growing.Deviation, Is.GreaterThan(0.05));
    }
}
