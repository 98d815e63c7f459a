using System.Net;
using System.Net.WebSockets;
using System.Security.Authentication;
using System.Security.Cryptography.X509Certificates;
using NUnit.Framework;
using Nowpose.Gateway;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Security;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Gateway;

public class RosbridgeAccessTests
{
    static readonly GatewayOptions WithTokens = Gateways.Options() with { Tokens = Gateways.Tokens };

    static Action<ClientWebSocketOptions> Bearer(string token) => Header("Authorization", "Bearer " + token);
    static Action<ClientWebSocketOptions> Header(string name, string value) => options => options.SetRequestHeader(name, value);

    static string State() => RosbridgeWriter.Publish(RosTopics.JointStates, Gateways.State(1, "a"), RosTimeForm.Sec);

    [TestCase(null)]
    [TestCase("Bearer guess")]
    [TestCase("Bearer ")]
    [TestCase("Basic observer-token")]
    [TestCase("observer-token")]
    public async Task Token_WrongOrMissing_Returns401(string header)
    {
        await using var gateway = await Gateways.StartAsync(WithTokens);

        var status = await RosbridgeServerTests.RefusalAsync(gateway, header == null ? null : Header("Authorization", header));

        Assert.That(status, Is.EqualTo(HttpStatusCode.Unauthorized));
        Assert.That(gateway.WebSocketConnections[Closure.Token], Is.EqualTo(1));
    }

    [Test]
    public async Task Observer_Publishes_IsRefusedAndStaysConnected()
    {
        await using var gateway = await Gateways.StartAsync(WithTokens);
        using var observer = await RawRosbridgeClient.ConnectAsync(gateway, Bearer(Gateways.ObserverToken));
        await observer.SubscribeAsync(RosTopics.JointStates);

        await observer.SendAsync(State());
        await observer.ExpectErrorAsync("role");
        await observer.SendAsync(RosbridgeWriter.Advertise(RosTopics.JointStates, RosTopics.JointStateType));
        await observer.ExpectErrorAsync("role");
        await observer.SendAsync(RosbridgeWriter.Publish(RosTopics.RobotDescription, new StringMessage("<robot/>")));
        await observer.ExpectErrorAsync("role");

        Assert.That(gateway.Drops[DropReason.NotAllowed], Is.EqualTo(3));
        await observer.RoundTripAsync(); // no message has arrived
    }

    // The reader finds the invalid content before the gateway checks the role.
    [TestCase("1.5")]
    [TestCase("null")]
    public async Task Observer_PublishesJointStatesAndSetPoints_AreRefusedForItsRoleWhateverTheirContent(string position)
    {
        await using var gateway = await Gateways.StartAsync(WithTokens);
        var refusals = new List<(DropReason Reason, string Text)>();
        gateway.Hub.MessageRefused += (_, _, _, refusal) => refusals.Add((refusal.Reason, refusal.Rule));
        gateway.Hub.SampleDropped += (_, _, text, reason) => refusals.Add((reason, text));
        gateway.Hub.RuleBroken += (_, _, rule) => refusals.Add((DropReason.NotAllowed, rule));
        using var observer = await RawRosbridgeClient.ConnectAsync(gateway, Bearer(Gateways.ObserverToken));
        const string Publish = "{\"op\":\"publish\",\"topic\":\"/joint_", Header = "\",\"msg\":{\"header\":{\"stamp\":{\"sec\":5000,\"nanosec\":0}},";

        await observer.SendAsync(Publish + "trajectory" + Header + "\"joint_names\":[\"a\"],\"points\":[{\"positions\":[" + position
            + "],\"time_from_start\":{\"sec\":0,\"nanosec\":0}}]}}");
        await observer.ExpectErrorAsync(nameof(DropReason.NotAllowed));
        await observer.SendAsync(Publish + "states" + Header + "\"name\":[\"a\"],\"position\":[" + position + "]}}");
        await observer.ExpectErrorAsync(nameof(DropReason.NotAllowed));

        Assert.That(refusals, Has.Count.EqualTo(2).And.All.Matches<(DropReason Reason, string Text)>(
            refusal => refusal.Reason == DropReason.NotAllowed && refusal.Text.Contains(DropMessages.Of(DropReason.NotAllowed))));
        Assert.That(gateway.Drops[DropReason.NotAllowed], Is.EqualTo(2));
    }

    [Test]
    public async Task Observer_PublishesAJointOfASource_IsNoConflictOfTwoSources()
    {
        await using var gateway = await Gateways.StartAsync(WithTokens);
        using var source = gateway.Hub.OpenSource();
        source.Publish(Gateways.State(1, "a"));
        var (conflicts, broken) = (0, 0);
        gateway.Hub.Refused += (_, _, _, _) => conflicts++;
        gateway.Hub.RuleBroken += (_, _, _) => broken++;
        using var observer = await RawRosbridgeClient.ConnectAsync(gateway, Bearer(Gateways.ObserverToken));

        await observer.SendAsync(State());
        await observer.ExpectErrorAsync(nameof(DropReason.NotAllowed));

        Assert.That((conflicts, broken), Is.EqualTo((0, 1)));
    }

