using System.Net;
using System.Net.WebSockets;
using System.Text;
using NUnit.Framework;
using Nowpose.Gateway;
using Nowpose.Gateway.Messages;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Gateway;

public class RosbridgeServerTests
{
    [Test]
    public async Task Connections_TooMany_AreAnsweredWith503()
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { MaxConnections = 1 });
        using var first = await RawRosbridgeClient.ConnectAsync(gateway);

        Assert.That(await RefusalAsync(gateway, null), Is.EqualTo(HttpStatusCode.ServiceUnavailable));
        await first.RoundTripAsync();
    }

    [Test]
    public async Task Connections_TooManyOfObservers_LeavePlacesForSourcesAndOperators()
    {
        static string With(string token) => $"Authorization: Bearer {token}\r\n";
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { MaxConnections = 16, Tokens = Gateways.Tokens });
        var clients = new List<RawWebSocket>();
        try
        {
            for (var i = 0; i < 16; i++) clients.Add(await RawWebSocket.OpenAsync(gateway, With(Gateways.ObserverToken)));
            using (var refused = await RawWebSocket.ConnectAsync(gateway))
                Assert.That(await refused.RequestAsync(With(Gateways.ObserverToken) + RawWebSocket.Upgrade), Does.StartWith("HTTP/1.1 503 "));

            foreach (var token in new[] { Gateways.SourceToken, Gateways.OperatorToken }) clients.Add(await RawWebSocket.OpenAsync(gateway, With(token)));

            Assert.That(gateway.WebSocketConnections.Open, Is.EqualTo(18));
        }
        finally
        {
            foreach (var client in clients) client.Dispose();
        }
    }

    [Test]
    public async Task Connections_ManyOfOneHeadset_ReplaceItsOldestOnes()
    {
        await using var gateway = await PairingGateway.StartAsync(isSecure: false);
        var token = (await gateway.ExchangeAsync((await gateway.ShownAsync()).Token, "first")).Token;
        var clients = new List<RawRosbridgeClient>();
        try
        {
            for (var i = 0; i < 20; i++)
            {
                clients.Add(await RawRosbridgeClient.ConnectAsync(gateway.Server, options => options.SetRequestHeader("Authorization", "Bearer " + token)));
                // The gateway has then added this connection, so that it is older than the next one.
                await clients[i].RoundTripAsync();
            }

            await Soon.BecomesAsync(() => gateway.Server.WebSocketConnections[Closure.ConnectionLimit] == 4, "all connections beyond 16 have ended");
            await clients[4].RoundTripAsync();
            await clients[^1].RoundTripAsync();
        }
        finally
        {
            foreach (var client in clients) client.Dispose();
        }
    }

    [Test]
    public async Task Connections_OfOneSourceAboveItsMaximum_AreRefusedAndTheOthersStayOpen()
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { MaxConnections = 4, Tokens = Gateways.Tokens });
        var clients = new List<RawRosbridgeClient>();
        try
        {
            for (var i = 0; i < 5; i++) clients.Add(await ConnectSourceAsync(gateway));

            for (var i = 0; i < 3; i++)
            {
                using var refused = await RawWebSocket.ConnectAsync(gateway);
                await refused.SendAsync(Encoding.ASCII.GetBytes(
                    $"GET / HTTP/1.1\r\n{RawWebSocket.Upgrade}Authorization: Bearer {Gateways.SourceToken}\r\nHost: localhost\r\n\r\n"));
                Assert.That(await refused.ReadToEndAsync(), Does.StartWith("HTTP/1.1 503 ").And.Contains(LimitMessages.ConnectionsOfSource(5)));
            }

            foreach (var client in clients) await client.RoundTripAsync();
            Assert.That(gateway.WebSocketConnections[Closure.SourceLimit], Is.EqualTo(3));
            Assert.That(gateway.WebSocketConnections.Open, Is.EqualTo(5));
            clients[0].Dispose();
            await Soon.BecomesAsync(() => gateway.WebSocketConnections.Open == 4, "the closed connection has ended");
            clients[0] = await ConnectSourceAsync(gateway);
        }
        finally
        {
            foreach (var client in clients) client.Dispose();
        }
    }

    [Test]
    public async Task SyncConnection_OfASourceAboveItsMaximum_IsClosedAndTheOthersStayOpen()
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { MaxConnections = 4, Tokens = Gateways.Tokens });
        var clients = new List<RawRosbridgeClient>();
        try
        {
            for (var i = 0; i < 5; i++) clients.Add(await ConnectSourceAsync(gateway));
            using var sync = await RawSyncClient.ConnectAsync(gateway);
            await sync.SendAsync(SyncToken.Write(Gateways.SourceToken));

            await Soon.BecomesAsync(() => gateway.SyncConnections[Closure.SourceLimit] == 1, "the connection is closed");
            foreach (var client in clients) await client.RoundTripAsync();
        }
        finally
        {
            foreach (var client in clients) client.Dispose();
        }
    }

    static async Task<RawRosbridgeClient> ConnectSourceAsync(GatewayServer gateway)
    {
        var client = await RawRosbridgeClient.ConnectAsync(
            gateway, options => options.SetRequestHeader("Authorization", "Bearer " + Gateways.SourceToken));
        await client.RoundTripAsync();
        return client;
    }

    [Test]
    public async Task Connections_WithHttpRequestsOnly_DoNotCountTowardsTheLimit()
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { MaxConnections = 1 });
        using var first = await RawWebSocket.ConnectAsync(gateway);
        using var second = await RawWebSocket.ConnectAsync(gateway);

        Assert.That(await first.RequestAsync(), Does.StartWith("HTTP/1.1 426 "));
        Assert.That(await second.RequestAsync(), Does.StartWith("HTTP/1.1 426 "));
        await first.ExpectEndAsync();
        await second.ExpectEndAsync();

        using var client = await RawRosbridgeClient.ConnectAsync(gateway);
        await client.RoundTripAsync();
    }

    [Test]
    public async Task Connection_WithoutRequest_IsClosed()
    {
        var options = Gateways.Options() with { TokenTimeout = TimeSpan.FromMilliseconds(200) };
        await using var gateway = await Gateways.StartAsync(options);
        using var silent = await RawWebSocket.ConnectAsync(gateway);

        await silent.ExpectEndAsync();
    }

    [TestCase(RawWebSocket.Text, "a byte that is not UTF-8")]
    [TestCase(3, "an opcode that is reserved")]
    [TestCase(0x40 | RawWebSocket.Text, "the bit of a compressed message")]
    public async Task Frame_ViolatesTheProtocol_ClosesTheConnectionAndIsCounted(int opcode, string what)
    {
        await using var gateway = await Gateways.StartAsync();
        using var raw = await RawWebSocket.OpenAsync(gateway);

        await raw.SendFrameAsync(opcode, 0xFF);

        await raw.ExpectEndAsync();
        await Soon.BecomesAsync(() => gateway.WebSocketConnections.Open == 0, "closed");
        Assert.That(gateway.WebSocketConnections[Closure.MalformedFrame], Is.EqualTo(1), what);
    }

    [Test]
    public async Task Compression_Requested_IsNotNegotiated()
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway, options => options.DangerousDeflateOptions = new WebSocketDeflateOptions());

        Assert.That(client.Socket.HttpResponseHeaders.ContainsKey("Sec-WebSocket-Extensions"), Is.False);
        await client.RoundTripAsync();
    }

    [Test]
    public async Task Gateway_Stopped_SendsACloseFrame()
    {
        var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);
        await client.RoundTripAsync();
        var receiving = client.Socket.ReceiveAsync(new byte[100], default);

        await gateway.DisposeAsync();

        Assert.That((await receiving.Bounded()).CloseStatus, Is.EqualTo(WebSocketCloseStatus.EndpointUnavailable));
    }

    internal static async Task<HttpStatusCode> RefusalAsync(GatewayServer gateway, Action<ClientWebSocketOptions> set)
    {
        using var socket = new ClientWebSocket();
        set?.Invoke(socket.Options);
        socket.Options.CollectHttpResponseDetails = true;
        if (gateway.Pin != null)
            socket.Options.RemoteCertificateValidationCallback = (_, certificate, _, _) => gateway.Pin.Matches(certificate);
        Assert.ThrowsAsync<WebSocketException>(() => socket.ConnectAsync(gateway.WebSocketUri(), default).Bounded());
        await Task.CompletedTask;
        return socket.HttpStatusCode;
    }
}
