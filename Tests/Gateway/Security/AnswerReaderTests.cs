using System.Net;
using System.Net.Sockets;
using System.Text;
using Microsoft.AspNetCore.Builder;
using Microsoft.AspNetCore.Hosting.Server;
using Microsoft.AspNetCore.Hosting.Server.Features;
using Microsoft.AspNetCore.Http;
using Microsoft.Extensions.DependencyInjection;
using NUnit.Framework;
using Nowpose.Gateway;
using Nowpose.Gateway.Security;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Gateway.Security;

/// <summary>Tests that the gateway aborts the connection of a client that requests a page but does not read the response.</summary>
[Parallelizable(ParallelScope.All)]
public class AnswerReaderTests
{
    const int Piece = 64 * 1024;

    // With a high minimum rate, the gateway expects the bytes in the socket buffers to be read almost immediately.
    static readonly GatewayOptions Options = Gateways.Options() with { AnswerBytesPerSecond = 100_000_000 };

    [Test]
    public Task Answer_NotRead_IsAborted() => AskAndReadNothingAsync();

    [Test]
    public async Task WebSocket_NotReadUntilAnHttpAnswerWouldBeAborted_StaysOpen()
    {
        await using var gateway = await Gateways.StartAsync(Options with { PongTimeout = TimeSpan.FromMinutes(5) });
        using var client = await RawRosbridgeClient.ConnectAsync(gateway, options => options.SetBuffer(1024, 1024));
        await client.SubscribeAsync(RosTopics.JointStates);
        using var source = gateway.Hub.OpenSource();
        var names = Enumerable.Range(0, 256).Select(i => "joint" + i).ToArray();
        var sent = 0;
        using var quick = await RawRosbridgeClient.ConnectAsync(gateway);
        await quick.SubscribeAsync(RosTopics.JointStates);
        // Publishes until all buffers between the gateway and the client are full.
        while (gateway.Drops[DropReason.SlowReader] < 100)
        {
            source.Publish(Gateways.State(++sent, names));
            await quick.ReceiveAsync();
        }

        await AskAndReadNothingAsync();

        while ((await client.ReceiveAsync()).JointState.Positions[0] < sent)
        {
            // Reads until the newest sample arrives, which shows that the connection was not closed.
        }
    }

    // Requests a response without reading it. Completes when the gateway aborts the response.
    static async Task AskAndReadNothingAsync()
    {
        var isBegun = new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
        var isAborted = new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
        await using var web = GatewayWeb.Build(
            Options, new PendingWebConnections(new PendingConnections(Options.MaxPendingConnections), new ConnectionCounters(), _ => { }), new ConnectionCounters(),
            _ => { }, context => AnswerAsync(context, isBegun, isAborted));
        await web.StartAsync().Bounded();
        using var reader = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp) { ReceiveBufferSize = 4096 };
        await reader.ConnectAsync(IPAddress.Loopback, PortOf(web));

        await reader.SendAsync(Encoding.ASCII.GetBytes("GET / HTTP/1.1\r\nHost: localhost\r\n\r\n"));

        await isBegun.Task.Bounded();
        await isAborted.Task.Bounded();
    }

    // Sends a response that is longer than all buffers, until the gateway aborts it. An earlier failure of a write does not count as an abort.
    static async Task AnswerAsync(HttpContext context, TaskCompletionSource isBegun, TaskCompletionSource isAborted)
    {
        isBegun.SetResult();
        context.RequestAborted.Register(isAborted.SetResult);
        var piece = new byte[Piece];
        try
        {
            while (!context.RequestAborted.IsCancellationRequested)
                await context.Response.Body.WriteAsync(piece);
        }
        finally
        {
            await isAborted.Task.Bounded();
        }
    }

    static int PortOf(WebApplication web) =>
        new Uri(web.Services.GetRequiredService<IServer>().Features.Get<IServerAddressesFeature>().Addresses.First()).Port;
}