    [Test]
    public async Task Observer_PublishesWithoutTheSlash_IsRefusedForTheSlash()
    {
        await using var gateway = await Gateways.StartAsync(WithTokens);
        using var observer = await RawRosbridgeClient.ConnectAsync(gateway, Bearer(Gateways.ObserverToken));

        await observer.SendAsync("{\"op\":\"publish\",\"topic\":\"nowpose/diagnostics\",\"msg\":{\"status\":[]}}");

        await observer.ExpectErrorAsync(RequestMessages.NoSlash("nowpose/diagnostics"));
    }

    [Test]
    public async Task Source_Publishes_ObserverReceivesTheMessage()
    {
        await using var gateway = await Gateways.StartAsync(WithTokens);
        using var observer = await RawRosbridgeClient.ConnectAsync(gateway, Bearer(Gateways.ObserverToken));
        using var source = await RawRosbridgeClient.ConnectAsync(gateway, Bearer(Gateways.SourceToken));
        await observer.SubscribeAsync(RosTopics.JointStates);

        await source.SendAsync(State());

        Assert.That((await observer.ReceiveAsync()).JointState.Names, Is.EqualTo(new[] { "a" }));
    }

    [TestCase("http://evil.example")]
    [TestCase("null")]
    [TestCase("https://127.0.0.1:{port}")]
    [TestCase("http://127.0.0.1:1")]
    [TestCase("http://127.0.0.2:{port}")]
    [TestCase("file://")]
    public async Task Origin_Foreign_Returns403(string origin)
    {
        await using var gateway = await Gateways.StartAsync();
        var value = origin.Replace("{port}", gateway.WebSocketEndPoint.Port.ToString());

        var status = await RosbridgeServerTests.RefusalAsync(gateway, Header("Origin", value));

        Assert.That(status, Is.EqualTo(HttpStatusCode.Forbidden));
        Assert.That(gateway.WebSocketConnections[Closure.Origin], Is.EqualTo(1));
    }

    [Test]
    public async Task Origin_ForeignHostNameResolvedToThisMachine_Returns403()
    {
        await using var gateway = await Gateways.StartAsync();
        var name = "evil.example:" + gateway.WebSocketEndPoint.Port;

        var status = await RosbridgeServerTests.RefusalAsync(gateway, options =>
        {
            options.SetRequestHeader("Host", name);
            options.SetRequestHeader("Origin", "http://" + name);
        });

        Assert.That(status, Is.EqualTo(HttpStatusCode.Forbidden));
    }

    [TestCase("127.0.0.1")]
    [TestCase("localhost")]
    [TestCase("edge1.plant.example")]
    public async Task Origin_PageOfTheGateway_IsAccepted(string host)
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { HostNames = ["edge1.plant.example"] });

        using var client = await RawRosbridgeClient.ConnectAsync(gateway, Header("Origin", $"http://{host}:{gateway.WebSocketEndPoint.Port}"));

        await client.RoundTripAsync();
    }

    [Test]
    public async Task Request_NotAWebSocket_RequiresUpgrade()
    {
        await using var gateway = await Gateways.StartAsync();
        using var http = new HttpClient();

        using var response = await http.GetAsync(new Uri($"http://127.0.0.1:{gateway.WebSocketEndPoint.Port}/any/path")).Bounded();

        Assert.That(response.StatusCode, Is.EqualTo(HttpStatusCode.UpgradeRequired));
    }

    [Test]
    public async Task Tls_WithPinAndToken_IsServed()
    {
        using var certificate = CertificateFiles.Generate();
        await using var gateway = await Gateways.StartAsync(WithTokens with { Certificate = certificate });

        using var client = await RawRosbridgeClient.ConnectAsync(gateway, Bearer(Gateways.SourceToken));

        await client.RoundTripAsync();
    }

    [Test]
    public async Task Tls_ClientWithAnotherPin_RefusesTheConnection()
    {
        using var certificate = CertificateFiles.Generate();
        using var other = CertificateFiles.Generate();
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { Certificate = certificate });
        using var socket = new ClientWebSocket();
        socket.Options.RemoteCertificateValidationCallback = (_, given, _, _) => CertificatePin.Of(other).Matches(given);

        var error = Assert.ThrowsAsync<WebSocketException>(() => socket.ConnectAsync(gateway.WebSocketUri(), default).Bounded());

        Assert.That(error.GetBaseException(), Is.InstanceOf<AuthenticationException>());
    }

    [Test]
    public async Task Tls_ExpiredCertificate_IsRefusedByAValidatingClient()
    {
        using var certificate = CertificateFiles.Generate(DateTimeOffset.UtcNow.AddDays(-10), DateTimeOffset.UtcNow.AddDays(-1));
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { Certificate = certificate });
        using var socket = new ClientWebSocket();
        var isExpired = false;
        socket.Options.RemoteCertificateValidationCallback = (_, _, chain, errors) =>
        {
            isExpired = chain.ChainStatus.Any(status => status.Status.HasFlag(X509ChainStatusFlags.NotTimeValid));
            return errors == System.Net.Security.SslPolicyErrors.None;
        };

        Assert.ThrowsAsync<WebSocketException>(() => socket.ConnectAsync(gateway.WebSocketUri(), default).Bounded());
        Assert.That(isExpired, Is.True);
    }
}
