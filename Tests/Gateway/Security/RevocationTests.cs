using System.Collections.Concurrent;
using System.Diagnostics;
using System.Net;
using System.Net.WebSockets;
using Nowpose.Gateway;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Pairing;
using Nowpose.Gateway.Security;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Security;

/// <summary>Tests tokens that are added and removed while the gateway runs with open connections.</summary>
public class RevocationTests
{
    readonly ConcurrentQueue<string> _log = [];
    string _folder;

    string TokensPath => Path.Combine(_folder, "tokens.txt");
    string PairingPath => Path.Combine(_folder, "paired.txt");

    [SetUp]
    public void SetUp()
    {
        _folder = Directory.CreateTempSubdirectory("nowpose-revocation").FullName;
        _log.Clear();
    }

    [TearDown]
    public void TearDown() => Directory.Delete(_folder, true);

    [Test]
    public async Task Token_Removed_EndsOnlyTheTwoConnectionsThatUseIt()
    {
        await using var gateway = await StartAsync("observer gone-token", "observer kept-token");
        using var gone = await ConnectAsync(gateway, "gone-token");
        using var kept = await ConnectAsync(gateway, "kept-token");
        using var goneSync = await SyncAsync(gateway, "gone-token");
        using var keptSync = await SyncAsync(gateway, "kept-token");
        await gone.RoundTripAsync();
        var since = Stopwatch.GetTimestamp();

        Write("observer kept-token");

        var close = await gone.Socket.ReceiveAsync(new byte[100], default).Bounded();
        Assert.That(close.CloseStatus, Is.EqualTo(WebSocketCloseStatus.PolicyViolation));
        Assert.That(close.CloseStatusDescription, Is.EqualTo("Token"));
        Assert.That(await goneSync.ReceiveAsync(), Is.Null);
        PrintTime("revoked token: both connections ended", since);
        await Soon.BecomesAsync(() => gateway.SyncConnections[Closure.Token] == 1, "counted");
        await Soon.BecomesAsync(() => gateway.WebSocketConnections[Closure.Token] == 1, "counted");
        await kept.RoundTripAsync();
        Assert.That(await keptSync.ExchangeAsync(SyncFrame.Request(2, 2)), Is.Not.Null);
        Assert.That(await RefusalAsync(gateway, "gone-token"), Is.EqualTo(HttpStatusCode.Unauthorized));
    }

    /// <summary>Checks the sum of the designed delays, because the documented limit does not include the delays of a busy machine.</summary>
    [Test]
    public void Token_Removed_TimeoutsAddUpToLessThanTwoSeconds() =>
        Assert.That(TokenList.Settles + AccessWatch.Interval + ProtocolLimits.CloseTimeout, Is.LessThan(TimeSpan.FromSeconds(2)));

    [Test]
    public async Task Token_RemovedWhileItsClientDoesNotRead_EndsTheConnection()
    {
        await using var gateway = await StartAsync("source gone-token", "observer other");
        using var gone = await ConnectAsync(gateway, "gone-token");
        await gone.SendAsync(Gateways.StateText(1));
        var since = Stopwatch.GetTimestamp();

        Write("observer other");

        await Soon.BecomesAsync(() => gateway.WebSocketConnections.Open == 0, "ended");
        // At most half a second until the next check, a quarter of a second until the file is stable, and one second for the close frame.
        PrintTime("revoked token of a client that reads nothing: ended", since);
        Assert.That(gateway.WebSocketConnections[Closure.Token], Is.EqualTo(1));
    }

    [Test]
    public async Task Token_OfASourceRemoved_ItsMessagesAreIgnored()
    {
        await using var gateway = await StartAsync("source gone-token", "observer other");
        using var observer = await ConnectAsync(gateway, "other");
        await observer.SubscribeAsync(RosTopics.JointStates);
        using var gone = await ConnectAsync(gateway, "gone-token");
        await gone.RoundTripAsync();

        Write("observer other");
        var close = await gone.Socket.ReceiveAsync(new byte[100], default).Bounded();
        Assert.That(close.MessageType, Is.EqualTo(WebSocketMessageType.Close));
        try
        {
            // Like an attacker, sends a message instead of responding to the close frame.
            await gone.SendAsync(Gateways.StateText(1));
        }
        catch (WebSocketException)
        {
            // The gateway has already closed the connection.
        }

        await Soon.BecomesAsync(() => gateway.WebSocketConnections.Open == 1, "ended");
        await observer.RoundTripAsync(); // no sample has arrived before the response
    }

    [Test]
    public async Task Token_RoleChanged_ClientReconnectsWithTheNewRole()
    {
        await using var gateway = await StartAsync("source changing");
        using var before = await ConnectAsync(gateway, "changing");

        Write("observer changing");

        Assert.That((await before.Socket.ReceiveAsync(new byte[100], default).Bounded()).CloseStatusDescription, Is.EqualTo("Token"));
        using var after = await ConnectAsync(gateway, "changing");
        await after.SendAsync(Gateways.StateText(1));
        await after.ExpectErrorAsync("role");
    }

