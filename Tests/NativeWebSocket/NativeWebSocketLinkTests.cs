using System.Net.WebSockets;
using Nowpose.Gateway.Security;
using Nowpose.Messages;
using Nowpose.Network;
using Nowpose.Protocol;
using NUnit.Framework;
using static Nowpose.Headless.Tests.NativeLinks;

namespace Nowpose.Headless.Tests;

/// <summary>Tests the opening of a link and the messages that the link receives.</summary>
public class NativeWebSocketLinkTests
{
    [Test]
    public async Task Sample_PublishedByTheGateway_ArrivesAsText()
    {
        await using var gateway = await Gateways.StartAsync();
        using var link = Link(gateway.WebSocketEndPoint.Port);
        await link.OpenAsync(default).Bounded();
        await link.SendAsync(RosbridgeWriter.Subscribe(RosTopics.JointStates), default);
        await link.SendAsync(RosbridgeWriter.CallService(RosTopics.GetTime), default);
        var subscribed = await NextAsync(link);
        using var source = gateway.Hub.OpenSource();

        source.Publish(Gateways.State(0.5, "a"));

        Assert.That(subscribed.Text, Does.Contain("service_response"));
        Assert.That((await NextAsync(link)).Text, Is.EqualTo(Gateways.StateText(0.5)));
    }

    [Test]
    public async Task Message_FetchedLate_KeepsItsArrivalTime()
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
    public async Task Message_LongerThanAMebibyte_IsRefusedAndTheNextIsAccepted(int over, object expected)
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
            Assert.That(kept, Has.Count.InRange(10, 90), "the queue is not empty, but its length is limited");
        }
    }

    [TestCase(Gateways.ObserverToken, null)]
    [TestCase("guessed", ConnectionMessages.TokenNotAcceptedByHttp)]
    [TestCase(null, ConnectionMessages.TokenNotAcceptedByHttp)]
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
}
