using System.Net;
using Nowpose.Frames;
using Nowpose.Gateway.Messages;
using NUnit.Framework;
using Nowpose.Gateway.Security;
using Nowpose.Headless.Tests.Gateway.Cell;
using Nowpose.Protocol.Cell;

namespace Nowpose.Headless.Tests.Gateway;

public class ConfigurationCheckTests : ConfigurationFixture
{
    [Test]
    public async Task Check_MissingFiles_CreatesNothing()
    {
        var (status, output, _) = await CheckAsync(
            "ws-port: 0\nsync-port: 0\ncertificate: gateway.pem\npairing: headsets.txt\nrecordings: films\nrecord: true\n");

        Assert.That(status, Is.EqualTo(0));
        Assert.That(output.Count(line => line.EndsWith("(would be created)", StringComparison.Ordinal)), Is.EqualTo(3), string.Join(" | ", output));
        Assert.That(Directory.GetFileSystemEntries(_folder).Select(Path.GetFileName), Is.EqualTo(new[] { "gateway.yaml" }));
    }

    [Test]
    public async Task Check_SeveralErrors_ReportsAll()
    {
        using var expired = CertificateFiles.Generate(DateTimeOffset.UtcNow.AddDays(-10), DateTimeOffset.UtcNow.AddDays(-1));
        File.WriteAllBytes(Path.Combine(_folder, "old.pfx"), expired.Export(System.Security.Cryptography.X509Certificates.X509ContentType.Pfx));
        Save("observer\n", "tokens.txt");
        Save("nonsense\n", "headsets.txt");
        await using var other = await Gateways.StartAsync();

        var (status, output, errors) = await CheckAsync(
            $"ws-port: {other.WebSocketEndPoint.Port}\nsync-port: {other.SyncEndPoint.Port}\ncertificate: old.pfx\ntokens: tokens.txt\n"
            + "pairing: headsets.txt\nrecordings: headsets.txt\nrobot: none.urdf\nplants: [none.yaml]\n");

        Assert.That(status, Is.EqualTo(2));
        foreach (var part in new[] { "old.pfx", "tokens.txt, line 1", "headsets.txt, line 1", "is a file", "none.urdf" })
            Assert.That(errors, Has.Some.Contains(part), string.Join(" | ", errors));
        // Errors in tokens.txt and headsets.txt contain the line numbers of these files.
        foreach (var (line, part) in new[] { (3, "certificate: "), (6, "recordings "), (7, "robot: "), (8, "plants: ") })
            Assert.That(errors, Has.Some.Contains($"gateway.yaml:{line}: {part}"), string.Join(" | ", errors));
        Assert.That(output, Does.Not.Contain("state checked"));
    }

    [Test]
    public async Task Check_InvalidEntriesAndFiles_ReportsAll()
    {
        Save("observer\n", "tokens.txt");

        var (status, output, errors) = await CheckAsync(
            "bind: nowhere\nws-port: 0\nsync-port: 0\ntokens: tokens.txt\nrobot: none.urdf\nplants: [none.yaml]\nws-prot: 1\n");

        Assert.That(status, Is.EqualTo(2));
        foreach (var part in new[] { "gateway.yaml:1: bind: ", "tokens.txt, line 1", "gateway.yaml:5: robot: ", "gateway.yaml:6: plants: ", "gateway.yaml:7: ws-prot: " })
            Assert.That(errors, Has.Exactly(1).Contains(part), string.Join(" | ", errors));
        Assert.That(errors, Has.Length.EqualTo(5));
        Assert.That(output, Does.Not.Contain("state checked"));
    }

    [Test]
    public async Task Check_InvalidEntryThatAnotherOneNeeds_ReportsOnlyTheInvalidEntry()
    {
        var (_, _, errors) = await CheckAsync(
            "ws-port: 0\nsync-port: 0\nbind: any\ncertificate: [a, b]\ncertificate-key: key.pem\npairing: headsets.txt\nrecordings: {}\nrecord: true\n");

        Assert.That(errors, Has.Length.EqualTo(2), string.Join(" | ", errors));
        Assert.That(errors, Has.One.Contains("gateway.yaml:4: certificate: ").And.One.Contains("gateway.yaml:7: recordings: "));
    }

