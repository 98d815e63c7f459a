using System.Net;
using System.Net.Sockets;
using Microsoft.AspNetCore.Connections;
using Microsoft.AspNetCore.Server.Kestrel.Transport.Sockets;
using Microsoft.Extensions.Logging.Abstractions;
using Microsoft.Extensions.Options;
using Nowpose.Gateway;
using Nowpose.Gateway.Messages;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway;

public class DescriptorLimitTests
{
    [TestCase(256, 762ul)]
    [TestCase(256, 1024ul)]
    [TestCase(10_000, ulong.MaxValue)]
    public void Problem_LimitIsSufficient_IsNull(int maxConnections, ulong allowed) =>
        Assert.That(DescriptorLimit.Problem(maxConnections, allowed), Is.Null);

    [TestCase(256, 761ul, 762, 255)]
    [TestCase(2000, 1024ul, 4250, 387)]
    [TestCase(1, 200ul, 252, 0)]
    public void Problem_LimitTooLowForTheConnections_ReturnsTheRemedy(int maxConnections, ulong allowed, long needed, long possible) => Assert.That(
        DescriptorLimit.Problem(maxConnections, allowed), Is.EqualTo(LimitMessages.TooFewDescriptors(maxConnections, needed, allowed, possible)));

    [Test]
    public async Task Gateway_TooFewDescriptors_PrintsOneLineAndExitsWith2()
    {
        if (OperatingSystem.IsWindows()) Assert.Ignore("Windows has no such limit");
        using var gateway = PeerProcess.OfShell(
            $"ulimit -n 700; exec dotnet '{Path.Combine(AppContext.BaseDirectory, "Nowpose.Gateway.dll")}' simulate --sync-port 0 --ws-port 0");

        var status = await gateway.EndsAsync();

        Assert.That(status, Is.EqualTo(2));
        Assert.That(gateway.Lines, Has.Count.EqualTo(1).And.All.EndsWith(LimitMessages.TooFewDescriptors(256, 762, 700, 225)));
    }

    [Test]
    public void Guard_TooFewDescriptors_ClosesTheConnectionWithTheErrorThatIsCounted()
    {
        if (OperatingSystem.IsWindows()) Assert.Ignore("Windows has no such limit");
        using var accepted = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp);

        Assert.DoesNotThrow(() => DescriptorLimit.Guard(accepted, ulong.MaxValue));
        var refused = Assert.Throws<SocketException>(() => DescriptorLimit.Guard(accepted, allowed: 1));

        Assert.That(DescriptorLimit.IsReached(refused));
        Assert.That(accepted.SafeHandle.IsClosed);
    }

    [Test]
    public async Task Accept_Fails_IsRetried()
    {
        var sockets = new SocketTransportFactory(Options.Create(new SocketTransportOptions()), NullLoggerFactory.Instance);
        var failures = new Queue<Exception>(
            [new SocketException((int)SocketError.TooManyOpenSockets), new InsufficientMemoryException("no memory"), new IOException("disk")]);
        var log = new List<string>();
        var counters = new ConnectionCounters();
        await using var listener = new ResilientListener(
            new FailingListener(await sockets.BindAsync(new IPEndPoint(IPAddress.Loopback, 0)), failures), counters, log.Add);
        using var client = new TcpClient();
        await client.ConnectAsync((IPEndPoint)listener.EndPoint).Bounded();

        await using var connection = await listener.AcceptAsync().AsTask().Bounded();

        Assert.That(connection, Is.Not.Null);
        Assert.That(log, Has.Count.EqualTo(3).And.All.Match(MessagePattern.Of(RequestMessages.NotAccepted(MessagePattern.Any, MessagePattern.Any))));
        Assert.That(counters[Closure.DescriptorLimit], Is.EqualTo(1), "only the first failure");
        await listener.UnbindAsync();
        Assert.That(await listener.AcceptAsync().AsTask().Bounded(), Is.Null);
    }

    sealed class FailingListener(IConnectionListener inner, Queue<Exception> failures) : IConnectionListener
    {
        public EndPoint EndPoint => inner.EndPoint;

        public ValueTask<ConnectionContext> AcceptAsync(CancellationToken cancellationToken = default) =>
            failures.TryDequeue(out var failure) ? throw failure : inner.AcceptAsync(cancellationToken);

        public ValueTask UnbindAsync(CancellationToken cancellationToken = default) => inner.UnbindAsync(cancellationToken);

        public ValueTask DisposeAsync() => inner.DisposeAsync();
    }
}
