using System;
using System.Buffers.Binary;

namespace Nowpose.Protocol
{
    /// <summary>Kind of a sync frame; the values are the bytes on the wire.</summary>
    enum SyncFrameKind : byte
    {
        /// <summary>A request from the headset, with t1.</summary>
        Request = 1,

        /// <summary>A reply from the server, with the echoed t1, t2 and t3.</summary>
        Reply = 2,

        /// <summary>Announces a token, which follows the frame (<see cref="SyncToken"/>).</summary>
        Token = 0x10,

        /// <summary>Reports whether the token was accepted.</summary>
        TokenReply = 0x11,
    }

    /// <summary>One frame of the clock sync protocol: 48 bytes, little-endian, the same layout in both directions.</summary>
    /// <remarks>
    /// Times are raw nanoseconds: t1 on the headset clock C2, t2 and t3 on the control clock C1. They come from the wire, so any
    /// value is possible; the code that creates an exchange from them checks their order.
    /// </remarks>
    readonly struct SyncFrame
    {
        /// <summary>Size of a frame in bytes.</summary>
        public const int Size = 48;

        /// <summary>Magic number at the start of each frame: the bytes "SYNC".</summary>
        public const uint Magic = 0x434E5953;

        public const byte Version = 1;

        /// <summary>Bit 0 of the flags of a reply: the server's own control clock is not synchronised.</summary>
        public const ushort NotSynchronisedFlag = 1;

        /// <summary>Bit 0 of the flags of a token reply: the token is accepted.</summary>
        public const ushort AcceptedFlag = 1;

        public SyncFrame(
            SyncFrameKind kind, ushort flags, uint sequence, uint errorBoundUs, long t1Ns, long t2Ns, long t3Ns, uint resolutionNs)
        {
            Kind = kind;
            Flags = flags;
            Sequence = sequence;
            ErrorBoundUs = errorBoundUs;
            T1Ns = t1Ns;
            T2Ns = t2Ns;
            T3Ns = t3Ns;
            ResolutionNs = resolutionNs;
        }

        public SyncFrameKind Kind { get; }
        public ushort Flags { get; }
        public uint Sequence { get; }

        /// <summary>Error bound of C1 as stated by the server, in µs; <see cref="uint.MaxValue"/> for larger values.</summary>
        public uint ErrorBoundUs { get; }

        /// <summary>t1: time on C2 at which the request was sent, in ns.</summary>
        public long T1Ns { get; }

        /// <summary>t2: time on C1 at which the request arrived, in ns.</summary>
        public long T2Ns { get; }

        /// <summary>t3: time on C1 just before the reply was sent, in ns.</summary>
        public long T3Ns { get; }

        /// <summary>Resolution of C1, in ns; 0 if unknown. A <see cref="Sync.SyncExchange"/> adds half of it to t2 and to t3.</summary>
        public uint ResolutionNs { get; }

        /// <summary>Whether the server's control clock follows its own reference; valid for a reply.</summary>
        public bool IsServerSynchronised => (Flags & NotSynchronisedFlag) == 0;

        /// <summary>Whether the token is accepted; valid for a token reply.</summary>
        public bool IsAccepted => (Flags & AcceptedFlag) != 0;

        public static SyncFrame Request(uint sequence, long t1Ns) =>
            new SyncFrame(SyncFrameKind.Request, 0, sequence, 0, t1Ns, 0, 0, 0);

        /// <summary>Creates the reply to <paramref name="request"/> with its sequence and t1.</summary>
        /// <param name="errorBound">Error bound of C1 as stated by the server; saturates at 2³²−1 µs.</param>
        public static SyncFrame Reply(
            in SyncFrame request, long t2Ns, long t3Ns, bool isSynchronised, TimeSpan errorBound, uint resolutionNs) =>
            new SyncFrame(
                SyncFrameKind.Reply, isSynchronised ? (ushort)0 : NotSynchronisedFlag, request.Sequence,
                Microseconds(errorBound), request.T1Ns, t2Ns, t3Ns, resolutionNs);

        /// <summary>Creates the frame that precedes a token.</summary>
        public static SyncFrame Token() => new SyncFrame(SyncFrameKind.Token, 0, 0, 0, 0, 0, 0, 0);

        public static SyncFrame TokenReply(bool isAccepted) =>
            new SyncFrame(SyncFrameKind.TokenReply, isAccepted ? AcceptedFlag : (ushort)0, 0, 0, 0, 0, 0, 0);

        /// <summary>Reads exactly one frame; never throws.</summary>
        public static bool TryRead(ReadOnlySpan<byte> bytes, out SyncFrame frame, out SyncFrameFault fault)
        {
            fault = FaultOf(bytes);
            frame = fault == SyncFrameFault.None ? Read(bytes) : default;
            return fault == SyncFrameFault.None;
        }

        /// <summary>Writes the frame into the first <see cref="Size"/> bytes of <paramref name="bytes"/>.</summary>
        /// <exception cref="ArgumentOutOfRangeException"><paramref name="bytes"/> is shorter than a frame.</exception>
        public void Write(Span<byte> bytes)
        {
            BinaryPrimitives.WriteUInt32LittleEndian(bytes, Magic);
            bytes[4] = Version;
            bytes[5] = (byte)Kind;
            BinaryPrimitives.WriteUInt16LittleEndian(bytes.Slice(6), Flags);
            BinaryPrimitives.WriteUInt32LittleEndian(bytes.Slice(8), Sequence);
            BinaryPrimitives.WriteUInt32LittleEndian(bytes.Slice(12), ErrorBoundUs);
            BinaryPrimitives.WriteInt64LittleEndian(bytes.Slice(16), T1Ns);
            BinaryPrimitives.WriteInt64LittleEndian(bytes.Slice(24), T2Ns);
            BinaryPrimitives.WriteInt64LittleEndian(bytes.Slice(32), T3Ns);
            BinaryPrimitives.WriteUInt32LittleEndian(bytes.Slice(40), ResolutionNs);
            BinaryPrimitives.WriteUInt32LittleEndian(bytes.Slice(44), 0);
        }

        static SyncFrameFault FaultOf(ReadOnlySpan<byte> bytes)
        {
            if (bytes.Length != Size) return SyncFrameFault.WrongSize;
            if (BinaryPrimitives.ReadUInt32LittleEndian(bytes) != Magic) return SyncFrameFault.WrongMagic;
            if (bytes[4] != Version) return SyncFrameFault.WrongVersion;
            return IsKind(bytes[5]) ? SyncFrameFault.None : SyncFrameFault.WrongKind;
        }

        static bool IsKind(byte kind) =>
            kind == (byte)SyncFrameKind.Request || kind == (byte)SyncFrameKind.Reply ||
            kind == (byte)SyncFrameKind.Token || kind == (byte)SyncFrameKind.TokenReply;

        static SyncFrame Read(ReadOnlySpan<byte> bytes) => new SyncFrame(
            (SyncFrameKind)bytes[5],
            BinaryPrimitives.ReadUInt16LittleEndian(bytes.Slice(6)),
            BinaryPrimitives.ReadUInt32LittleEndian(bytes.Slice(8)),
            BinaryPrimitives.ReadUInt32LittleEndian(bytes.Slice(12)),
            BinaryPrimitives.ReadInt64LittleEndian(bytes.Slice(16)),
            BinaryPrimitives.ReadInt64LittleEndian(bytes.Slice(24)),
            BinaryPrimitives.ReadInt64LittleEndian(bytes.Slice(32)),
            BinaryPrimitives.ReadUInt32LittleEndian(bytes.Slice(40)));

        // Rounds up: a bound may be too large, but never too small.
        static uint Microseconds(TimeSpan length)
        {
            const long TicksPerMicrosecond = TimeSpan.TicksPerMillisecond / 1000;
            var microseconds = length.Ticks / TicksPerMicrosecond + (length.Ticks % TicksPerMicrosecond > 0 ? 1 : 0);
            return (uint)Math.Max(0, Math.Min(uint.MaxValue, microseconds));
        }
    }

    /// <summary>Reason why bytes are not a sync frame. The connection is closed after each fault.</summary>
    enum SyncFrameFault
    {
        None,
        WrongSize,
        WrongMagic,
        WrongVersion,
        WrongKind,
    }
}
