using System.Globalization;
using System.Net.Sockets;
using Nowpose.Gateway.Messages;
using NUnit.Framework;
using Nowpose.Gateway.Pairing;
using Nowpose.Gateway.Security;
using Nowpose.Headless.Tests.Cli;
using Nowpose.Messages;

namespace Nowpose.Headless.Tests.Gateway;

public class GatewayCommandLineTests
{
    static async Task<(int Status, string[] Errors)> RunAsync(params string[] args)
    {
        var (status, _, errors) = await CapturedConsole.OfAsync(() => Nowpose.Gateway.CommandLine.RunAsync(args).Bounded());
        return (status, CapturedConsole.Lines(errors));
    }

    [TestCase("--nonsense", "--nonsense")]
    [TestCase("juggle", "juggle")]
    [TestCase("simulate --nonsense", "--nonsense")]
    [TestCase("simulate --sync-port x", "--sync-port")]
    [TestCase("simulate --ws-port 65536", "65535")]
    [TestCase("simulate --sampling-ms 0", "--sampling-ms")]
    [TestCase("simulate --sampling-ms", "--sampling-ms")]
    [TestCase("simulate --acquisition-ms 9-3", "MIN-MAX")]
    [TestCase("simulate --acquisition-ms -5-3", "MIN-MAX")]
    [TestCase("simulate --bind nowhere", "--bind")]
    [TestCase("simulate --bind any", "--insecure-lan")]
    [TestCase("simulate --robot none.urdf", "none.urdf")]
    [TestCase("simulate --max-connections 0", "--max-connections")]
    [TestCase("serve --clock-start-s -1", "--clock-start-s")]
    [TestCase("serve --own-clock atomic", "monotonic, system")]
    [TestCase("serve --own-clock system --clock-start-s 5", "--clock-start-s")]
    [TestCase("serve --own-clock system --skew-ppm 5", "--skew-ppm")]
    [TestCase("serve --certificate-key key.pem", "--certificate")]
    [TestCase("serve --tokens none.txt", "none.txt")]
    [TestCase("serve --pairing list.txt --tls", "--certificate")]
    [TestCase("serve --pairing none/list.txt", "none/list.txt")]
    [TestCase("cell --cell a", "--host")]
    [TestCase("cell --cell a --host 10.0.0.7", "pin is missing")]
    [TestCase("cell --cell a --host 10.0.0.7 --pin x", "32 bytes")]
    [TestCase("cell --cell a --host 10.0.0.7 --certificate none.pfx", "file not found")]
    [TestCase("cell --cell a --host localhost --pin x --certificate none.pfx", "--pin")]
    [TestCase("cell --cell a --host localhost --offset 1,2", "--offset")]
    [TestCase("cell --cell a --host localhost --size-mm 0", "--size-mm")]
    [TestCase("cell --cell a --host localhost --out code.gif", ".svg or .png")]
    [TestCase("serve --recordings --record", "--recordings: value missing")]
    [TestCase("serve --certificate --tls", "--certificate: value missing")]
    [TestCase("serve --config --check", "--config: value missing")]
    [TestCase("pair --token-file none.txt", "none.txt")]
    [TestCase("pairings --pairing none.txt", "none.txt")]
    [TestCase("replay", "FILE")]
    [TestCase("replay none.csv", "none.csv")]
    [TestCase("", "command")]
    public async Task Arguments_Invalid_PrintOneLineAndExitWith2(string line, string part)
    {
        var (status, errors) = await RunAsync(line.Split(' ', StringSplitOptions.RemoveEmptyEntries));

        Assert.That(status, Is.EqualTo(2));
        Assert.That(errors.Length, Is.EqualTo(1), string.Join(" | ", errors));
        Assert.That(errors[0], Does.StartWith("nowpose-gateway: ").And.Contain(part));
    }

    [Test]
    public async Task Pair_NoGateway_PrintsOneLineAndExitsWith1()
    {
        var (status, errors) = await RunAsync("pair", "--ws-port", "1");

        Assert.That(status, Is.EqualTo(1));
        Assert.That(errors.Single(), Does.StartWith("nowpose-gateway: http://127.0.0.1:1/"));
    }

