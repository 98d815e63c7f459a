using Nowpose.Gateway;
using Nowpose.Gateway.Pairing;
using Nowpose.Gateway.Security;
using Nowpose.Headless.Tests.Gateway.Faults;
using Nowpose.Latency;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Upgrade;

/// <summary>Tests this version with files that the gateway, <c>calibrate vlc</c> and the headset runtime of version 0.1.0 wrote.</summary>
public class UpgradeTests
{
    // Values from the output of gateway 0.1.0 with this certificate, and the token that it gave to the headset in the list.
    const string Pin = "sha256/KYsY3W9/oD/uxQHs+oel3oavjwI4EKYns9CeLWLIJqw=";
    const string PairedToken = "4NK6J5gS0zNgp01WA4sKxeT7fuT3IH9pJHSQoNjIL4E";

    string _folder;

    [SetUp]
    public void SetUp()
    {
        _folder = Directory.CreateTempSubdirectory("nowpose-upgrade-").FullName;
        foreach (var file in Directory.GetFiles(Path.Combine(RepositoryFiles.Root, "Tests", "Upgrade", "Files")))
        {
            File.Copy(file, At(Path.GetFileName(file)));
            if (!OperatingSystem.IsWindows()) File.SetUnixFileMode(At(Path.GetFileName(file)), UnixFileMode.UserRead | UnixFileMode.UserWrite);
        }
        Directory.CreateDirectory(At("recordings"));
    }

    [TearDown]
    public void TearDown() => Directory.Delete(_folder, true);

    string At(string name) => Path.Combine(_folder, name);

    Task<GatewayServer> StartAsync() => Gateways.StartAsync(Gateways.Options() with
    {
        CertificateFile = new CertificateFile(At("gateway.pem"), null, null),
        Tokens = TokenList.Read(At("tokens.txt")),
        Headsets = new HeadsetList(At("headsets.txt")),
    });

    [Test]
    public async Task Configuration_FromVersion0Point1_IsValid()
    {
        var (status, _, errors) = await CapturedConsole.OfAsync(() => Nowpose.Gateway.CommandLine.RunAsync(
            ["serve", "--config", At("gateway.yaml"), "--sync-port", "0", "--ws-port", "0", "--check"]).Bounded());

        Assert.That(status, Is.Zero, errors);
    }

    [Test]
    public async Task Certificate_FromVersion0Point1_HasTheSamePin()
    {
        await using var gateway = await StartAsync();

        Assert.That(gateway.Pin, Is.EqualTo(CertificatePin.Parse(Pin)));
    }

    [TestCase(PairedToken)]
    [TestCase("watch-0123456789abcdef")]
    public async Task Headset_PinAndTokenFromVersion0Point1_ConnectsToBothPorts(string token)
    {
        await using var gateway = await StartAsync();
        using var headset = new FaultHeadset(gateway.SyncEndPoint.Port, gateway.WebSocketEndPoint.Port, CertificatePin.Parse(Pin), token);

        // The connection for positions counts as connected after its first message, which is the version of the gateway.
        await headset.BecomesAsync(() => headset.IsConnected, "both connections are open");
    }

    [TestCase("watch-0123456789abcdef", Role.Observer)]
    [TestCase("plant-0123456789abcdef", Role.Source)]
    [TestCase("hall-0123456789abcdef", Role.Operator)]
    [TestCase("another", null)]
    public void Tokens_FromVersion0Point1_HaveTheSameRoles(string token, Role? role) =>
        Assert.That(TokenList.Read(At("tokens.txt")).RoleOf(TokenList.HashOf(token)), Is.EqualTo(role));

    [Test]
    public void Profile_FromVersion0Point1_HasTheSameValues()
    {
        var profile = LatencyProfileFile.Load(At("profile.json"));

        Assert.That(profile.Visualisation.Length.TotalMilliseconds, Is.EqualTo(40.3412).Within(1e-4));
        Assert.That((profile.Device, profile.Measurements), Is.EqualTo(("simulated headset", 40)));
    }

    [TestCase("gateway.jsonl.gz")]
    [TestCase("headset.jsonl.gz")]
    public async Task Recording_FromVersion0Point1_CanBeReplayed(string file)
    {
        var run = await CliRun.OfAsync("replay", At(file), "--json");

        Assert.That(run.ExitStatus, Is.Zero, run.Errors);
        Assert.That(run.Output, Does.Contain("\"arm_joint_1\"").And.Contain("reduction"));
    }

    [Test]
    public async Task Sync_RecordingFromVersion0Point1_EvaluatesTheExchanges()
    {
        var run = await CliRun.OfAsync("sync", At("headset.jsonl.gz"));

        Assert.That(run.ExitStatus, Is.Zero, run.Errors);
        Assert.That(run.Lines[^1], Does.Contain(",coarse,"), "the output has the form of version 0.1.0");
    }
}
