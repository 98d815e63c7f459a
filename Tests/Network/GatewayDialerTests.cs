using System.Net;
using System.Net.Sockets;
using Nowpose.Network;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Network;

public sealed class GatewayDialerTests
{
    [TestCase("127.0.0.1")]
    [TestCase("localhost")]
    public Task Open_GatewayOnIpv4_Connects(string host) => ReachesAsync(IPAddress.Loopback, host);

    [TestCase("::1")]
    [TestCase("[::1]")]
    [TestCase("localhost")]
    public async Task Open_GatewayOnIpv6Only_Connects(string host)
    {
        if (!Socket.OSSupportsIPv6) Assert.Ignore("this machine has no IPv6");
        if (!Dns.GetHostAddresses(host.Trim('[', ']')).Contains(IPAddress.IPv6Loopback)) Assert.Ignore(host + " has no IPv6 address here");

        await ReachesAsync(IPAddress.IPv6Loopback, host);
    }

    [Test]
    public void Open_ConnectionRefused_Throws()
    {
        var free = new TcpListener(IPAddress.Loopback, 0);
        free.Start();
        var port = ((IPEndPoint)free.LocalEndpoint).Port;
        free.Stop();

        Assert.ThrowsAsync<SocketException>(() => Dialer("localhost").OpenAsync(port, default).Bounded());
    }

    static async Task ReachesAsync(IPAddress listening, string host)
    {
        var listener = new TcpListener(listening, 0);
        try
        {
            listener.Start();
        }
        catch (SocketException)
        {
            Assert.Ignore("nothing can listen on " + listening + " here");
        }
        try
        {
            using var stream = await Dialer(host).OpenAsync(((IPEndPoint)listener.LocalEndpoint).Port, default).Bounded();
            using var accepted = await listener.AcceptTcpClientAsync().Bounded();

            await stream.WriteAsync(new byte[] { 42 });

            Assert.That(accepted.GetStream().ReadByte(), Is.EqualTo(42));
        }
        finally
        {
            listener.Stop();
        }
    }

    static GatewayDialer Dialer(string host) => new(new ConnectionSettings(host));
}