    // The invalid entries do not concern the other rules.
    [Test]
    public async Task Check_InvalidEntryAndOptionsThatContradictEachOther_ReportsAll()
    {
        var (_, _, errors) = await CheckAsync(
            "ws-port: 47010\nmax-connections: many\nbind: any\nrecord: true\ncertificate-key: key.pem\nown-clock: system\nclock-start-s: 5\n"
            + "skew-ppm: 3\nspeed: 1\n");

        var expected = new[]
        {
            "gateway.yaml:2: max-connections: ", "gateway.yaml:9: speed: ",
            "gateway.yaml:1: " + AddressOptionMessages.SamePorts("ws-port", 47010), "gateway.yaml:3: " + AddressOptionMessages.PlainBind(IPAddress.Any)["--".Length..],
            "gateway.yaml:4: " + RecorderMessages.RecordWithoutFolder["--".Length..], "gateway.yaml:5: " + AddressOptionMessages.KeyWithoutCertificate["--".Length..],
            "gateway.yaml:7: " + AddressOptionMessages.ClockStart["--".Length..], "gateway.yaml:8: " + AddressOptionMessages.Skew["--".Length..],
        };
        foreach (var part in expected) Assert.That(errors, Has.One.Contains(part), string.Join(" | ", errors));
        Assert.That(errors, Has.Length.EqualTo(expected.Length), string.Join(" | ", errors));
    }

    [TestCase("sync-port: x\nws-port: 47010", 1)]
    [TestCase("bind: nowhere\ntokens: tokens.txt\npairing: headsets.txt", 1)]
    [TestCase("bind: any\ntls: maybe\ntokens: tokens.txt", 1)]
    [TestCase("bind: any\ninsecure-lam: true", 1)]
    [TestCase("bind: any\ninsecure-lam: {a: b}", 1)]
    [TestCase("bind: any\ntokens: [a, b]", 1)]
    [TestCase("bind: any\npairing: [a, b]", 1)]
    [TestCase("bind: any\ntokens: tokens.txt\npairing: headsets.txt", 2)]
    [TestCase("record: true\nrecordngs: films", 1)]
    [TestCase("tls: true\ncertificate: [a]\npairing: headsets.txt", 1)]
    [TestCase("bind: 127.0.0.1\ncertificate: a.pem\ncertificate-key: [a]", 1)]
    [TestCase("bind: 192.0.2.1\ntls: maybe\nplants: [none.yaml]", 3)]
    public async Task Check_InvalidEntryThatARuleNeeds_SkipsTheRule(string text, int count)
    {
        Save("observer 0123456789abcdef0123456789abcdef\n", "tokens.txt");
        Save("no certificate", "a.pem");

        var (status, _, errors) = await CheckAsync(text + "\n", text.Contains("port") ? [] : ["--ws-port", "0", "--sync-port", "0"]);

        Assert.That(status, Is.EqualTo(2));
        Assert.That(errors, Has.Length.EqualTo(count), string.Join(" | ", errors));
    }

    // A line would contain the default.
    [TestCase("bind: nowhere", "websocket, sync")]
    [TestCase("sync-port: x", "sync")]
    [TestCase("ws-port: x", "websocket")]
    [TestCase("ws-prot: 80", "websocket")]
    [TestCase("tls: maybe", "websocket")]
    [TestCase("certificate: [a, b]", "websocket")]
    [TestCase("robot: none.urdf", "robot")]
    [TestCase("]", "websocket, sync")]
    public async Task Check_InvalidEntry_PrintsNoLineAboutIt(string entry, string omitted)
    {
        var others = string.Concat(new[] { "robot: ur5", "ws-port: 0", "sync-port: 0" }.Where(other => other[..3] != entry[..Math.Min(3, entry.Length)]).Select(other => other + "\n"));

        var (status, output, _) = await CheckAsync(others + entry + "\n");

        Assert.That(status, Is.EqualTo(2));
        string[] all = ["robot", "sync", "websocket"];
        Assert.That(output.Select(line => line.Split(' ')[0]).Order(), Is.EqualTo(all.Except(omitted.Split(", "))), string.Join(" | ", output));
    }

