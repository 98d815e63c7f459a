using NUnit.Framework;
using Nowpose.Gateway.Rosbridge;

namespace Nowpose.Headless.Tests.Gateway;

public class FragmentCounterTests
{
    const int Seed = 5;

    [Test]
    public void Feed_PongInPieces_ReturnsItsUnmaskedPayload()
    {
        var pongs = new List<byte[]>();
        var counter = new FragmentCounter { Pong = payload => pongs.Add(payload.ToArray()) };
        byte[] mask = [7, 11, 13, 17], payload = [1, 2, 3, 4, 5, 6, 7, 8];
        byte[] masked = [.. payload.Select((one, i) => (byte)(one ^ mask[i % 4]))];
        byte[] frames = [0x8A, 0x88, .. mask, .. masked, 0x81, 0x81, .. mask, 42, 0x8A, 0x80, .. mask, 0x8A, 0x88, .. mask, .. masked];

        foreach (var one in frames) counter.Feed([one]);
        counter.Feed(frames);

        Assert.That(pongs, Is.EqualTo(Enumerable.Repeat(payload, 4)), "the pong without payload is ignored");
        Assert.That((counter.Take(), counter.Take(), counter.Take()), Is.EqualTo((1, 1, 0)));
    }

    [Test]
    public void Take_RandomFramesInRandomPieces_CountsTheFragmentsOfEachMessage()
    {
        var random = new Random(Seed);
        var bytes = new List<byte>();
        var expected = new List<int>();
        for (var message = 0; message < 200; message++)
        {
            var count = random.Next(1, 6);
            expected.Add(count);
            for (var i = 0; i < count; i++)
            {
                if (random.Next(3) == 0)
                    Frame(bytes, random, 0x89, random.Next(126)); // a ping between fragments
                Frame(bytes, random, (i == count - 1 ? 0x80 : 0) | (i == 0 ? 1 : 0), LengthOf(random));
            }
        }

        var counter = new FragmentCounter();
        var counted = new List<int>();
        for (var at = 0; at < bytes.Count;)
        {
            var piece = Math.Min(random.Next(1, 3000), bytes.Count - at);
            counter.Feed(bytes.GetRange(at, piece).ToArray());
            at += piece;
            for (var fragments = counter.Take(); fragments > 0; fragments = counter.Take())
                counted.Add(fragments);
        }

        Assert.That(counted, Is.EqualTo(expected), $"seed {Seed}");
    }

    static int LengthOf(Random random) => random.Next(4) switch
    {
        0 => 0,
        1 => random.Next(126),
        2 => random.Next(126, 2000),
        _ => random.Next(65536, 70_000),
    };

    // Adds a frame (RFC 6455, 5.2) with a mask, like a frame from a client. Mask and payload are random bytes.
    static void Frame(List<byte> into, Random random, int first, int length)
    {
        into.Add((byte)first);
        if (length < 126)
            into.Add((byte)(0x80 | length));
        else if (length < 65536)
            into.AddRange([0x80 | 126, (byte)(length >> 8), (byte)length]);
        else
            into.AddRange([0x80 | 127, 0, 0, 0, 0, 0, (byte)(length >> 16), (byte)(length >> 8), (byte)length]);
        var rest = new byte[4 + length];
        random.NextBytes(rest);
        into.AddRange(rest);
    }
}
