using System.Net.WebSockets;
using System.Text;
using Nowpose.Gateway;
using Nowpose.Gateway.Security;
using Nowpose.Network;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests;

public class NativeWebSocketLinkTests
{
    static readonly StopwatchHeadsetClock Clock = new();

    static NativeWebSocketLink Link(int port, string token = null, IHeadsetClock clock = null) =>
        new(new ConnectionSettings("127.0.0.1", webSocketPort: port, token: token), clock ?? Clock);

    static async Task<(NativeWebSocketLink Link, WebSocket Server)> OpenAsync(FakeWebSocketServer server, IHeadsetClock clock = null)
    {
        var link = Link(server.Port, clock: clock);
        var opening = link.OpenAsync(default);
        var socket = await server.AcceptAsync();
        await opening.Bounded();
        return (link, socket);
    }

    static Task Send(WebSocket socket, string text, bool end = true) =>
        socket.SendAsync(Encoding.UTF8.GetBytes(text), WebSocketMessageType.Text, end, CancellationToken.None);

    sealed record Message(string Text, DropReason Dropped, HeadsetTime Arrival);

    /// <summary>Returns the next message; null at the end.</summary>
    static async Task<Message> NextAsync(NativeWebSocketLink link, CancellationToken cancel = default)
    {
        using var stop = CancellationTokenSource.CreateLinkedTokenSource(cancel);
        Message next = null;
        try
        {
            await link.ReceiveAsync(received =>
            {
                var text = received.Dropped == DropReason.None ? Encoding.UTF8.GetString(received.Utf8.Span) : null;
                next = new Message(text, received.Dropped, received.Arrival);
                stop.Cancel();
            }, stop.Token).Bounded();
        }
        catch (OperationCanceledException) when (next != null)
        {
            // Only the first message is needed.
        }
        return next;
    }

    [Test]
    public async Task Gateway_PublishesASample_ArrivesAsText()
    {
        await using var gateway = await Gateways.StartAsync();
        using var link = Link(gateway.WebSocketEndPoint.Port);
        await link.OpenAsync(default).Bounded();
        await link.SendAsync(RosbridgeWriter.Subscribe(RosTopics.JointStates), default);
        await link.SendAsync(RosbridgeWriter.CallService(RosTopics.GetTime), default);
        var subscribed = await NextAsync(link);
        using var source = gateway.Hub.OpenSource();

        source.TryPublish(Gateways.State(0.5, "a"));

        Assert.That(subscribed.Text, Does.Contain("service_response"));
        Assert.That((await NextAsync(link)).Text, Is.EqualTo(Gateways.StateText(0.5)));
    }

    [Test]
    public async Task Message_FetchedLate_HasItsArrivalTime()
    {
        using var server = new FakeWebSocketServer();
        var clock = new ObservedClock { Now = HeadsetTime.FromSeconds(1) };
        var (link, socket) = await OpenAsync(server, clock);

        await Send(socket, "first");
        await clock.ReadAsync();
        clock.Now = HeadsetTime.FromSeconds(2);
        await Send(socket, "second");
        await clock.ReadAsync();
        clock.Now = HeadsetTime.FromSeconds(3);

        Assert.That((await NextAsync(link)).Arrival, Is.EqualTo(HeadsetTime.FromSeconds(1)));
        Assert.That((await NextAsync(link)).Arrival, Is.EqualTo(HeadsetTime.FromSeconds(2)));
        link.Dispose();
    }

    [Test]
    public async Task Link_OpenedOnTheMainThread_DoesNotWaitForAFrame()
    {
        using var server = new FakeWebSocketServer();
        var frame = new FrameContext();
        var clock = new ObservedClock();
        using var link = Link(server.Port, clock: clock);
        var opening = frame.Run(() => link.OpenAsync(default));
        var socket = await server.AcceptAsync();
        await opening.Bounded();

        await Send(socket, "message");
        await clock.ReadAsync();

        Assert.That((await NextAsync(link)).Text, Is.EqualTo("message"));
        Assert.That(frame.Posts, Is.EqualTo(0));
    }

