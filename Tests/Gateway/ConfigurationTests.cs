using System.Net;
using Nowpose.Gateway.Configuration;
using Nowpose.Gateway.Messages;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway;

/// <summary>Tests the configuration file and --check through the command line.</summary>
public class ConfigurationTests : ConfigurationFixture
{
    const string Place = "gateway.yaml:3";

    static readonly string[][] InvalidEntries =
    [
        ["bind: nowhere", $"{Place}: bind: 'nowhere'"],
        ["sync-port: 70000", $"{Place}: sync-port: 70000"],
        ["sync-port: many", "'many'"],
        ["ws-prot: 1", "'ws-port'"],
        ["colour: red", "bind, cell"],
        ["tls: yes", ConfigurationMessages.NotASwitch("yes")],
        ["cell: [a, b]", ConfigurationMessages.List],
        ["tokens:", "has no value"],
        ["ws-port: {a: b}", ConfigurationMessages.ValueNotAWord(Place, "ws-port")],
        ["plants: [[a]]", ConfigurationMessages.ValueNotAWord(Place, "plants")],
        ["cell: *anchor", ConfigurationMessages.ValueNotAWord(Place, "cell")],
        ["check: true", ConfigurationMessages.UnknownEntry("serve", "")],
        ["config: other.yaml", ConfigurationMessages.UnknownEntry("serve", "")],
        ["? [a]\n: b", ConfigurationMessages.KeyNotAWord(Place)],
        ["clock: UPPER", "'UPPER'"],
        ["\"a", ": not valid YAML"],
        ["plants: []", "has no value"],
        ["ws-port: []", ConfigurationMessages.List],
        ["tokens: \"a\\0b\"", ConfigurationMessages.ControlCharacter],
        ["recordings: \"a\\0b\"", ConfigurationMessages.ControlCharacter],
        ["cell: !secret foo", ConfigurationMessages.ValueNotAWord(Place, "cell")],
        ["cell: &name foo", ConfigurationMessages.ValueNotAWord(Place, "cell")],
        ["plants: [!file a.yaml]", ConfigurationMessages.ValueNotAWord(Place, "plants")],
        ["plants: !files [a.yaml]", ConfigurationMessages.ValueNotAWord(Place, "plants")],
        ["!secret cell: foo", ConfigurationMessages.KeyNotAWord(Place)],
        ["!all {cell: foo}", ConfigurationMessages.NoEntry(Place)],
        ["[a, b]", ConfigurationMessages.NoEntry(Place)],
        ["word", ConfigurationMessages.NoEntry(Place)],
    ];

    [TestCaseSource(nameof(InvalidEntries))]
    public async Task Entry_Invalid_IsReportedInOneLineWithFileLineNumberAndKey(string entry, string part)
    {
        foreach (var isCheck in new[] { true, false })
        {
            var (status, _, errors) = await RunAsync("# comment\n\n" + entry + "\n", isCheck, "--ws-port", "0", "--sync-port", "0");

            Assert.That(status, Is.EqualTo(2));
            Assert.That(errors, Has.Length.EqualTo(1), string.Join(" | ", errors));
            Assert.That(errors[0], Does.Contain("gateway.yaml:").And.Contain(part));
            if (!part.Contains("YAML")) Assert.That(errors[0], Does.Contain(Place + ": "));
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
        Assert.That(errors, Has.Some.Match(MessagePattern.Of(ConfigurationMessages.KeyTwice(":4", "sync-port", MessagePattern.Any))));
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

    // A service manager can repeat a start until the address exists, but a check must report that it is missing.
    [Test]
    public async Task Bind_AddressOfAnotherMachine_IsReportedInsteadOfThePorts()
    {
        foreach (var isCheck in new[] { true, false })
        {
            var (status, _, errors) = await RunAsync("ws-port: 0\nsync-port: 0\ninsecure-lan: true\nbind: 192.0.2.1\n", isCheck);

            Assert.That(status, Is.EqualTo(isCheck ? 2 : 1));
            Assert.That(errors.Single(), Does.Match(MessagePattern.Of(
                "gateway.yaml:4: " + AddressOptionMessages.NotThisMachine(IPAddress.Parse("192.0.2.1"), MessagePattern.Any)["--".Length..])));
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
        // The folder of an installed gateway does not exist here.
        var keys = example.Replace("/var/lib/nowpose-gateway", ".").Split('\n').Select(line => line.StartsWith("#   - ", StringComparison.Ordinal) || IsKey(line) ? line[2..] : line);

        var (_, _, errors) = await CheckAsync(string.Join('\n', keys), "--ws-port", "0", "--sync-port", "0");

        Assert.That(errors, Is.Not.Empty.And.All.Match(@"(tokens\.txt|stationary-objects\.json): cannot be read")
            .Or.Contain(PathMessages.NotFound("press.yaml", "")));
    }

    // Returns whether a line is a commented-out entry, "# key: value".
    static bool IsKey(string line) => System.Text.RegularExpressions.Regex.IsMatch(line, "^# [a-z-]+:( |$)");

    [Test]
    public void Parse_DeeplyNestedText_IsRefusedQuickly()
    {
        foreach (var text in new[] { new string('[', 20_000), string.Concat(Enumerable.Repeat("a: {", 5_000)), string.Concat(Enumerable.Repeat("? ", 10_000)) })
        {
            var wrong = new InvalidEntries();
            ConfigurationFile.Parse(text, "x.yaml", wrong);
            Assert.That(wrong.Lines, Is.Not.Empty);
        }
    }

    [TestCase("ws-prot", "ws-port")]
    [TestCase("sync_port", "sync-port")]
    [TestCase("colour", null)]
    [TestCase("", null)]
    public void Nearest_MisspeltWord_ReturnsTheIntendedWord(string word, string expected) =>
        Assert.That(Nearest.Of(word, ["bind", "sync-port", "ws-port", "cell"]), Is.EqualTo(expected));
}
