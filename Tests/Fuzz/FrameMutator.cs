using System.Buffers.Binary;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Fuzz;

/// <summary>Creates sync frames whose fields have boundary values or random values, and byte sequences that are not valid frames.</summary>
static class FrameMutator
{
    static readonly long[] Times =
    [
        0, 1, -1, 100, 999, 1_000_000_000, -1_000_000_000, 1_700_000_000_000_000_000, long.MaxValue, long.MinValue, long.MaxValue - 1,
        long.MinValue + 1, long.MaxValue / 2, long.MinValue / 2, long.MaxValue / 2 + 1, 1L << 32, -(1L << 32),
    ];

    static readonly uint[] Counts = [0, 1, 2, 99, 100, 1_000_000, int.MaxValue, uint.MaxValue, uint.MaxValue - 1, 1u << 31];

    public static byte[] Next(Random random)
    {
        var bytes = new byte[SyncFrame.Size];
        Any(random).Write(bytes);
        // Leaves about three quarters of the frames well-formed, because malformed frames do not pass the first checks.
        switch (random.Next(12))
        {
            case 0: bytes[random.Next(bytes.Length)] ^= (byte)(1 << random.Next(8)); break;
            case 1: random.NextBytes(bytes); break;
            case 2: return bytes[..random.Next(bytes.Length)];
            case 3: return [.. bytes, .. new byte[random.Next(1, 100)]];
            default: break;
        }
        return bytes;
    }

    /// <summary>Creates a reply, mostly with the given sequence number and t1. Its times are near t1 or far from it.</summary>
    public static SyncFrame Reply(Random random, uint sequence, long t1) => new(
        SyncFrameKind.Reply, (ushort)random.Next(4), random.Next(20) == 0 ? Count(random) : sequence, Count(random),
        random.Next(20) == 0 ? Time(random, t1) : t1, Time(random, t1), Time(random, t1), Count(random));

    public static SyncFrame Any(Random random) => new(
        (SyncFrameKind)(random.Next(6) switch { 0 => 1, 1 => 2, 2 => 0x10, 3 => 0x11, 4 => 2, _ => random.Next(256) }), (ushort)random.Next(0x10000),
        Count(random), Count(random), Time(random, 0), Time(random, 0), Time(random, 0), Count(random));

    static uint Count(Random random) => random.Next(3) == 0 ? (uint)random.NextInt64(1L << 32) : Counts[random.Next(Counts.Length)];

    static long Time(Random random, long near)
    {
        switch (random.Next(4))
        {
            case 0: return Times[random.Next(Times.Length)];
            case 1:
                Span<byte> bytes = stackalloc byte[8];
                random.NextBytes(bytes);
                return BinaryPrimitives.ReadInt64LittleEndian(bytes);
            default: return unchecked(near + random.NextInt64(-50_000_000, 50_000_000));
        }
    }
}
