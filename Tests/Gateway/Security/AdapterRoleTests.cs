using System.Net;
using System.Net.NetworkInformation;
using System.Net.Sockets;
using Microsoft.AspNetCore.Http;
using NUnit.Framework;
using Nowpose.Gateway;
using Nowpose.Gateway.Operations;
using Nowpose.Gateway.Plants;
using Nowpose.Gateway.Security;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Gateway.Security;

/// <summary>
/// Tests that an adapter that the gateway has started has the role of a source at any address. Without tokens, other clients have this role only on
/// this machine.
/// </summary>
public class AdapterRoleTests
{
    static readonly GatewayOptions WithoutTokens = Gateways.Options();

    static Role? RoleOf(GatewayOptions options, string token, string address)
    {
        var context = new DefaultHttpContext();
        context.Connection.RemoteIpAddress = IPAddress.Parse(address);
        if (token != null) context.Request.Headers.Authorization = "Bearer " + token;
        return new AccessRule(options, new BrowserSessions(TimeProvider.System)).RoleOf(context);
    }

    [TestCase("192.0.2.7", Role.Observer)]
    [TestCase("127.0.0.1", Role.Source)]
    public void RoleOf_GatewayWithoutTokens_DependsOnAddressAndAdapterToken(string address, Role others)
    {
        Assert.That(RoleOf(WithoutTokens, WithoutTokens.AdapterToken, address), Is.EqualTo(Role.Source));
        Assert.That(RoleOf(WithoutTokens, null, address), Is.EqualTo(others));
        Assert.That(RoleOf(WithoutTokens, "guess", address), Is.EqualTo(others), "a wrong token has no effect without tokens");
    }

    [Test]
    public void RoleOf_GatewayWithTokens_AlsoAcceptsTheAdapterToken()
    {
        var options = WithoutTokens with { Tokens = Gateways.Tokens };

        Assert.That(RoleOf(options, options.AdapterToken, "192.0.2.7"), Is.EqualTo(Role.Source));
        Assert.That(RoleOf(options, WithoutTokens.AdapterToken[1..], "127.0.0.1"), Is.Null);
        Assert.That(RoleOf(options, null, "127.0.0.1"), Is.Null);
    }

    [Test]
    public async Task Adapter_GatewayBoundToItsLanAddress_IsASource()
    {
        var lan = AddressOnTheLan();
        if (lan == null) Assert.Ignore("this machine has no address but loopback");
        using var certificate = CertificateFiles.Generate();
        await using var gateway = await Gateways.StartAsync(WithoutTokens with { Bind = lan, Certificate = certificate });
        var access = AdapterAccess.To(gateway);
        using var observer = await ConnectAsync(gateway, access.WebSocket, null);
        using var adapter = await ConnectAsync(gateway, access.WebSocket, access.Token);

        await observer.SendAsync(Gateways.StateText(0.25));
        await observer.ExpectErrorAsync("role");
        await observer.SubscribeAsync(RosTopics.JointStates);
        await adapter.SendAsync(Gateways.StateText(0.5));

        Assert.That((await observer.ReceiveAsync()).JointState.Positions, Is.EqualTo(new[] { 0.5 }));
    }

    static Task<RawRosbridgeClient> ConnectAsync(GatewayServer gateway, Uri uri, string token) =>
        RawRosbridgeClient.ConnectAsync(uri, options =>
        {
            options.RemoteCertificateValidationCallback = (_, certificate, _, _) => gateway.Pin.Matches(certificate);
            if (token != null) options.SetRequestHeader("Authorization", "Bearer " + token);
        });

    static IPAddress AddressOnTheLan() => NetworkInterface.GetAllNetworkInterfaces()
        .Where(network => network.OperationalStatus == OperationalStatus.Up)
        .SelectMany(network => network.GetIPProperties().UnicastAddresses)
        .Select(unicast => unicast.Address)
        .FirstOrDefault(address => address.AddressFamily == AddressFamily.InterNetwork && !IPAddress.IsLoopback(address));
}