    // The parent may be a link of the robot or a frame of the plant.
    [TestCase("robot: none.urdf")]
    [TestCase("robot: [ur5]")]
    [TestCase("plants: {}")]
    [TestCase("rabot: ur5")]
    public async Task Check_InvalidRobotOrPlants_DoesNotReportMissingParents(string entry)
    {
        StationaryFrameFile.Save(Path.Combine(_folder, "objects.json"), new TransformsMessage([CellTexts.Frame("fixture", "flange")]));

        var (status, output, _) = await CheckAsync("ws-port: 0\nsync-port: 0\nstationary: objects.json\n" + entry + "\n");

        Assert.That(status, Is.EqualTo(2));
        Assert.That(output, Has.None.StartsWith("missing_parents "), string.Join(" | ", output));
    }

    [Test]
    public async Task Check_InvalidCertificateFile_PrintsTheAddressOfEncryptedConnections()
    {
        Save("no certificate", "a.pem");

        var (_, output, _) = await CheckAsync("ws-port: 0\nsync-port: 0\ncertificate: a.pem\n");

        Assert.That(output, Does.Contain("websocket wss://127.0.0.1:0/"));
    }

    // The columns are joints of the ur5, and the default robot is the youBot.
    [TestCase("robot: [ur5]")]
    [TestCase("robot: none.urdf")]
    public async Task Check_InvalidRobotOfARecording_DoesNotCompareTheRecordingWithTheDefaultRobot(string robot)
    {
        Save("t_s,shoulder_pan_joint,elbow_joint\n0,0,0\n1,0.1,0.1\n2,0.2,0.2\n", "motion.csv");

        var (output, errors) = await CheckReplayAsync(robot);

        Assert.That(errors, Has.Length.EqualTo(1).And.One.Contains("gateway.yaml:1: robot: "), string.Join(" | ", errors));
        Assert.That(output, Has.None.StartsWith("robot "), string.Join(" | ", output));
    }

    [TestCase("robot: [ur5]")]
    [TestCase("robot: none.urdf")]
    public async Task Check_InvalidRobotOfAnInvalidRecording_ReportsBoth(string robot)
    {
        Save("no recording\n", "motion.csv");

        var (_, errors) = await CheckReplayAsync(robot);

        Assert.That(errors, Has.Length.EqualTo(2), string.Join(" | ", errors));
        Assert.That(errors, Has.One.Contains("gateway.yaml:1: robot: ").And.One.Contains("motion.csv"), string.Join(" | ", errors));
    }

    async Task<(string[] Output, string[] Errors)> CheckReplayAsync(string robot)
    {
        var configuration = Save(robot + "\nws-port: 0\nsync-port: 0\n");
        var (_, output, errors) = await CapturedConsole.OfAsync(() => Nowpose.Gateway.CommandLine.RunAsync(
            ["replay", Path.Combine(_folder, "motion.csv"), "--config", configuration, "--check"]).Bounded());
        return (CapturedConsole.Lines(output), CapturedConsole.Lines(errors));
    }

    // No entry after the error can be read.
    [Test]
    public async Task Check_FileIsNotYaml_SkipsAllRules()
    {
        var (_, _, errors) = await CheckAsync("bind: any\nws-port: 0\nsync-port: 0\nrecord: true\n]\n");

        Assert.That(errors, Has.Length.EqualTo(1), string.Join(" | ", errors));
    }

    [Test]
    public async Task Check_InvalidTokenFileWithoutTls_ReportsBoth()
    {
        Save("observer\n", "tokens.txt");

        var (_, _, errors) = await CheckAsync("ws-port: 0\nsync-port: 0\nbind: any\ninsecure-lan: true\ntokens: tokens.txt\n");

        Assert.That(errors, Has.One.Contains("tokens.txt, line 1"));
        Assert.That(errors, Has.One.EndsWith("gateway.yaml:5: " + AddressOptionMessages.TokensWithoutTls(IPAddress.Any)["--".Length..]), string.Join(" | ", errors));
    }

