using System.Globalization;
using System.Net;
using System.Net.Http.Headers;
using System.Net.Sockets;
using System.Text;
using Nowpose.Gateway;
using Nowpose.Gateway.Security;
using Nowpose.Pairing;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Security;

/// <summary>Tests that the gateway responds slowly to wrong tokens, but accepts a valid token immediately, even from the same address.</summary>
[Parallelizable(ParallelScope.All)]
public class WrongTokenTests
{
    static readonly GatewayOptions WithTokens = Gateways.Options() with { Tokens = Gateways.Tokens };

    /// <summary>These delays are much longer than the test, so a delayed response never arrives.</summary>
    static readonly GatewayOptions Slow = WithTokens with { WrongTokenDelay = TimeSpan.FromMinutes(10), TokenTimeout = TimeSpan.FromMinutes(10) };

    [Test]
    public async Task HttpRequests_ManyWrongTokens_AreAnsweredWith401AndTheTimeToWait()
    {
        var time = new SteppedTime();
        await using var gateway = await Gateways.StartAsync(WithTokens with { WrongTokenDelay = TimeSpan.Zero, Time = time });
        for (var i = 0; i < PairingLimits.WrongCodesPerMinute; i++)
            Assert.That((await AskAsync(gateway, "guess")).Status, Is.EqualTo(HttpStatusCode.Unauthorized));

        var (status, retryAfter) = await AskAsync(gateway, "guess");

        Assert.That(status, Is.EqualTo(HttpStatusCode.Unauthorized));
        Assert.That(retryAfter, Is.EqualTo(TimeSpan.FromMinutes(1)));
        Assert.That((await AskAsync(gateway, Gateways.ObserverToken)).Status, Is.EqualTo(HttpStatusCode.OK));
        time.Advance(TimeSpan.FromMinutes(1));
        Assert.That(await AskAsync(gateway, "guess"), Is.EqualTo((HttpStatusCode.Unauthorized, default(TimeSpan?))));
    }

    [Test]
    public void Count_BlockedAddress_ReturnsTrueOnlyForItsNetwork()
    {
        var wrong = new WrongTokens(new SteppedTime());
        var guessing = IPAddress.Parse("2001:db8::1");
        for (var i = 0; i < PairingLimits.WrongCodesPerMinute; i++) Assert.That(wrong.Count(guessing), Is.False);

        Assert.That(wrong.Count(guessing), Is.True);
        Assert.That(wrong.Count(IPAddress.Parse("2001:db8::2")), Is.True);
        Assert.That(wrong.Count(IPAddress.Parse("2001:db8:0:1::1")), Is.False);
    }

    [Test]
    public void Count_TooManyAddresses_RemovesTheAddressInactiveForLongest()
    {
        var wrong = new WrongTokens(new SteppedTime());
        var (silent, trying, newest) = (IPAddress.Parse("10.0.0.1"), IPAddress.Parse("10.0.0.2"), IPAddress.Parse("10.0.0.3"));
        void Block(IPAddress address)
        {
            for (var i = 0; i < PairingLimits.WrongCodesPerMinute; i++) wrong.Count(address);
        }

        Block(silent);
        Block(trying);
        for (var i = 0; i < 3 * WrongTokens.MaxAddresses; i++)
        {
            wrong.Count(new IPAddress([10, 1, (byte)(i >> 8), (byte)i]));
            if (i % 500 == 0) Assert.That(wrong.BlockedFor(trying) > TimeSpan.Zero, Is.True, $"after {i} others");
        }

        Block(newest);
        for (var i = 0; i < WrongTokens.MaxAddresses - 1; i++) wrong.Count(new IPAddress([10, 2, (byte)(i >> 8), (byte)i]));
        Assert.That(wrong.BlockedFor(newest) > TimeSpan.Zero, Is.True, "only the oldest are removed");
        Assert.That(wrong.BlockedFor(silent) > TimeSpan.Zero, Is.False);
    }

