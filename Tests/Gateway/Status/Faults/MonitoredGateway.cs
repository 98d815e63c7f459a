using System.Globalization;
using System.Net;
using System.Net.Http.Headers;
using System.Text.Json;
using Nowpose.Gateway;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Hub;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Status.Faults;

/// <summary>Runs a gateway with one source in virtual time, and sends it the requests of a monitoring system.</summary>
sealed class MonitoredGateway : IAsyncDisposable
{
    readonly List<string> _log = [];
    IControlClock _clock;

    public SteppedTime Time { get; } = new();
    public GatewayServer Server { get; private set; }
    public HubSource Source { get; private set; }

    /// <summary>Lines that the gateway has logged so far.</summary>
    public string[] Log
    {
        get
        {
            lock (_log) return [.. _log];
        }
    }

    public async Task StartAsync(Func<GatewayOptions, GatewayOptions> with = null, IControlClock clock = null)
    {
        var options = Gateways.Options() with { Time = Time };
        _clock = clock ?? new StopwatchControlClock(Gateways.Start);
        Server = await GatewayServer.StartAsync(with?.Invoke(options) ?? options, _clock, AddToLog).Bounded();
        Source = Server.Hub.OpenSource();
    }

    public async ValueTask DisposeAsync()
    {
        Source?.Dispose();
        if (Server != null) await Server.DisposeAsync();
    }

    public Task<(HttpStatusCode Status, string Text, HttpContentHeaders Headers)> GetAsync(string path, string token = null) =>
        StatusRequests.GetAsync(Server, path, token);

    public Task<JsonElement> StateAsync() => StatusRequests.StateAsync(Server);

    public async Task<string[]> ReadyAsync(HttpStatusCode expected)
    {
        var (status, text, _) = await GetAsync("/readyz");
        Assert.That(status, Is.EqualTo(expected), text);
        return text.TrimEnd('\n').Split('\n');
    }

    public void Publish(params string[] joints) => Source.Publish(new JointStateMessage(_clock.Now, joints, [.. joints.Select(_ => 1.0)]));

    public void Report(string name, params (string Key, string Value)[] values) =>
        Source.Publish(RosTopics.Diagnostics, new DiagnosticsMessage(
            new ControlTime(Time.GetUtcNow() - DateTimeOffset.UnixEpoch), name, [.. values.Select(pair => KeyValuePair.Create(pair.Key, pair.Value))]));

    public string Since(double secondsAgo = 0) =>
        ((Time.GetUtcNow() - TimeSpan.FromSeconds(secondsAgo)).ToUnixTimeMilliseconds() / 1000.0).ToString("0.000", CultureInfo.InvariantCulture);

    public async Task<JsonElement> EventAsync(string kind, string which) =>
        (await StateAsync()).GetProperty("events").EnumerateArray().FirstOrDefault(
            one => one.GetProperty("kind").GetString() == kind && one.GetProperty("which").GetString() == which);

    // The gateway updates the event list several times per second.
    public Task BeginsAsync(string kind, string which) => Soon.BecomesAsync(
        () => EventAsync(kind, which).Result.ValueKind == JsonValueKind.Object, $"{kind} {which} begins");

    public Task EndsAsync(string kind, string which) => Soon.BecomesAsync(
        () => EventAsync(kind, which).Result is { ValueKind: JsonValueKind.Object } one && one.TryGetProperty("until_utc", out _),
        $"{kind} {which} ends");

    public bool Logged(string part) => Log.Any(line => line.Contains(part, StringComparison.Ordinal));

    void AddToLog(string line)
    {
        lock (_log) _log.Add(line);
    }
}
