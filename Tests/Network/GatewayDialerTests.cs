using System.Net;
using System.Net.Sockets;
using Nowpose.Messages;
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

        var failure = Assert.ThrowsAsync<GatewayRefusalException>(() => Dialer("localhost").OpenAsync(port, default).Bounded());

        Assert.That(failure.Message, Is.EqualTo(ConnectionMessages.NotConnected("localhost:" + port, true, SocketError.ConnectionRefused)));
    }

    // --bind any exposes the gateway to the network, and is not needed for a headset on the same machine.
    [TestCase("127.0.0.1", false)]
    [TestCase("192.168.0.20", true)]
    public void Open_ConnectionRefused_NamesTheOptionBindOnlyForAnotherMachine(string host, bool isNamed)
    {
        var dialer = new GatewayDialer(
            new ConnectionSettings(host, insecureLan: true),
            (tcp, address, port) => throw new SocketException((int)SocketError.ConnectionRefused));

        var failure = Assert.ThrowsAsync<GatewayRefusalException>(() => dialer.OpenAsync(1, default).Bounded());

        Assert.That(failure.Message.Contains("--bind any"), Is.EqualTo(isNamed), failure.Message);
        Assert.That(failure.Message.Contains("--tls"), Is.EqualTo(isNamed), failure.Message);
    }

    [TestCase(true)]
    [TestCase(false)]
    public void Open_HostNameUnknown_ThrowsWithTheName(bool isReported)
    {
        var dialer = new GatewayDialer(
            new ConnectionSettings("gateway.example", insecureLan: true),
            resolve: _ => isReported ? throw new SocketException((int)SocketError.HostNotFound) : Task.FromResult<IPAddress[]>([]));

        var failure = Assert.ThrowsAsync<GatewayRefusalException>(() => dialer.OpenAsync(1, default).Bounded());

        Assert.That(failure.Message, Is.EqualTo(ConnectionMessages.NotConnected("gateway.example:1", false, SocketError.HostNotFound)));
    }

    // With a DNS server that does not respond, a lookup takes longer than an attempt to connect.
    [Test]
    public void Open_HostNameNotResolvedInTime_ReportsTheLookup()
    {
        var dialer = new GatewayDialer(
            new ConnectionSettings("gateway.example", insecureLan: true), resolve: _ => new TaskCompletionSource<IPAddress[]>().Task);

        var failure = Assert.ThrowsAsync<GatewayRefusalException>(() => dialer.OpenAsync(1, default).Bounded());

        Assert.That(failure.Message, Does.StartWith("gateway.example:1: ").And.Contain("DNS").And.Contain("3 s"));
    }

    // A UWP app without a network capability gets this error, and so does an Android app without the permission INTERNET.
    [Test]
    public void Open_NetworkNotAllowed_ThrowsWithTheCapabilities()
    {
        var dialer = new GatewayDialer(
            new ConnectionSettings("127.0.0.1"), (tcp, address, port) => throw new SocketException((int)SocketError.AccessDenied));

        var failure = Assert.ThrowsAsync<GatewayRefusalException>(() => dialer.OpenAsync(1, default).Bounded());

        Assert.That(failure.Message, Is.EqualTo(ConnectionMessages.NotConnected("127.0.0.1:1", true, SocketError.AccessDenied)));
        Assert.That(failure.Message, Does.Contain("PrivateNetworkClientServer").And.Contain("InternetClient").And.Contain("Internet Access"));
    }

    [Test]
    public async Task Open_FirstAttemptGetsNoAnswer_ConnectsWithTheSecondAndClosesTheFirst()
    {
        using var listener = new TcpListener(IPAddress.Loopback, 0);
        listener.Start();
        var attempts = new List<TcpClient>();
        var dialer = new GatewayDialer(new ConnectionSettings("127.0.0.1"), (tcp, address, port) =>
        {
            attempts.Add(tcp);
            return attempts.Count == 1 ? new TaskCompletionSource().Task : tcp.ConnectAsync(address, port);
        });

        using var stream = await dialer.OpenAsync(((IPEndPoint)listener.LocalEndpoint).Port, default).Bounded();

        using var accepted = await listener.AcceptTcpClientAsync().Bounded();
        await stream.WriteAsync(new byte[] { 42 });
        Assert.That(accepted.GetStream().ReadByte(), Is.EqualTo(42));
        Assert.That(attempts, Has.Count.EqualTo(2));
        Assert.That(() => attempts[0].GetStream(), Throws.TypeOf<ObjectDisposedException>(), "the first attempt is closed");
    }

    [Test]
    public async Task Open_BothAttemptsConnect_ClosesOneOfThem()
    {
        using var listener = new TcpListener(IPAddress.Loopback, 0);
        listener.Start();
        var connected = 0;
        var both = new TaskCompletionSource();
        var dialer = new GatewayDialer(new ConnectionSettings("127.0.0.1"), async (tcp, address, port) =>
        {
            await tcp.ConnectAsync(address, port);
            if (Interlocked.Increment(ref connected) == 2) both.SetResult();
            await both.Task;
        });

        using var stream = await dialer.OpenAsync(((IPEndPoint)listener.LocalEndpoint).Port, default).Bounded();

        TcpClient[] accepted = [await listener.AcceptTcpClientAsync().Bounded(), await listener.AcceptTcpClientAsync().Bounded()];
        var ends = accepted.Select(one => one.GetStream().ReadAsync(new byte[1]).AsTask()).ToArray();
        var closed = await Task.WhenAny(ends).Bounded();
        await stream.WriteAsync(new byte[] { 42 });
        Assert.That(await closed, Is.Zero, "the connection that was not used");
        Assert.That(await ends.Single(end => end != closed).Bounded(), Is.EqualTo(1), "the connection in use");
        foreach (var one in accepted) one.Dispose();
    }

    // A host name may have the address of an interface that this network cannot reach.
    [TestCase(1)]
    [TestCase(3)]
    public async Task Open_FirstAddressesOfTheHostDoNotRespond_ConnectsToTheLast(int silent)
    {
        using var listener = new TcpListener(IPAddress.Loopback, 0);
        listener.Start();
        IPAddress[] addresses = [.. Enumerable.Range(1, silent).Select(i => IPAddress.Parse("192.0.2." + i)), IPAddress.Loopback];
        var dialer = new GatewayDialer(
            new ConnectionSettings("localhost"),
            (tcp, address, port) => IPAddress.IsLoopback(address) ? tcp.ConnectAsync(address, port) : new TaskCompletionSource().Task,
            _ => Task.FromResult(addresses));

        using var stream = await dialer.OpenAsync(((IPEndPoint)listener.LocalEndpoint).Port, default).Bounded();

        using var accepted = await listener.AcceptTcpClientAsync().Bounded();
        await stream.WriteAsync(new byte[] { 42 });
        Assert.That(accepted.GetStream().ReadByte(), Is.EqualTo(42));
    }

    [Test]
    public async Task Open_FirstAddressSilentAndSecondRefuses_ConnectsWithTheSecondAttemptToTheFirst()
    {
        using var listener = new TcpListener(IPAddress.Loopback, 0);
        listener.Start();
        var tried = new List<IPAddress>();
        var silent = IPAddress.Loopback;
        var refusing = IPAddress.Parse("127.0.0.2");
        var dialer = new GatewayDialer(
            new ConnectionSettings("localhost"),
            (tcp, address, port) =>
            {
                tried.Add(address);
                if (address.Equals(refusing)) return Task.FromException(new SocketException((int)SocketError.ConnectionRefused));
                return tried.Count == 1 ? new TaskCompletionSource().Task : tcp.ConnectAsync(address, port);
            },
            _ => Task.FromResult(new[] { silent, refusing }));

        using var stream = await dialer.OpenAsync(((IPEndPoint)listener.LocalEndpoint).Port, default).Bounded();

        Assert.That(tried, Is.EqualTo(new[] { silent, refusing, silent }));
    }

    [Test]
    public void Open_AllAddressesRefuse_ThrowsAfterOneAttemptToEach()
    {
        var tried = new List<IPAddress>();
        IPAddress[] addresses = [IPAddress.Loopback, IPAddress.Parse("127.0.0.2")];
        var dialer = new GatewayDialer(
            new ConnectionSettings("localhost"),
            (_, address, _) =>
            {
                tried.Add(address);
                return Task.FromException(new SocketException((int)SocketError.ConnectionRefused));
            },
            _ => Task.FromResult(addresses));

        Assert.ThrowsAsync<GatewayRefusalException>(() => dialer.OpenAsync(1, default).Bounded());
        Assert.That(tried, Is.EqualTo(addresses));
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