    [TestCase("4711")]
    [TestCase(Gateways.ObserverToken)]
    public async Task ValidToken_ManyGuessesFromItsAddress_IsAcceptedImmediatelyOnBothPorts(string valid)
    {
        await using var gateway = await Gateways.StartAsync(Slow with { Tokens = new TokenList([(valid, Role.Observer)]) });
        using var guesses = new CancellationTokenSource();
        var held = new List<Task>();
        for (var i = 1; i <= 10 * PairingLimits.WrongCodesPerMinute; i++)
        {
            held.Add(AskAsync(gateway, $"guess {i}", guesses.Token));
            await Soon.BecomesAsync(() => gateway.WebSocketConnections[Closure.Token] == i, "the wrong token is counted");
        }

        Assert.That((await AskAsync(gateway, valid)).Status, Is.EqualTo(HttpStatusCode.OK));
        Assert.That(await RawSyncClient.IsAcceptedAsync(gateway, valid), Is.True);
        await guesses.CancelAsync();
        await Task.WhenAll(held).ContinueWith(_ => { }, TaskScheduler.Default);
    }

    [Test]
    public async Task HttpRequests_WrongTokensOnParallelConnections_AreDelayedByLessThanClientsWait()
    {
        var time = new RecordedDelays();
        await using var gateway = await Gateways.StartAsync(Slow with { Time = time });
        for (var i = 0; i < PairingLimits.WrongCodesPerMinute; i++) await AskAsync(gateway, "guess");
        using var http = new HttpClient();

        var answers = Enumerable.Range(0, 3).Select(_ =>
        {
            var request = new HttpRequestMessage(HttpMethod.Get, new Uri($"http://127.0.0.1:{gateway.WebSocketEndPoint.Port}/metrics"));
            request.Headers.Authorization = new AuthenticationHeaderValue("Bearer", "guess");
            return http.SendAsync(request);
        }).ToList();

        await Soon.BecomesAsync(() => time.Long.Count == answers.Count, "all responses are delayed");
        Assert.That(time.Long, Is.All.EqualTo(Slow.WrongTokenDelay));
        Assert.That(new GatewayOptions().WrongTokenDelay, Is.LessThan(ProtocolLimits.SyncReplyTimeout));
        Assert.That(answers, Has.None.Matches<Task>(answer => answer.IsCompleted));
        Assert.That((await AskAsync(gateway, Gateways.ObserverToken)).Status, Is.EqualTo(HttpStatusCode.OK),
            "the response to a known token is not delayed");
        time.End();
        foreach (var answer in answers) Assert.That((await answer.Bounded()).StatusCode, Is.EqualTo(HttpStatusCode.Unauthorized));
    }

    [TestCase("/operations/login", "{\"token\":\"guess\"}")]
    [TestCase("/pair", "{\"token\":\"guess\",\"name\":\"a\"}")]
    public async Task FormRequests_ManyWrongTokensInParallel_AreLimitedLikeSequentialRequests(string path, string body)
    {
        const int Requests = PairingLimits.WrongCodesPerMinute + 3;
        await using var gateway = await PairingGateway.StartAsync(isSecure: false, Gateways.Tokens);
        var clients = new List<HalfRequest>();
        for (var i = 0; i < Requests; i++) clients.Add(await HalfRequest.BeginAsync(gateway.Server, path, body.Length));

        var statuses = new List<int>();
        foreach (var client in clients) statuses.Add(await client.EndAsync(body));

        Assert.That(statuses.Count(status => status == 401), Is.EqualTo(PairingLimits.WrongCodesPerMinute));
        Assert.That(statuses.Count(status => status == 429), Is.EqualTo(Requests - PairingLimits.WrongCodesPerMinute));
        clients.ForEach(client => client.Dispose());
    }

    [Test]
    public async Task HttpRequest_WithoutAToken_IsNotCounted()
    {
        await using var gateway = await Gateways.StartAsync(Slow);

        for (var i = 0; i < 3 * PairingLimits.WrongCodesPerMinute; i++)
            Assert.That((await AskAsync(gateway, null)).Status, Is.EqualTo(HttpStatusCode.Unauthorized));
    }

