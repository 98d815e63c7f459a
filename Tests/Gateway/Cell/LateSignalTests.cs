using System.Text.Json;
using Nowpose.Gateway;
using Nowpose.Protocol;
using NUnit.Framework;
using static Nowpose.Headless.Tests.Gateway.Cell.CellTexts;

namespace Nowpose.Headless.Tests.Gateway.Cell;

/// <summary>Tests which value of a signal the gateway keeps if the values do not arrive in the order of their time stamps.</summary>
public class LateSignalTests
{
    GatewayServer _gateway;
    RawRosbridgeClient _source, _headset;

    [SetUp]
    public async Task StartAsync()
    {
        _gateway = await Gateways.StartAsync();
        _source = await RawRosbridgeClient.ConnectAsync(_gateway);
        _headset = await RawRosbridgeClient.ConnectAsync(_gateway);
    }

    [TearDown]
    public async Task StopAsync()
    {
        _source.Dispose();
        _headset.Dispose();
        await _gateway.DisposeAsync();
    }

    async Task SendAsync(string text)
    {
        await _source.SendAsync(text);
        await _source.RoundTripAsync();
    }

    async Task<double> GripInStateAsync()
    {
        using var http = new HttpClient();
        var text = await http.GetStringAsync(new UriBuilder(_gateway.WebSocketUri()) { Scheme = "http", Path = "/operations/state" }.Uri).Bounded();
        using var state = JsonDocument.Parse(text);
        return state.RootElement.GetProperty("signals").EnumerateArray().Single(one => one.GetProperty("name").GetString() == "grip").GetProperty("value").GetDouble();
    }

    // The last value is late by at most a second, or shows that the clock of the source went back.
    [TestCase(0.01, 1)]
    [TestCase(1, 1)]
    [TestCase(1.01, 0)]
    [TestCase(3000, 0)]
    public async Task Publish_OlderThanTheNewestValue_IsKeptOnlyIfTheClockWentBack(double olderSeconds, double expected)
    {
        await SendAsync(SignalsAt(ControlTime.FromSeconds(4000), ("grip", 1), ("lamp", 1)));
        await SendAsync(SignalsAt(ControlTime.FromSeconds(4000 - olderSeconds), ("grip", 0)));

        await _headset.SendAsync(RosbridgeWriter.Subscribe(RosTopics.Signals));

        var received = new Dictionary<string, double>();
        while (received.Count < 2)
        {
            var signals = (await _headset.ReceiveAsync()).Signals;
            for (var i = 0; i < signals.Count; i++) received.Add(signals[i].Name, signals[i].Value);
        }

        Assert.That((received["grip"], received["lamp"]), Is.EqualTo((expected, 1.0)));
        Assert.That(await GripInStateAsync(), Is.EqualTo(expected));
    }

    [Test]
    public async Task Publish_LateValueAfterAnotherSourceEnded_IsKept()
    {
        await SendAsync(SignalsAt(ControlTime.FromSeconds(4000), ("grip", 1)));
        _source.Dispose();
        await Soon.BecomesAsync(() => _gateway.WebSocketConnections.Open == 1, "the source has disconnected");
        _source = await RawRosbridgeClient.ConnectAsync(_gateway);
        await SendAsync(SignalsAt(ControlTime.FromSeconds(3999.9), ("grip", 0)));

        await _headset.SendAsync(RosbridgeWriter.Subscribe(RosTopics.Signals));

        Assert.That((await _headset.ReceiveAsync()).Signals.Text(), Is.EqualTo("grip=0"));
        Assert.That(await GripInStateAsync(), Is.Zero);
    }
}
