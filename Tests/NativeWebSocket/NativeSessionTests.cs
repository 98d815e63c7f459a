using Nowpose.Gateway;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Plants;
using Nowpose.Latency;
using Nowpose.Motion;
using Nowpose.Network;
using Nowpose.Session;
using Nowpose.Simulation.Work;
using Nowpose.Unity;
using Nowpose.Unity.Session;
using NUnit.Framework;

namespace Nowpose.Headless.Tests;

/// <summary>Tests a whole session over NativeWebSocket with the real gateway.</summary>
public class NativeSessionTests
{
    readonly StopwatchHeadsetClock _headset = new();
    readonly StopwatchControlClock _control = StopwatchControlClock.FromUnixTime();

    [Test]
    public async Task Session_GatewayKilledAndRestarted_IsCurrentAgain()
    {
        var made = 0;
        using var cell = Cell();
        var gateway = await StartAsync(0, 0, cell);
        var (syncPort, webSocketPort) = (gateway.SyncEndPoint.Port, gateway.WebSocketEndPoint.Port);
        using var session = new CompensationSession(
            new SessionSettings(
                new ConnectionSettings("127.0.0.1", syncPort, webSocketPort), new VisualisationLatency(TimeSpan.FromMilliseconds(40))),
            RobotFiles.Load("youbot"), _headset, (settings, clock) =>
            {
                Interlocked.Increment(ref made);
                return Transport.Create(settings, clock);
            });
        session.Connect();
        await Soon.BecomesAsync(() => session.Tick(_headset.Now).State == PoseState.Current, "current before");

        await gateway.DisposeAsync();
        await Soon.BecomesAsync(() => session.Tick(_headset.Now).State == PoseState.Held, "held while the gateway is gone");
        await using var again = await StartAsync(syncPort, webSocketPort, cell);
        await Soon.BecomesAsync(() => session.Tick(_headset.Now).State == PoseState.Current, "current after");

        Assert.That(made, Is.GreaterThan(1));
        Assert.That(session.Drops.Total, Is.EqualTo(0));
    }

    [Test]
    public void Transport_NativeWebSocketInstalled_IsUsedExceptWithPins()
    {
        var pin = Nowpose.Protocol.CertificatePin.Of(Nowpose.Gateway.Security.CertificateFiles.Generate());

        Assert.That(Transport.Create(new ConnectionSettings("127.0.0.1"), _headset), Is.TypeOf<NativeWebSocketLink>());
        Assert.That(Transport.Create(new ConnectionSettings("192.0.2.1", deviceTrust: true), _headset), Is.TypeOf<NativeWebSocketLink>());
        Assert.That(Transport.Create(new ConnectionSettings("192.0.2.1", pin: pin), _headset), Is.TypeOf<SystemWebSocketLink>());
    }

    SimulatedCell Cell() => new(
        new CellMotion(new PickAndPlaceMotion(RobotFiles.Load("youbot"))), _control,
        new CellTiming(TimeSpan.FromMilliseconds(50), TimeSpan.FromMilliseconds(10), TimeSpan.FromMilliseconds(20)), seed: 1);

    async Task<GatewayServer> StartAsync(int syncPort, int webSocketPort, SimulatedCell cell)
    {
        var gateway = await Gateways.StartAsync(new GatewayOptions { SyncPort = syncPort, WebSocketPort = webSocketPort }, _control);
        cell.PublishInto(gateway.Hub);
        return gateway;
    }
}
