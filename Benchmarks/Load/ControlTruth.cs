using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
using Nowpose.Protocol;

namespace Nowpose.Benchmarks.Load;

/// <summary>Converts values of this machine's counter, which both processes share, to the gateway's control time.</summary>
/// <remarks>
/// The offset comes from the exchange with the shortest round-trip time over an idle loopback. Its error is at most half that time.
/// </remarks>
sealed class ControlTruth
{
    const int Exchanges = 150;

    /// <summary>Interval of the exchanges. The gateway closes connections with more than 100 exchanges per second.</summary>
    static readonly TimeSpan Interval = TimeSpan.FromMilliseconds(12);

    readonly long _offsetNs;

    ControlTruth(long offsetNs, TimeSpan bound) => (_offsetNs, Bound) = (offsetNs, bound);

    public TimeSpan Bound { get; }

    public static ControlTruth Measure(IPEndPoint sync)
    {
        using var socket = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp) { NoDelay = true };
        socket.Connect(sync);
        var best = new ControlTruth(0, TimeSpan.MaxValue);
        for (var i = 0u; i < Exchanges; i++)
        {
            var exchange = Exchange(socket, i);
            if (exchange.Bound < best.Bound) best = exchange;
            Thread.Sleep(Interval);
        }

        return best;
    }

    /// <summary>Gets the control time of a <see cref="Stopwatch"/> time stamp, in ns since the epoch.</summary>
    public long NanosecondsAt(long count) => NanosecondsOf(count) + _offsetNs;

    static ControlTruth Exchange(Socket socket, uint sequence)
    {
        var frame = new byte[SyncFrame.Size];
        SyncFrame.Request(sequence, 1).Write(frame);
        var sent = Stopwatch.GetTimestamp();
        socket.Send(frame);
        for (var read = 0; read < frame.Length;)
        {
            var more = socket.Receive(frame.AsSpan(read));
            if (more == 0) throw new InputException("the gateway closed the clock sync");
            read += more;
        }

        var (t1, t4) = (NanosecondsOf(sent), NanosecondsOf(Stopwatch.GetTimestamp()));
        if (!SyncFrame.TryRead(frame, out var reply, out var fault)) throw new InputException($"the gateway's sync reply: {fault}");
        return new ControlTruth((reply.T2Ns - t1 + reply.T3Ns - t4) / 2, new TimeSpan((t4 - t1 - (reply.T3Ns - reply.T2Ns)) / 200));
    }

    static long NanosecondsOf(long count) => (long)((Int128)count * 1_000_000_000 / Stopwatch.Frequency);
}
