using NUnit.Framework;
using Nowpose.Gateway.Configuration;
using Nowpose.Gateway.Security;

namespace Nowpose.Headless.Tests.Gateway;

/// <summary>Tests the configuration file and --check through the command line.</summary>
public class ConfigurationTests
{
    string _folder;

    [SetUp]
    public void SetUp() => _folder = Directory.CreateTempSubdirectory("nowpose-configuration-").FullName;

    [TearDown]
    public void TearDown() => Directory.Delete(_folder, true);

    string Save(string text, string name = "gateway.yaml")
    {
        var path = Path.Combine(_folder, name);
        File.WriteAllText(path, text);
        return path;
    }

    Task<(int Status, string[] Output, string[] Errors)> CheckAsync(string text, params string[] typed) => RunAsync(text, true, typed);

    async Task<(int Status, string[] Output, string[] Errors)> RunAsync(string text, bool isCheck, params string[] typed)
    {
        string[] check = isCheck ? ["--check"] : [];
        var (status, output, errors) = await CapturedConsole.OfAsync(
            () => Nowpose.Gateway.CommandLine.RunAsync(["serve", "--config", Save(text), .. check, .. typed]).Bounded());
        return (status, CapturedConsole.Lines(output), CapturedConsole.Lines(errors));
    }

    [TestCase("bind: nowhere", "bind: 'nowhere' is not an address")]
    [TestCase("sync-port: 70000", "sync-port: 70000 is out of range; allowed: 0 to 65535")]
    [TestCase("sync-port: many", "'many' is not a number")]
    [TestCase("ws-prot: 1", "did you mean 'ws-port'?")]
    [TestCase("colour: red", "allowed: bind, cell")]
    [TestCase("tls: yes", "'yes' is neither true nor false")]
    [TestCase("cell: [a, b]", "is a list; give one value")]
    [TestCase("tokens:", "has no value")]
    [TestCase("ws-port: {a: b}", "must be a scalar")]
    [TestCase("plants: [[a]]", "must be a scalar")]
    [TestCase("cell: *anchor", "must be a scalar")]
    [TestCase("check: true", "no such entry")]
    [TestCase("config: other.yaml", "no such entry")]
    [TestCase("? [a]\n: b", "a key must be a scalar")]
    [TestCase("clock: UPPER", "'UPPER' is not a valid clock name")]
    [TestCase("\"a", ": not valid YAML")]
    [TestCase("plants: []", "has no value")]
    [TestCase("ws-port: []", "is a list; give one value")]
    [TestCase("tokens: \"a\\0b\"", "control character")]
    [TestCase("recordings: \"a\\0b\"", "control character")]
    [TestCase("cell: !secret foo", "without tags")]
    [TestCase("cell: &name foo", "without tags or anchors")]
    [TestCase("plants: [!file a.yaml]", "without tags")]
    [TestCase("plants: !files [a.yaml]", "without tags")]
    [TestCase("!secret cell: foo", "a key must be a scalar")]
    [TestCase("!all {cell: foo}", "\"key: value\"")]
    [TestCase("[a, b]", "\"key: value\"")]
    [TestCase("word", "\"key: value\"")]
    public async Task Entry_Invalid_IsReportedInOneLineWithFileLineNumberAndKey(string entry, string part)
    {
        foreach (var isCheck in new[] { true, false })
        {
            var (status, _, errors) = await RunAsync("# comment\n\n" + entry + "\n", isCheck, "--ws-port", "0", "--sync-port", "0");

            Assert.That(status, Is.EqualTo(2));
            Assert.That(errors, Has.Length.EqualTo(1), string.Join(" | ", errors));
            Assert.That(errors[0], Does.Contain("gateway.yaml:").And.Contain(part));
            if (!part.Contains("YAML")) Assert.That(errors[0], Does.Contain("gateway.yaml:3: "));
        }
    }

    [TestCase("{pairing: headsets.txt, cell: '@press'}")]
    [TestCase("{pairing: headsets.txt, cell: --tls}")]
    [TestCase("{pairing: headsets.txt, cell: press.urdf}")]
    [TestCase("skew-ppm: -5")]
    public async Task Entry_ValueLooksLikeAnArgument_IsReadAsAValue(string entry)
    {
        var (status, _, errors) = await CheckAsync(entry, "--ws-port", "0", "--sync-port", "0");

        Assert.That(status, Is.EqualTo(0), string.Join(" | ", errors));
    }

