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

    [TestCase(1)]
    [TestCase(7)]
    [TestCase(1000)]
    public void FrameReader_PiecesOfAnyLength_ReadsAllFrames(int pieceLength)
    {
        // The frames have no mask, like the frames of a server.
        byte[] frame = [0x81, (byte)126, (byte)(Message.Length >> 8), (byte)Message.Length, .. Message];
        byte[] stream = [.. frame, 0x89, 2, 1, 2, .. frame];
        var reader = new FrameReader();
        var (stamps, pings) = (new List<long>(), 0);

        foreach (var piece in stream.Chunk(pieceLength))
        {
            piece.CopyTo(reader.Room);
            reader.Added(piece.Length);
            var at = 0;
            while (reader.TryTake(ref at, out var opcode, out var payload))
            {
                if (opcode == FrameReader.Ping) pings++;
                else if (FrameReader.TryReadStamp(payload, out var stamp)) stamps.Add(stamp);
            }

            reader.Discard(at);
        }

        Assert.That(Message.Length, Is.GreaterThan(125), "the message is long enough for the longer frame header");
        Assert.That(stamps, Is.EqualTo(new[] { Stamp.Nanoseconds, Stamp.Nanoseconds }));
        Assert.That(pings, Is.EqualTo(1));
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