    [TestCase(0, DropReason.None)]
    [TestCase(1, DropReason.TooLarge)]
    public async Task Message_LongerThanAMebibyte_IsRefusedAndTheNextAccepted(int over, object expected)
    {
        using var server = new FakeWebSocketServer();
        var (link, socket) = await OpenAsync(server);
        using (link)
        {
            await Send(socket, new string('x', ProtocolLimits.DescriptionBytes / 2), end: false);
            await Send(socket, new string('x', ProtocolLimits.DescriptionBytes / 2 + over));
            await Send(socket, "next");

            var message = await NextAsync(link);

            Assert.That(message.Dropped, Is.EqualTo((DropReason)expected));
            Assert.That(message.Text?.Length, (DropReason)expected == DropReason.None ? Is.EqualTo(ProtocolLimits.DescriptionBytes) : Is.Null);
            Assert.That((await NextAsync(link)).Text, Is.EqualTo("next"));
        }
    }

    [Test]
    public async Task Messages_NotFetched_OldestAreDroppedAndCounted()
    {
        const int Sent = 100;
        using var server = new FakeWebSocketServer();
        var clock = new ObservedClock();
        var (link, socket) = await OpenAsync(server, clock);
        using (link)
        {
            for (var i = 0; i < Sent; i++) await Send(socket, "message " + i);
            for (var i = 0; i < Sent; i++) await clock.ReadAsync();

            var received = new List<Message>();
            for (var i = 0; i < Sent; i++) received.Add(await NextAsync(link));

            var kept = received.Where(message => message.Text != null).Select(message => message.Text).ToList();
            Assert.That(received.Take(Sent - kept.Count).Select(message => message.Dropped), Is.All.EqualTo(DropReason.SlowReader));
            Assert.That(kept, Is.EqualTo(Enumerable.Range(Sent - kept.Count, kept.Count).Select(i => "message " + i)));
            Assert.That(kept, Has.Count.InRange(10, 90), "a queue, but a bounded one");
        }
    }

    [TestCase(Gateways.ObserverToken, null)]
    [TestCase("guessed", "the gateway does not accept this headset's token (401)")]
    [TestCase(null, "the gateway does not accept this headset's token (401)")]
    public async Task Open_WithToken_SendsItAsAHeader(string token, string refusal)
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { Tokens = Gateways.Tokens });
        using var link = Link(gateway.WebSocketEndPoint.Port, token);

        var failure = await FailureOf(link.OpenAsync(default));

        Assert.That(failure?.Message, Is.EqualTo(refusal));
        Assert.That(failure, Is.Null.Or.TypeOf<GatewayRefusalException>());
    }

    [Test]
    public async Task Certificate_NotTrustedByTheDevice_IsRefused()
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { Certificate = CertificateFiles.Generate() });
        var settings = new ConnectionSettings("127.0.0.1", webSocketPort: gateway.WebSocketEndPoint.Port, deviceTrust: true);
        using var link = new NativeWebSocketLink(settings, Clock);

        Assert.That(await FailureOf(link.OpenAsync(default)), Is.TypeOf<GatewayRefusalException>());
        Assert.That(gateway.WebSocketConnections.Open, Is.EqualTo(0));
    }

    [Test]
    public void Constructor_SettingsWithAPin_Throws()
    {
        var settings = new ConnectionSettings("127.0.0.1", pin: CertificatePin.Of(CertificateFiles.Generate()));

        Assert.That(() => new NativeWebSocketLink(settings, Clock), Throws.ArgumentException.With.Message.Contains("pin"));
    }

    [Test]
    public async Task Open_ConnectionRefused_Throws()
    {
        int port;
        using (var server = new FakeWebSocketServer()) port = server.Port;
        using var link = Link(port);

        Assert.That(await FailureOf(link.OpenAsync(default)), Is.TypeOf<GatewayRefusalException>());
    }

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
    public async Task Receive_Cancelled_Ends()
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
            Assert.That(await NextAsync(link), Is.Null, "and stays so");
        }
    }

    [Test]
    public async Task Receive_ConnectionLost_FailsLikeSending()
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
    public async Task Dispose_ServerDoesNotAnswerTheClose_Ends()
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
    public async Task Links_HundredOpenedAndClosed_LeaveNoThreadsOrConnections()
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
        var before = Threads();

        await Cycle(100);

        Assert.That(Threads(), Is.LessThan(before + 10), "the pool may have grown, a thread for each may not");
    }

    static int Threads()
    {
        using var process = System.Diagnostics.Process.GetCurrentProcess();
        return process.Threads.Count;
    }

    static async Task<Exception> FailureOf(Task task)
    {
        try
        {
            await task.Bounded();
            return null;
        }
        catch (Exception failure) when (failure is not TimeoutException)
        {
            return failure;
        }
    }
}
