using System.Collections.Concurrent;
using System.Diagnostics;
using System.Net.Sockets;
using Nowpose.Gateway.Clock;
using Nowpose.Simulation;

namespace Nowpose.Cli.Demo;

/// <summary>One relayed connection. In each direction, data are read immediately and written after their delay.</summary>
sealed class RelayedConnection : IDisposable
{
    readonly TcpClient _headset;
    readonly TcpClient _gateway;

    public RelayedConnection(TcpClient headset, TcpClient gateway, PathDelay up, PathDelay down)
    {
        _headset = headset;
        _gateway = gateway;
        Start(headset, gateway, up, "relay up");
        Start(gateway, headset, down, "relay down");
    }

    public void Dispose()
    {
        _headset.Dispose();
        _gateway.Dispose();
    }

    void Start(TcpClient from, TcpClient to, PathDelay delay, string name)
    {
        var underway = new BlockingCollection<Piece>();
        Run(name + " read", () => Read(from, delay, underway), underway.CompleteAdding);
        Run(name + " write", () => Write(to, underway), Dispose);
    }

    static void Read(TcpClient from, PathDelay delay, BlockingCollection<Piece> underway)
    {
        var buffer = new byte[64 * 1024];
        var times = new PacketTimes(delay);
        for (int read; (read = from.GetStream().Read(buffer)) > 0;)
            underway.Add(new Piece(buffer[..read], times.DueAt(Stopwatch.GetTimestamp())));
    }

    static void Write(TcpClient to, BlockingCollection<Piece> underway)
    {
        foreach (var piece in underway.GetConsumingEnumerable())
        {
            PreciseWait.Until(piece.DueCount);
            to.GetStream().Write(piece.Bytes);
        }
    }

    static void Run(string name, Action work, Action atTheEnd) =>
        new Thread(() => Guarded(work, atTheEnd)) { IsBackground = true, Name = name }.Start();

    static void Guarded(Action work, Action atTheEnd)
    {
        try
        {
            work();
        }
        catch (Exception end) when (end is IOException or SocketException or ObjectDisposedException or InvalidOperationException)
        {
            // One end closed its connection. The other connection is closed below.
        }
        finally
        {
            atTheEnd();
        }
    }

    /// <param name="DueCount">Value of the <see cref="Stopwatch"/> counter at which the piece is written.</param>
    readonly record struct Piece(byte[] Bytes, long DueCount);
}