    [Test]
    public async Task Entries_SeveralInvalid_AreReportedTogether()
    {
        var (status, _, errors) = await CheckAsync("bind: nowhere\nws-prot: 1\nsync-port: 70000\nsync-port: 3\ntls: yes\n");

        Assert.That(status, Is.EqualTo(2));
        Assert.That(errors, Has.Length.EqualTo(5), string.Join(" | ", errors));
        Assert.That(errors, Has.Some.Contains(":4: sync-port: occurs twice, first at"));
    }

    [Test]
    public async Task Entries_AlsoGivenOnTheCommandLine_AreOverridden()
    {
        var (status, output, errors) = await CheckAsync("ws-port: 0\nsync-port: 0\ncell: from the file\nbind: 127.0.0.2\n", "--bind", "localhost");

        Assert.That(status, Is.EqualTo(0), string.Join(" | ", errors));
        Assert.That(output, Does.Contain("sync 127.0.0.1:0"));
    }

    [TestCase("")]
    [TestCase("# nothing but comments\n")]
    [TestCase("---\n...\n")]
    public async Task File_Empty_KeepsTheDefaults(string text)
    {
        var (status, output, errors) = await CheckAsync(text, "--ws-port", "0", "--sync-port", "0");

        Assert.That(status, Is.EqualTo(0), string.Join(" | ", errors));
        Assert.That(output[^1], Is.EqualTo("state checked"));
    }

    [Test]
    public async Task Paths_Relative_AreRelativeToTheFolderOfTheFile()
    {
        Save("observer a-token-of-an-observer\n", "tokens.txt");

        var (status, output, errors) = await CheckAsync("ws-port: 0\nsync-port: 0\ntokens: tokens.txt\nrecordings: films\n");

        Assert.That(status, Is.EqualTo(0), string.Join(" | ", errors));
        Assert.That(output, Does.Contain($"tokens {Path.Combine(_folder, "tokens.txt")}"));
        Assert.That(string.Join('\n', output), Does.Not.Contain("a-token-of-an-observer"));
    }

    [Test]
    public async Task Robot_RelativePath_IsRelativeToTheFolderOfTheFile()
    {
        File.Copy(Path.Combine(AppContext.BaseDirectory, "Robots", "ur5.urdf"), Path.Combine(_folder, "press.xml"));

        var (status, output, errors) = await CheckAsync("ws-port: 0\nsync-port: 0\nrobot: press.xml\n");

        Assert.That(status, Is.EqualTo(0), string.Join(" | ", errors));
        Assert.That(output, Does.Contain($"robot {Path.Combine(_folder, "press.xml")}"));
    }

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
    public async Task Check_PortsInUse_ReportsThemAndSucceeds()
    {
        await using var other = await Gateways.StartAsync();
        var (sync, webSocket) = (other.SyncEndPoint.Port, other.WebSocketEndPoint.Port);
        var text = $"ws-port: {webSocket}\nsync-port: {sync}\n";

        var (status, output, errors) = await CheckAsync(text);

        Assert.That(status, Is.EqualTo(0), string.Join(" | ", errors));
        Assert.That(output, Does.Contain($"sync 127.0.0.1:{sync} (port {sync} is in use)"));
        Assert.That(output, Does.Contain($"websocket ws://127.0.0.1:{webSocket}/ (port {webSocket} is in use)"));
        var started = await RunAsync(text, false);
        Assert.That(started.Status, Is.EqualTo(1));
        Assert.That(started.Errors.Single(), Does.Contain("gateway.yaml:2: sync-port "));
    }

    // A service manager can repeat a start until the address exists, but a check must report that it is missing.
    [Test]
    public async Task Bind_AddressOfAnotherMachine_IsReportedInsteadOfThePorts()
    {
        foreach (var isCheck in new[] { true, false })
        {
            var (status, _, errors) = await RunAsync("ws-port: 0\nsync-port: 0\ninsecure-lan: true\nbind: 192.0.2.1\n", isCheck);

            Assert.That(status, Is.EqualTo(isCheck ? 2 : 1));
            Assert.That(errors.Single(), Does.Contain("gateway.yaml:4: bind 192.0.2.1: not an address of this machine"));
        }
    }