    // A gateway that does not listen on loopback shows the code only to operators.
    [TestCase(false)]
    [TestCase(true)]
    public async Task Pair_AddressOtherThanLoopback_ShowsTheCodeOnlyWithAnOperatorsToken(bool hasToken)
    {
        var lan = OwnHosts.AddressesOfThisMachine().FirstOrDefault(address => address.AddressFamily == AddressFamily.InterNetwork);
        if (lan == null) Assert.Ignore("this machine has no network");
        using var list = new TemporaryFile("");
        using var token = new TemporaryFile(Gateways.OperatorToken + "\n");
        using var certificate = CertificateFiles.Generate();
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with
        {
            Bind = lan,
            Certificate = certificate,
            Headsets = new HeadsetList(list.Path),
            Tokens = Gateways.Tokens,
        });
        string[] line = ["pair", "--host", $"{lan}", "--ws-port", $"{gateway.WebSocketEndPoint.Port}", "--pin", $"{gateway.Pin}"];
        if (hasToken) line = [.. line, "--token-file", token.Path];

        var (status, output, errors) = await CapturedConsole.OfAsync(() => Nowpose.Gateway.CommandLine.RunAsync(line).Bounded());

        Assert.That(status, Is.EqualTo(hasToken ? 0 : 1), errors);
        Assert.That(output.Contains("code nowpose:token"), Is.EqualTo(hasToken));
    }

    [Test]
    public async Task Pair_TokenWithoutPin_IsNotSentToAnotherMachine()
    {
        using var token = new TemporaryFile(Gateways.OperatorToken);

        var (status, errors) = await RunAsync("pair", "--host", "192.0.2.7", "--token-file", token.Path);

        Assert.That(status, Is.EqualTo(2));
        Assert.That(errors.Single(), Does.EndWith(ConnectionMessages.TokenUnencrypted("192.0.2.7")));
    }

    [TestCase("--sync-port {0} --ws-port 0", "--sync-port")]
    [TestCase("--sync-port 0 --ws-port {1}", "--ws-port")]
    [TestCase("--sync-port 0 --ws-port 0 --bind 192.0.2.7 --insecure-lan", "--bind 192.0.2.7: not an address of this machine")]
    public async Task Serve_PortUnavailable_PrintsOneLineAndExitsWith1(string line, string part)
    {
        await using var other = await Gateways.StartAsync();
        var ports = string.Format(CultureInfo.InvariantCulture, line, other.SyncEndPoint.Port, other.WebSocketEndPoint.Port);

        var (status, errors) = await RunAsync(["serve", .. ports.Split(' ')]);

        Assert.That(status, Is.EqualTo(1), "with this status a service manager starts the gateway again, because the cause may be temporary");
        Assert.That(errors.Single(), Does.StartWith("nowpose-gateway: ").And.Contain(part));
    }

    [Test]
    public async Task Serve_ConfiguredPortInUse_ReportsItsLineInTheFile()
    {
        await using var other = await Gateways.StartAsync();
        using var file = new TemporaryFile($"ws-port: 0\nsync-port: {other.SyncEndPoint.Port}\n");

        var (_, errors) = await RunAsync("serve", "--config", file.Path);

        Assert.That(errors.Single(), Does.Contain($"{file.Path}:2: sync-port"));
    }

    [Test]
    public async Task Pairings_RevokeWithoutPairedHeadsets_ReportsThatThereAreNone()
    {
        using var file = new TemporaryFile("# Headsets\n");

        var (status, errors) = await RunAsync("pairings", "--pairing", file.Path, "--revoke", "left door");

        Assert.That(status, Is.EqualTo(2));
        Assert.That(errors.Single(), Does.EndWith(VerbMessages.UnknownHeadset("left door", "none")));
    }

    [Test]
    public async Task Replay_MoreColumnsThanJoints_PrintsOneLineAndExitsWith2()
    {
        using var file = new TemporaryFile("t,a,b,c,d,e,f,g\n0,1,1,1,1,1,1,1\n1,1,1,1,1,1,1,1\n");

        var (status, errors) = await RunAsync("replay", file.Path, "--robot", "ur5");

        Assert.That(status, Is.EqualTo(2));
        Assert.That(errors.Single(), Does.Contain("7 columns"));
    }
}
