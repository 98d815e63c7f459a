using System;
using NUnit.Framework;
using Nowpose.Protocol;

namespace Nowpose.Tests.Core.Protocol
{
    public class SyncFrameTests
    {
        // These bytes were written by hand from the frame table of the protocol.
        static readonly byte[] GoldenReply =
        {
            0x53, 0x59, 0x4E, 0x43, // "SYNC"
            0x01, 0x02, // version, kind
            0x01, 0x00, // flags: not synchronised
            0x0D, 0x0C, 0x0B, 0x0A, // sequence
            0xFA, 0x00, 0x00, 0x00, // 250 µs
            0x08, 0x07, 0x06, 0x05, 0x04, 0x03, 0x02, 0x01, // t1
            0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, // t2 = -1
            0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, // t3 = minimum value
            0x40, 0x42, 0x0F, 0x00, // 1 000 000 ns
            0x00, 0x00, 0x00, 0x00,
        };

        static byte[] BytesOf(SyncFrame frame)
        {
            var bytes = new byte[SyncFrame.Size];
            frame.Write(bytes);
            return bytes;
        }

        [Test]
        public void Write_Reply_MatchesTheDocumentedBytes()
        {
            var request = SyncFrame.Request(0x0A0B0C0D, 0x0102030405060708);

            var reply = SyncFrame.Reply(request, -1, long.MinValue, false, Lengths.Ms(0.25), 1_000_000);

            Assert.That(BytesOf(reply), Is.EqualTo(GoldenReply));
        }

        [Test]
        public void TryRead_GoldenReply_ReturnsItsFields()
        {
            Assert.That(SyncFrame.TryRead(GoldenReply, out var frame, out _), Is.True);

            Assert.That(frame.Kind, Is.EqualTo(SyncFrameKind.Reply));
            Assert.That(frame.IsServerSynchronised, Is.False);
            Assert.That(frame.Sequence, Is.EqualTo(0x0A0B0C0Du));
            Assert.That(frame.ErrorBoundUs, Is.EqualTo(250u));
            Assert.That(new[] { frame.T1Ns, frame.T2Ns, frame.T3Ns }, Is.EqualTo(new[] { 0x0102030405060708, -1, long.MinValue }));
            Assert.That(frame.ResolutionNs, Is.EqualTo(1_000_000u));
        }

        [Test]
        public void TryRead_WrittenFrame_RoundTrips()
        {
            const int Seed = 11;
            var random = new Random(Seed);
            var kinds = new[] { SyncFrameKind.Request, SyncFrameKind.Reply, SyncFrameKind.Token, SyncFrameKind.TokenReply };
            for (var i = 0; i < 1000; i++)
            {
                var frame = new SyncFrame(
                    kinds[random.Next(4)], (ushort)random.Next(65536), (uint)random.Next(), (uint)random.Next(),
                    Long(random), Long(random), Long(random), (uint)random.Next());

                Assert.That(SyncFrame.TryRead(BytesOf(frame), out var read, out _), Is.True);
                Assert.That(read, Is.EqualTo(frame), "frame " + i + ", seed " + Seed);
            }
        }

        [TestCase(0, SyncFrameFault.WrongMagic)]
        [TestCase(3, SyncFrameFault.WrongMagic)]
        [TestCase(4, SyncFrameFault.WrongVersion)]
        [TestCase(5, SyncFrameFault.WrongKind)]
        public void TryRead_OneByteWrong_ReturnsTheFault(int at, object expected)
        {
            var bytes = (byte[])GoldenReply.Clone();
            bytes[at] ^= 0x40;

            Assert.That(SyncFrame.TryRead(bytes, out _, out var fault), Is.False);
            Assert.That(fault, Is.EqualTo((SyncFrameFault)expected));
        }

        [TestCase(0)]
        [TestCase(47)]
        [TestCase(49)]
        public void TryRead_WrongSize_IsRefused(int size)
        {
            var bytes = new byte[size];
            Array.Copy(GoldenReply, bytes, Math.Min(size, SyncFrame.Size));

            Assert.That(SyncFrame.TryRead(bytes, out _, out var fault), Is.False);
            Assert.That(fault, Is.EqualTo(SyncFrameFault.WrongSize));
        }

        [Test]
        public void Reply_ErrorBoundAboveTheMaximum_Saturates()
        {
            var reply = SyncFrame.Reply(SyncFrame.Request(1, 2), 3, 4, true, TimeSpan.FromHours(2), 0);

            Assert.That(reply.ErrorBoundUs, Is.EqualTo(uint.MaxValue));
        }

        [Test]
        public void Reply_ErrorBoundBetweenMicroseconds_IsRoundedUp()
        {
            var reply = SyncFrame.Reply(SyncFrame.Request(1, 2), 3, 4, true, new TimeSpan(11), 0);

            Assert.That(reply.ErrorBoundUs, Is.EqualTo(2u));
        }

        [Test]
        public void TokenReply_Accepted_SetsBitZero()
        {
            Assert.That(SyncFrame.TokenReply(true).Flags & 1, Is.EqualTo(1));
            Assert.That(SyncFrame.TokenReply(true).IsAccepted, Is.True);
            Assert.That(SyncFrame.TokenReply(false).IsAccepted, Is.False);
        }

        static long Long(Random random)
        {
            var bytes = new byte[8];
            random.NextBytes(bytes);
            return BitConverter.ToInt64(bytes, 0);
        }
    }
}
