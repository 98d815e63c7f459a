using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
using System.Text;
using Nowpose.Gateway;
using Nowpose.Gateway.Clock;
using Nowpose.Protocol;
using Nowpose.Session;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Faults;

/// <summary>Tests that a flood of fast or slow connections does not affect a connected headset.</summary>
/// <remarks>These tests run alone, because they count handles and threads of the process, and the flood would disturb other tests.</remarks>
[NonParallelizable]
public class FloodTests
{
    const int Connects = 10_000;
    const int Slow = 500;
    static readonly IPAddress Attacker = IPAddress.Parse("127.0.0.2");

    [Test]
    public async Task Connections_10000InSequence_DoNotLeak()
    {
        var clock = new StopwatchControlClock(Gateways.Start);
        await using var gateway = await Gateways.StartAsync(clock: clock);
        using var cell = FaultCell.In(gateway.Hub, clock);
        using var headset = new FaultHeadset(gateway.SyncEndPoint.Port, gateway.WebSocketEndPoint.Port);
        await headset.BecomesAsync(PoseState.Current);
        await ConnectAsync(gateway, 200);
        var (files, threads) = (ProcessCounts.OpenFiles(), ProcessCounts.Threads());
        var since = Stopwatch.GetTimestamp();

        await ConnectAsync(gateway, Connects);

        TestContext.Out.WriteLine($"{Connects} connects in {Stopwatch.GetElapsedTime(since).TotalSeconds:0.0} s");
        await Soon.BecomesAsync(() => gateway.SyncConnections.Open == 1 && gateway.WebSocketConnections.Open == 1, "only the headset is left");
        // The thread pool ends idle threads only after 20 s, and counting the handles takes milliseconds.
        await Soon.BecomesAsync(() => ProcessCounts.OpenFiles() < files + 50 && ProcessCounts.Threads() < threads + 30,
            () => "no handles and no threads are left", intervalMs: 100);
        await headset.BecomesAsync(() => headset.IsConnected && headset.State == PoseState.Current, "connected and current");
    }

    [TestCase(true)]
    [TestCase(false)]
    public async Task SlowConnections_500_AreClosedWithoutDelayingOthers(bool asksForTokens)
    {
        var options = Gateways.Options() with { TokenTimeout = TimeSpan.FromSeconds(3) };
        if (asksForTokens) options = options with { Tokens = Gateways.Tokens };
        var token = asksForTokens ? Gateways.ObserverToken : null;
        var clock = new StopwatchControlClock(Gateways.Start);
        await using var gateway = await Gateways.StartAsync(options, clock);
        using var cell = FaultCell.In(gateway.Hub, clock);
        using var before = new FaultHeadset(gateway.SyncEndPoint.Port, gateway.WebSocketEndPoint.Port, token: token);
        await before.BecomesAsync(PoseState.Current);
        using var stop = new CancellationTokenSource();

        var attack = Task.WhenAll(Enumerable.Range(0, Slow).Select(i =>
            DripAsync(i % 2 == 0 ? gateway.WebSocketEndPoint : gateway.SyncEndPoint, i % 2 != 0, stop.Token)));
        await Soon.BecomesAsync(() => gateway.SyncConnections[Closure.ConnectionLimit] > 50, "the attack is under way");
        using var meanwhile = new FaultHeadset(gateway.SyncEndPoint.Port, gateway.WebSocketEndPoint.Port, token: token);
        var took = await meanwhile.BecomesAsync(PoseState.Current);

        var which = asksForTokens ? "" : " without tokens";
        Recovery.Print($"slowloris × {Slow}{which}: a headset that connects meanwhile has a current pose after", took);
        await before.BecomesAsync(PoseState.Current);
        // The gateway refuses these connections because their address has too many, or closes them because they send no token in time.
        await attack.WaitAsync(Soon.Limit);
        await Soon.BecomesAsync(() => gateway.SyncConnections.Open == 2 && gateway.WebSocketConnections.Open == 2, "only the headsets are left");
        await before.BecomesAsync(() => before.IsConnected && before.State == PoseState.Current, "connected and current");
        await stop.CancelAsync();
    }

    // Sends single bytes slowly, never a complete request, until the gateway closes the connection.
    static async Task DripAsync(IPEndPoint target, bool isSync, CancellationToken stop)
    {
        using var socket = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp);
        var drops = new byte[SyncFrame.Size * 40];
        // The bytes belong to valid frames, or to the beginning of a valid HTTP header.
        if (isSync) for (var i = 0; i < drops.Length; i += SyncFrame.Size) SyncFrame.Request(1, 2).Write(drops.AsSpan(i, SyncFrame.Size));
        else Encoding.ASCII.GetBytes("GET / HTTP/1.1\r\nHost: localhost\r\nX-Slow: ".PadRight(drops.Length, 'x'), drops);
        try
        {
            socket.Bind(new IPEndPoint(Attacker, 0));
            await socket.ConnectAsync(target, stop);
            var ended = socket.ReceiveAsync(new byte[16], stop).AsTask();
            for (var i = 0; i < drops.Length && !ended.IsCompleted; i++)
            {
                await socket.SendAsync(drops.AsMemory(i, 1), stop);
                await Task.WhenAny(ended, Task.Delay(200, stop));
            }

            await ended;
        }
        catch (Exception end) when (end is SocketException or OperationCanceledException)
        {
            // The gateway has closed the connection.
        }
    }

    static async Task ConnectAsync(GatewayServer gateway, int count)
    {
        for (var i = 0; i < count; i++)
        {
            // Connects to the two ports alternately, and closes each connection with a reset, so that no local port stays in TIME_WAIT.
            using var socket = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp) { LingerState = new LingerOption(true, 0) };
            await socket.ConnectAsync(i % 2 == 0 ? gateway.SyncEndPoint : gateway.WebSocketEndPoint);
            if (i % 4 == 0) await socket.SendAsync(new byte[SyncFrame.Size]);
        }
    }
}