    [Test]
    public async Task SyncPort_ManyWrongTokens_DelaysThemButNotAValidToken()
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
        Assert.That(answer.IsCompleted, Is.False, "the response to the wrong token is delayed");
    }

    [Test]
    public async Task WrongTokens_OnOnePort_DelayAnswersOnTheOtherPort()
    {
        await using var gateway = await Gateways.StartAsync(WithTokens with { WrongTokenDelay = TimeSpan.Zero });
        for (var i = 0; i < PairingLimits.WrongCodesPerMinute; i++)
        {
            using var wrong = await RawSyncClient.ConnectAsync(gateway);
            await wrong.SendAsync(SyncToken.Write("guess"));
            await wrong.ReceiveAsync();
        }

        Assert.That((await AskAsync(gateway, "guess")).RetryAfter, Is.Not.Null);
    }

    /// <summary>Sends the header of a request, which the gateway reads, and delays the body.</summary>
    sealed class HalfRequest(TcpClient client) : IDisposable
    {
        public static async Task<HalfRequest> BeginAsync(GatewayServer gateway, string path, int length)
        {
            var client = new TcpClient();
            await client.ConnectAsync(gateway.WebSocketEndPoint).Bounded();
            var request = new HalfRequest(client);
            await request.SendAsync($"POST {path} HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: {length}\r\nExpect: 100-continue\r\n\r\n");
            Assert.That(await request.StatusAsync(), Is.EqualTo(100));
            return request;
        }

        public async Task<int> EndAsync(string body)
        {
            await SendAsync(body);
            return await StatusAsync();
        }

        public void Dispose() => client.Dispose();

        Task SendAsync(string text) => client.GetStream().WriteAsync(Encoding.ASCII.GetBytes(text)).AsTask().Bounded();

        async Task<int> StatusAsync()
        {
            // Reads "HTTP/1.1 100 Continue" and an empty line, or the first 25 bytes of another response.
            var answer = new byte[25];
            await client.GetStream().ReadExactlyAsync(answer).AsTask().Bounded();
            return int.Parse(Encoding.ASCII.GetString(answer, 9, 3), CultureInfo.InvariantCulture);
        }
    }

    /// <summary>Records delays that are at least as long as the delays after wrong tokens. A delay lasts until the test ends it.</summary>
    sealed class RecordedDelays : TimeProvider
    {
        readonly List<(TimeSpan Delay, Action End)> _delays = [];

        public IReadOnlyList<TimeSpan> Long
        {
            get
            {
                lock (_delays) return [.. _delays.Select(one => one.Delay)];
            }
        }

        public override ITimer CreateTimer(TimerCallback callback, object state, TimeSpan dueTime, TimeSpan period)
        {
            if (dueTime < Slow.WrongTokenDelay) return base.CreateTimer(callback, state, dueTime, period);
            lock (_delays) _delays.Add((dueTime, () => callback(state)));
            return base.CreateTimer(callback, state, Timeout.InfiniteTimeSpan, Timeout.InfiniteTimeSpan);
        }

        public override long GetTimestamp() => 0;

        public void End()
        {
            lock (_delays)
                foreach (var (_, end) in _delays) end();
        }
    }

    static async Task<(HttpStatusCode Status, TimeSpan? RetryAfter)> AskAsync(GatewayServer gateway, string token, CancellationToken stop = default)
    {
        using var http = new HttpClient();
        using var request = new HttpRequestMessage(HttpMethod.Get, new Uri($"http://127.0.0.1:{gateway.WebSocketEndPoint.Port}/metrics"));
        if (token != null) request.Headers.Authorization = new AuthenticationHeaderValue("Bearer", token);
        using var answer = await http.SendAsync(request, stop).Bounded();
        return (answer.StatusCode, answer.Headers.RetryAfter?.Delta);
    }
}