    [Test]
    public async Task Check_PortsInUse_ReportsThemAndSucceeds()
    {
        await using var other = await Gateways.StartAsync();
        var (sync, webSocket) = (other.SyncEndPoint.Port, other.WebSocketEndPoint.Port);
        var text = $"ws-port: {webSocket}\nsync-port: {sync}\n";

        var (status, output, errors) = await CheckAsync(text);

        Assert.That(status, Is.EqualTo(0), string.Join(" | ", errors));
        Assert.That(output, Does.Contain($"sync 127.0.0.1:{sync}{DryRunMessages.PortInUse(sync)}"));
        Assert.That(output, Does.Contain($"websocket ws://127.0.0.1:{webSocket}/{DryRunMessages.PortInUse(webSocket)}"));
        var started = await RunAsync(text, false);
        Assert.That(started.Status, Is.EqualTo(1));
        Assert.That(started.Errors.Single(), Does.Contain("gateway.yaml:2: sync-port "));
    }

    [TestCase("{sync-port: 47999, ws-port: 47999}", "ws-port", 47999)]
    [TestCase("sync-port: 47011", "sync-port", 47011)]
    [TestCase("ws-port: 47010", "ws-port", 47010)]
    public async Task Ports_Equal_AreReportedByCheckAndStart(string entry, string option, int port)
    {
        foreach (var isCheck in new[] { true, false })
        {
            var (status, _, errors) = await RunAsync("# comment\n\n" + entry + "\n", isCheck);

            Assert.That(status, Is.EqualTo(2));
            Assert.That(errors.Single(), Does.EndWith("gateway.yaml:3: " + AddressOptionMessages.SamePorts(option, port)));
        }
    }

    // No user, not even root, can create files in /proc. Only --check reports the folder. A normal start continues, as it does when the disk
    // fails later.
    [Test]
    [Platform("Linux")]
    public async Task Check_RecordingsFolderNotWritable_ReportsItWithItsLineNumber()
    {
        var (status, _, errors) = await CheckAsync("ws-port: 0\nsync-port: 0\nrecordings: /proc\n");

        Assert.That(status, Is.EqualTo(2));
        Assert.That(errors.Single(), Does.EndWith("gateway.yaml:3: " + DryRunMessages.NotWritable("recordings", "/proc", "/proc")));
    }

    static readonly string[][] UnusableEntries =
    [
        ["robot: yubot", "robot: ", PathMessages.NotFound("yubot", PlantMessages.Robots("youbot, ur5, ur3e, ur5e, ur10e, ur16e"))],
        ["robot: models/press.xml", "robot: ", PathMessages.NotFound("models/press.xml", "")],
        ["certificate: .", "certificate", ""],
        ["pairing: .", "pairing", ""],
        ["certificate: /proc/gateway.pem", "certificate", ""],
        ["pairing: /proc/headsets.txt", "pairing", ""],
        ["tokens: none.txt", "tokens: ", "none.txt: cannot be read"],
        ["bind: any", "", AddressOptionMessages.PlainBind(IPAddress.Any)["--".Length..]],
        ["record: true", "", RecorderMessages.RecordWithoutFolder["--".Length..]],
        ["robot: none.urdf", "robot: ", PathMessages.NotFound("none.urdf", "")],
        ["certificate-key: a.pem", "", AddressOptionMessages.KeyWithoutCertificate["--".Length..]],
        ["plants: [none.yaml]", "plants: ", PathMessages.NotFound("none.yaml", "")],
    ];

    [TestCaseSource(nameof(UnusableEntries))]
    public async Task Entry_Unusable_IsReportedWithItsLineNumberByCheckAndStart(string entry, string part, string more)
    {
        foreach (var isCheck in new[] { true, false })
        {
            var (status, _, errors) = await RunAsync("# comment\n\n" + entry + "\n", isCheck, "--ws-port", "0", "--sync-port", "0");

            Assert.That(status, Is.EqualTo(2));
            Assert.That(errors.Single(), Does.Contain("gateway.yaml:3: " + part).And.Contain(more));
        }
    }
}
