using System.Security.Cryptography.X509Certificates;
using Nowpose.Gateway;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Plants;
using Nowpose.Gateway.Security;
using Nowpose.Motion;
using Nowpose.Protocol;
using Nowpose.Simulation.Work;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Session;

/// <summary>Tests headset and clients in separate processes, as on other machines, with TLS and tokens.</summary>
public class SecondProcessTests
{
    const string ObserverToken = "observer-3f9d2c";
    const string SourceToken = "source-77aa01";

    const string Sample = """{"op":"publish","topic":"/joint_states","msg":"""
        + """{"header":{"stamp":{"sec":1700000000,"nanosec":1}},"name":["NAME"],"position":[0.5]}}""";

    GatewayServer _gateway;
    SimulatedCell _cell;

    async Task StartAsync(X509Certificate2 certificate)
    {
        var clock = StopwatchControlClock.FromUnixTime();
        _gateway = await GatewayServer.StartAsync(
            new GatewayOptions
            {
                SyncPort = 0,
                WebSocketPort = 0,
                Certificate = certificate,
                Tokens = new TokenList([(ObserverToken, Role.Observer), (SourceToken, Role.Source)]),
            },
            clock);
        _cell = new SimulatedCell(
            new CellMotion(new PickAndPlaceMotion(RobotFiles.Load("youbot"))), clock,
            new CellTiming(TimeSpan.FromMilliseconds(50), TimeSpan.FromMilliseconds(10), TimeSpan.FromMilliseconds(20)), seed: 1);
        _cell.PublishInto(_gateway.Hub);
    }

    [TearDown]
    public async Task Stop()
    {
        _cell?.Dispose();
        if (_gateway != null) await _gateway.DisposeAsync();
    }

    PeerProcess Headset(string pin, string token) => new(
        "Nowpose.Peer.dll", "headset", "127.0.0.1", Port(_gateway.SyncEndPoint), Port(_gateway.WebSocketEndPoint), pin, token);

    PeerProcess Client(string token, string origin = "-") => new(
        "Nowpose.Peer.dll", "client", $"wss://127.0.0.1:{Port(_gateway.WebSocketEndPoint)}/", _gateway.Pin.ToString(), token, origin);

    static string Port(System.Net.IPEndPoint endPoint) => endPoint.Port.ToString();

    [Test]
    public async Task Headset_PinAndToken_SynchronisesAndShowsTheRobot()
    {
        await StartAsync(CertificateFiles.Generate());
        using var headset = Headset(_gateway.Pin.ToString(), ObserverToken);

        await Soon.BecomesAsync(
            () => headset.Printed("pose Current | clock Synchronised | sync Connected: connected | positions Connected: connected"), "current");
    }

    [Test]
    public async Task Headset_WrongPin_EndsBothConnections()
    {
        await StartAsync(CertificateFiles.Generate());
        var other = CertificatePin.Of(CertificateFiles.Generate());
        using var headset = Headset(other.ToString(), ObserverToken);

        await Soon.BecomesAsync(
            () => headset.Printed("clock sync: certificate: its pin is") && headset.Printed("joint positions: certificate: its pin is"), "refused");
        Assert.That(headset.All, Does.Contain(_gateway.Pin.ToString()).And.Contain(other.ToString()), "both pins are named");
        Assert.That(headset.All, Does.Not.Contain("Connected").And.Not.Contain(ObserverToken));
    }

    [Test]
    public async Task Headset_WrongToken_GatewayRefusesBothConnections()
    {
        await StartAsync(CertificateFiles.Generate());
        using var headset = Headset(_gateway.Pin.ToString(), "guessed");

        await Soon.BecomesAsync(() => headset.Printed("sync Waiting: clock sync: the gateway does not accept this headset's token"), "sync refused");
        await Soon.BecomesAsync(() => headset.Printed("the gateway does not accept this headset's token (401)"), "WebSocket refused");
        Assert.That(headset.All, Does.Not.Contain("Connected").And.Not.Contain("guessed"));
    }

    [Test]
    public async Task Headset_ExpiredCertificateWithCorrectPin_EndsTheConnection()
    {
        await StartAsync(CertificateFiles.Generate(DateTimeOffset.UtcNow.AddDays(-30), DateTimeOffset.UtcNow.AddDays(-1)));
        using var headset = Headset(_gateway.Pin.ToString(), ObserverToken);

        await Soon.BecomesAsync(
            () => headset.Printed("clock sync: certificate: expired on") && headset.Printed("joint positions: certificate: expired on"), "refused");
        Assert.That(headset.All, Does.Not.Contain("Connected"));
    }

    [Test]
    public async Task Client_ForeignOrigin_GatewayRefusesIt()
    {
        await StartAsync(CertificateFiles.Generate());
        using var client = Client(ObserverToken, "https://elsewhere.example");

        await Soon.BecomesAsync(() => client.Printed("refused:"), "refused");
        Assert.That(client.All, Does.Contain("403"));
    }

    [Test]
    public async Task Client_ObserverPublishes_ReceivesTheReason()
    {
        await StartAsync(CertificateFiles.Generate());
        using var client = Client(ObserverToken);
        await Soon.BecomesAsync(() => client.Printed("connected"), "connected");

        client.Send(Sample.Replace("NAME", "extra_axis"));

        await Soon.BecomesAsync(() => client.Printed("\"status\""), "a status");
        Assert.That(client.All, Does.Contain($"({nameof(DropReason.NotAllowed)})"));
        Assert.That(_gateway.Drops[DropReason.NotAllowed], Is.EqualTo(1));
    }

    [Test]
    public async Task Client_PublishesAJointOfAnotherSource_ReceivesAStatusThatNamesTheJoint()
    {
        await StartAsync(CertificateFiles.Generate());
        using var client = Client(SourceToken);
        await Soon.BecomesAsync(() => client.Printed("connected"), "connected");

        client.Send(Sample.Replace("NAME", "arm_joint_1"));

        await Soon.BecomesAsync(() => client.Printed("\"status\""), "a status");
        Assert.That(client.All, Does.Contain("arm_joint_1"));
        Assert.That(_gateway.Drops[DropReason.JointTaken], Is.EqualTo(1));
    }
}