    [TestCase("{sync-port: 47999, ws-port: 47999}", "ws-port 47999")]
    [TestCase("sync-port: 47011", "sync-port 47011")]
    [TestCase("ws-port: 47010", "ws-port 47010")]
    public async Task Ports_Equal_AreReportedByCheckAndStart(string entry, string part)
    {
        foreach (var isCheck in new[] { true, false })
        {
            var (status, _, errors) = await RunAsync("# comment\n\n" + entry + "\n", isCheck);

            Assert.That(status, Is.EqualTo(2));
            Assert.That(errors.Single(), Does.Contain("gateway.yaml:3: " + part + ": --sync-port and --ws-port are the same"));
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
        Assert.That(errors.Single(), Does.Contain("gateway.yaml:3: recordings /proc: this user cannot write"));
    }

    [TestCase("robot: yubot", "robot: ", "yubot: file not found; youbot, ur5, ur3e, ur5e, ur10e, ur16e or the path")]
    [TestCase("robot: models/press.xml", "robot: ", "models/press.xml: file not found")]
    [TestCase("certificate: .", "certificate", "")]
    [TestCase("pairing: .", "pairing", "")]
    [TestCase("certificate: /proc/gateway.pem", "certificate", "")]
    [TestCase("pairing: /proc/headsets.txt", "pairing", "")]
    [TestCase("tokens: none.txt", "tokens: ", "none.txt: cannot be read")]
    [TestCase("bind: any", "bind 0.0.0.0: unencrypted connections")]
    [TestCase("record: true", "record: needs the option --recordings")]
    [TestCase("robot: none.urdf", "robot: ", "none.urdf: file not found")]
    [TestCase("certificate-key: a.pem", "certificate-key: needs --certificate")]
    [TestCase("plants: [none.yaml]", "plants: ", "none.yaml: file not found")]
    public async Task Entry_Unusable_IsReportedWithItsLineNumberByCheckAndStart(string entry, string part, string more = "")
    {
        foreach (var isCheck in new[] { true, false })
        {
            var (status, _, errors) = await RunAsync("# comment\n\n" + entry + "\n", isCheck, "--ws-port", "0", "--sync-port", "0");

            Assert.That(status, Is.EqualTo(2));
            Assert.That(errors.Single(), Does.Contain("gateway.yaml:3: " + part).And.Contain(more));
        }
    }

    [Test]
    public async Task Entry_OverriddenOnTheCommandLine_IsNotReported()
    {
        var (_, _, errors) = await CheckAsync("ws-port: 0\nsync-port: 0\ntokens: good.txt\n", "--tokens", Path.Combine(_folder, "none.txt"));

        Assert.That(errors.Single(), Does.Not.Contain("gateway.yaml").And.Contain("none.txt: cannot be read"));
    }

    [Test]
    public async Task Example_AsShipped_IsValid()
    {
        var example = File.ReadAllText(Path.Combine(RepositoryFiles.Root, "Gateway", "Packaging", "gateway.yaml"));

        var (status, _, errors) = await CheckAsync(example, "--ws-port", "0", "--sync-port", "0");

        Assert.That(status, Is.EqualTo(0), string.Join(" | ", errors));
    }

    [Test]
    public async Task Example_AllEntriesEnabled_ReportsOnlyMissingFiles()
    {
        var example = File.ReadAllText(Path.Combine(RepositoryFiles.Root, "Gateway", "Packaging", "gateway.yaml"));
        var keys = example.Split('\n').Select(line => line.StartsWith("#   - ", StringComparison.Ordinal) || IsKey(line) ? line[2..] : line);

        var (_, _, errors) = await CheckAsync(string.Join('\n', keys), "--ws-port", "0", "--sync-port", "0");

        foreach (var error in errors) Assert.That(error, Does.Match(@"(tokens\.txt|stationary-objects\.json): cannot be read").Or.Contain("press.yaml: file not found"));
    }

    // Returns whether a line is a commented-out entry, "# key: value".
    static bool IsKey(string line) => System.Text.RegularExpressions.Regex.IsMatch(line, "^# [a-z-]+:( |$)");

    [Test]
    public void Parse_DeeplyNestedText_IsRefusedQuickly()
    {
        foreach (var text in new[] { new string('[', 60_000), string.Concat(Enumerable.Repeat("a: {", 15_000)), string.Concat(Enumerable.Repeat("? ", 30_000)) })
        {
            var wrong = new List<string>();
            ConfigurationFile.Parse(text, "x.yaml", wrong);
            Assert.That(wrong, Is.Not.Empty);
        }
    }

    [TestCase("ws-prot", "ws-port")]
    [TestCase("sync_port", "sync-port")]
    [TestCase("colour", null)]
    [TestCase("", null)]
    public void Nearest_MisspeltWord_ReturnsTheIntendedWord(string word, string expected) =>
        Assert.That(Nearest.Of(word, ["bind", "sync-port", "ws-port", "cell"]), Is.EqualTo(expected));
}