    [Test]
    public async Task Token_Added_IsAcceptedWithoutARestart()
    {
        await using var gateway = await StartAsync("observer first");
        Assert.That(await RefusalAsync(gateway, "second"), Is.EqualTo(HttpStatusCode.Unauthorized));

        Write("observer first", "source second");

        await Soon.BecomesAsync(() => RawSyncClient.IsAcceptedAsync(gateway, "second").Result, "accepted");
    }

    [Test]
    public async Task Tokens_AllRemoved_RefuseAllClients()
    {
        await using var gateway = await StartAsync("observer only");
        using var client = await ConnectAsync(gateway, "only");

        Write("# no tokens at the moment");

        Assert.That((await client.Socket.ReceiveAsync(new byte[100], default).Bounded()).CloseStatusDescription, Is.EqualTo("Token"));
        Assert.That(await RefusalAsync(gateway, "only"), Is.EqualTo(HttpStatusCode.Unauthorized));
    }

    [TestCase("observer kept\nadmin wrong-secret\n", "line 2")]
    [TestCase(null, "cannot be read")]
    public async Task File_Invalid_LastValidListIsUsedAndTheErrorIsLoggedOnce(string text, string part)
    {
        await using var gateway = await StartAsync("observer kept", "observer also-kept");
        using var client = await ConnectAsync(gateway, "also-kept");

        if (text == null) File.Delete(TokensPath);
        else File.WriteAllText(TokensPath, text);
        await Soon.BecomesAsync(() => !_log.IsEmpty, "the error is logged");
        await client.RoundTripAsync();
        Write("observer kept", "observer also-kept", "observer new");
        await Soon.BecomesAsync(() => RawSyncClient.IsAcceptedAsync(gateway, "new").Result, "the new token is accepted");

        // The tokens are weak, which is logged too.
        var lines = _log.Where(line => line.Contains(TokensPath) && line.Contains(AccessMessages.FormerContentUsed)).ToArray();
        Assert.That(lines.Length, Is.EqualTo(1), string.Join('\n', lines));
        Assert.That(lines[0], Does.Contain(part).And.Not.Contain("secret"));
        await client.RoundTripAsync();
    }

    [Test]
    public async Task Headset_Revoked_LosesBothConnections()
    {
        var headsets = new HeadsetList(PairingPath, log: _log.Enqueue);
        var token = headsets.Add("seven", out var headset);
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { Headsets = headsets });
        using var client = await ConnectAsync(gateway, token);
        using var sync = await SyncAsync(gateway, token);
        var since = Stopwatch.GetTimestamp();

        HeadsetFile.Remove(PairingPath, [headset]);

        Assert.That((await client.Socket.ReceiveAsync(new byte[100], default).Bounded()).CloseStatusDescription, Is.EqualTo("Token"));
        Assert.That(await sync.ReceiveAsync(), Is.Null);
        PrintTime("revoked headset: both connections ended", since);
        await Soon.BecomesAsync(() => gateway.SyncConnections[Closure.Token] == 1, "counted");
    }

    // Prints the elapsed time. By design it is one or two seconds, but it is not asserted, because a busy machine may take longer.
    static void PrintTime(string what, long since) =>
        TestContext.Out.WriteLine($"{what} after {Stopwatch.GetElapsedTime(since).TotalMilliseconds:0} ms");

    Task<GatewayServer> StartAsync(params string[] tokens)
    {
        Write(tokens);
        return Gateways.StartAsync(Gateways.Options() with { Tokens = TokenList.Read(TokensPath, _log.Enqueue) });
    }

    // Replaces the file at once, so that the gateway never reads a part of it.
    void Write(params string[] lines)
    {
        var next = TokensPath + ".next";
        File.WriteAllLines(next, lines);
        File.Move(next, TokensPath, overwrite: true);
    }

    static Task<RawRosbridgeClient> ConnectAsync(GatewayServer gateway, string token) =>
        RawRosbridgeClient.ConnectAsync(gateway, options => options.SetRequestHeader("Authorization", "Bearer " + token));

    static async Task<RawSyncClient> SyncAsync(GatewayServer gateway, string token)
    {
        var client = await RawSyncClient.ConnectAsync(gateway);
        await client.SendAsync(SyncToken.Write(token));
        Assert.That((await client.ReceiveAsync()).Value.IsAccepted, Is.True);
        return client;
    }

    static Task<HttpStatusCode> RefusalAsync(GatewayServer gateway, string token) =>
        RosbridgeServerTests.RefusalAsync(gateway, options => options.SetRequestHeader("Authorization", "Bearer " + token));
}
