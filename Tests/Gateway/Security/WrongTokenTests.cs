using System.Net;
using System.Net.Http.Headers;
using Nowpose.Gateway;
using Nowpose.Gateway.Security;
using Nowpose.Pairing;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Security;

/// <summary>Tokens are guessed slowly; a known one is let in at once, from the same address, too.</summary>
[Parallelizable(ParallelScope.All)]
public class WrongTokenTests
{
    static readonly GatewayOptions WithTokens = Gateways.Options() with { Tokens = Gateways.Tokens };

    /// <summary>Far longer than the test: an answer that is held back does not come.</summary>
    static readonly GatewayOptions Slow = WithTokens with { WrongTokenDelay = TimeSpan.FromMinutes(10), TokenTimeout = TimeSpan.FromMinutes(10) };

    [Test]
    public async Task Http_ManyWrongBearers_AreRefusedForAWhile()
    {
        var time = new SteppedTime();
        await using var gateway = await Gateways.StartAsync(WithTokens with { WrongTokenDelay = TimeSpan.Zero, Time = time });
        for (var i = 0; i < PairingLimits.WrongCodesPerMinute; i++)
            Assert.That((await AskAsync(gateway, "guess")).Status, Is.EqualTo(HttpStatusCode.Unauthorized));

        var (status, retryAfter) = await AskAsync(gateway, "guess");

        Assert.That(status, Is.EqualTo(HttpStatusCode.TooManyRequests));
        Assert.That(retryAfter, Is.EqualTo(TimeSpan.FromMinutes(1)));
        Assert.That((await AskAsync(gateway, Gateways.ObserverToken)).Status, Is.EqualTo(HttpStatusCode.OK));
        time.Advance(TimeSpan.FromMinutes(1));
        Assert.That((await AskAsync(gateway, "guess")).Status, Is.EqualTo(HttpStatusCode.Unauthorized));
    }

    [TestCase("2001:db8::1", "2001:db8::2", true)]
    [TestCase("2001:db8::1", "2001:db8:0:1::1", false)]
    [TestCase("10.0.0.1", "10.0.0.2", false)]
    [TestCase("::ffff:10.0.0.1", "10.0.0.1", true)]
    [TestCase("::ffff:10.0.0.1", "::ffff:10.0.0.2", false)]
    public void Count_OfAnotherAddress_CountsWithinTheSameNetworkOfIPv6(string guessing, string other, bool isBlocked)
    {
        var wrong = new WrongTokens(new SteppedTime());

        for (var i = 0; i < PairingLimits.WrongCodesPerMinute; i++) wrong.Count(IPAddress.Parse(guessing));

        Assert.That(wrong.IsBlocked(IPAddress.Parse(other)), Is.EqualTo(isBlocked));
    }

    [Test]
    public async Task Http_WithoutAToken_IsNoGuess()
    {
        await using var gateway = await Gateways.StartAsync(Slow);

        for (var i = 0; i < 3 * PairingLimits.WrongCodesPerMinute; i++)
            Assert.That((await AskAsync(gateway, null)).Status, Is.EqualTo(HttpStatusCode.Unauthorized));
    }

    [Test]
    public async Task Sync_ManyWrongTokens_AreAnsweredLateAndAKnownOneAtOnce()
    {
        await using var gateway = await Gateways.StartAsync(Slow);
        for (var i = 0; i < PairingLimits.WrongCodesPerMinute; i++)
        {
            using var wrong = await RawSyncClient.ConnectAsync(gateway);
            await wrong.SendAsync(SyncToken.Write("guess"));
            Assert.That((await wrong.ReceiveAsync()).Value.IsAccepted, Is.False);
        }

        using var late = await RawSyncClient.ConnectAsync(gateway);
        await late.SendAsync(SyncToken.Write("guess"));
        var answer = late.ReceiveAsync();
        using var known = await RawSyncClient.ConnectAsync(gateway);
        await known.SendAsync(SyncToken.Write(Gateways.ObserverToken));

        Assert.That((await known.ReceiveAsync()).Value.IsAccepted, Is.True);
        Assert.That(await known.ExchangeAsync(SyncFrame.Request(1, 2)), Is.Not.Null);
        Assert.That(answer.IsCompleted, Is.False, "the wrong one is held back");
    }

    [Test]
    public async Task Guesses_OnOnePort_SlowTheOther()
    {
        await using var gateway = await Gateways.StartAsync(WithTokens with { WrongTokenDelay = TimeSpan.Zero });
        for (var i = 0; i < PairingLimits.WrongCodesPerMinute; i++)
        {
            using var wrong = await RawSyncClient.ConnectAsync(gateway);
            await wrong.SendAsync(SyncToken.Write("guess"));
            await wrong.ReceiveAsync();
        }

        Assert.That((await AskAsync(gateway, "guess")).Status, Is.EqualTo(HttpStatusCode.TooManyRequests));
    }

    static async Task<(HttpStatusCode Status, TimeSpan? RetryAfter)> AskAsync(GatewayServer gateway, string token)
    {
        using var http = new HttpClient();
        using var request = new HttpRequestMessage(HttpMethod.Get, new Uri($"http://127.0.0.1:{gateway.WebSocketEndPoint.Port}/metrics"));
        if (token != null) request.Headers.Authorization = new AuthenticationHeaderValue("Bearer", token);
        using var answer = await http.SendAsync(request).Bounded();
        return (answer.StatusCode, answer.Headers.RetryAfter?.Delta);
    }
}
