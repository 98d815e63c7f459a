using System.Net.WebSockets;
using Nowpose.Protocol;
using NUnit.Framework;
using static Nowpose.Headless.Tests.NativeLinks;

namespace Nowpose.Headless.Tests;

/// <summary>Tests the end of a link that is cancelled, closed by the server, lost or disposed.</summary>
public class NativeWebSocketEndTests
{
    [Test]
    public async Task Open_CancelledDuringTheHandshake_EndsImmediately()
    {
        using var server = new SilentServer();
        using var link = Link(server.Port);
        using var cancel = new CancellationTokenSource();
        var opening = link.OpenAsync(cancel.Token);
        await server.AskedAsync();

        cancel.Cancel();

        Assert.That(await FailureOf(opening), Is.InstanceOf<OperationCanceledException>());
        await server.EndAsync();
    }

    [Test]
    public async Task Open_AlreadyCancelled_DoesNotConnect()
    {
        using var server = new SilentServer();
        using var link = Link(server.Port);

        Assert.That(await FailureOf(link.OpenAsync(new CancellationToken(true))), Is.InstanceOf<OperationCanceledException>());
        Assert.That(server.HasCaller, Is.False);
    }

    [Test]
    public async Task Receive_Cancelled_ThrowsAndKeepsTheLinkOpen()
    {
        using var server = new FakeWebSocketServer();
        var (link, socket) = await OpenAsync(server);
        using (link)
        using (var cancel = new CancellationTokenSource())
        {
            var receiving = NextAsync(link, cancel.Token);

            cancel.Cancel();

            Assert.That(await FailureOf(receiving), Is.InstanceOf<OperationCanceledException>());
            await Send(socket, "later");
            Assert.That((await NextAsync(link)).Text, Is.EqualTo("later"));
        }
    }

    [Test]
    public async Task Receive_ServerCloses_EndsAfterTheLastMessage()
    {
        using var server = new FakeWebSocketServer();
        var (link, socket) = await OpenAsync(server);
        using (link)
        {
            await Send(socket, "last");
            await socket.CloseOutputAsync(WebSocketCloseStatus.NormalClosure, "", default);

            Assert.That((await NextAsync(link)).Text, Is.EqualTo("last"));
            Assert.That(await NextAsync(link), Is.Null);
            Assert.That(await NextAsync(link), Is.Null, "another read also returns null");
        }
    }

    [Test]
    public async Task ReceiveAndSend_ConnectionLost_ThrowIOException()
    {
        using var server = new FakeWebSocketServer();
        var link = Link(server.Port);
        var opening = link.OpenAsync(default);
        var stream = await server.AcceptStreamAsync();
        await opening.Bounded();

        stream.Close();

        Assert.That(await FailureOf(NextAsync(link)), Is.InstanceOf<IOException>());
        Assert.That(await FailureOf(link.SendAsync("text", default)), Is.InstanceOf<IOException>());
        link.Dispose();
    }

    [Test]
    public async Task Dispose_Open_SendsACloseFrameAndEndsTheReader()
    {
        using var server = new FakeWebSocketServer();
        var (link, socket) = await OpenAsync(server);
        var receiving = NextAsync(link);

        link.Dispose();
        link.Dispose();

        Assert.That(await receiving, Is.Null);
        var goodbye = await socket.ReceiveAsync(new byte[100], default).Bounded();
        Assert.That(goodbye.CloseStatus, Is.EqualTo(WebSocketCloseStatus.NormalClosure));
    }

    [Test]
    public async Task Dispose_ServerDoesNotAnswerTheCloseFrame_ClosesTheConnection()
    {
        using var server = new FakeWebSocketServer();
        var link = Link(server.Port);
        var opening = link.OpenAsync(default);
        var stream = await server.AcceptStreamAsync();
        await opening.Bounded();

        link.Dispose();

        var rest = new byte[1000];
        while (await stream.ReadAsync(rest).AsTask().Bounded() > 0) { }
    }

    [Test]
    public async Task Dispose_AtAnyTime_LeavesNoConnection([Range(0, 15)] int moment)
    {
        await using var gateway = await Gateways.StartAsync();
        var link = Link(gateway.WebSocketEndPoint.Port);

        var opening = Task.Run(() => link.OpenAsync(default));
        Thread.SpinWait(moment * moment * 2000);
        link.Dispose();

        await FailureOf(opening);
        await Soon.BecomesAsync(() => gateway.WebSocketConnections.Open == 0, "no connection at the gateway");
        Assert.That(await NextAsync(link), Is.Null);
    }

    [Test]
    public async Task Links_ManyOpenedAndClosed_LeaveNoThreadsOrConnections()
    {
        await using var gateway = await Gateways.StartAsync();
        async Task Cycle(int count)
        {
            for (var i = 0; i < count; i++)
            {
                using var link = Link(gateway.WebSocketEndPoint.Port);
                await link.OpenAsync(default).Bounded();
                await link.SendAsync(RosbridgeWriter.CallService(RosTopics.GetTime), default);
                await NextAsync(link);
            }
            await Soon.BecomesAsync(() => gateway.WebSocketConnections.Open == 0, "no connection at the gateway");
        }
        await Cycle(20);
        var before = ProcessCounts.Threads();

        await Cycle(100);

        Assert.That(ProcessCounts.Threads(), Is.LessThan(before + 10), "the thread pool may grow, but links must not keep threads");
    }
}
