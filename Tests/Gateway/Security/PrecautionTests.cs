using System.Net;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Pairing;
using Nowpose.Gateway.Security;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Security;

public class PrecautionTests
{
    [TestCase("600", false)]
    [TestCase("640", true)]
    [TestCase("644", true)]
    public async Task TokensFile_AnyMode_CausesAWarningIfReadableByGroupOrOthers(string mode, bool expected)
    {
        if (OperatingSystem.IsWindows()) Assert.Ignore("files have no such modes on Windows");
        var path = Path.GetTempFileName();
        try
        {
            File.WriteAllText(path, "observer a\n");
            if (!OperatingSystem.IsWindows()) File.SetUnixFileMode(path, (UnixFileMode)Convert.ToInt32(mode, 8));
            await using var gateway = await Gateways.StartAsync(Gateways.Options() with { Tokens = TokenList.Read(path) });

            var warnings = gateway.Warnings.Where(line => line.Contains(path) && line.Contains("chmod")).ToArray();

            Assert.That(warnings.Length, Is.EqualTo(expected ? 1 : 0));
            if (expected) Assert.That(warnings[0], Does.Contain("mode " + mode).And.Contain("chmod 600"));
        }
        finally
        {
            File.Delete(path);
        }
    }

    [TestCase("root's, of the own group", "640", false)]
    [TestCase("root's, of the own group", "660", true)]
    [TestCase("root's, of the own group", "644", true)]
    [TestCase("root's, of another group", "640", true)]
    [TestCase("handed over", "440", false)]
    public void TokensFile_OtherOwner_CausesAWarningIfReadableBeyondTheGroup(string whose, string mode, bool expected)
    {
        if (!OperatingSystem.IsLinux() || !Environment.IsPrivilegedProcess) Assert.Ignore("only root can give files away, on Linux");
        using var folder = new TemporaryFolder();
        var path = Path.Combine(folder.Path, "tokens.txt");
        File.WriteAllText(path, "observer a\n");
        // Gives the file to another user, with the group of this process or another group.
        Run("chown", whose.EndsWith("another group") ? "65534:65534" : "65534", path);
        Run("chmod", mode, path);

        var warnings = Precautions.Of(Gateways.Options() with { Tokens = TokenList.Read(path) }, whose == "handed over" ? folder.Path : null);

        Assert.That(warnings.Count(line => line.Contains(path) && line.Contains("chmod")), Is.EqualTo(expected ? 1 : 0));
    }

    [TestCase("edge1.plant.example", 0)]
    [TestCase("192.0.2.7", 0)]
    [TestCase("edge2.plant.example", 1)]
    [TestCase("203.0.113.8", 1)]
    public void HostName_NotInTheCertificate_CausesAWarningWithTheRemedy(string name, int expected)
    {
        using var certificate = CertificateFiles.Generate(["edge1.plant.example", "192.0.2.7"]);

        var warnings = Precautions.Of(Gateways.Options() with { Certificate = certificate, HostNames = [name] }, null);

        Assert.That(warnings.Count(line => line == PrecautionMessages.NotInCertificate(name)), Is.EqualTo(expected));
    }

    static void Run(string program, params string[] arguments)
    {
        using var process = System.Diagnostics.Process.Start(program, arguments);
        process.WaitForExit();
        Assert.That(process.ExitCode, Is.Zero);
    }

    [Test]
    public async Task Start_WithoutNeedForRoot_WarnsOnlyIfRunAsRoot()
    {
        await using var gateway = await Gateways.StartAsync();

        Assert.That(gateway.Warnings.Contains(PrecautionMessages.Root), Is.EqualTo(Environment.IsPrivilegedProcess));
    }

    [TestCase(true, false, "127.0.0.1", true)]
    [TestCase(true, false, "0.0.0.0", true)]
    [TestCase(true, false, "203.0.113.8", true)]
    [TestCase(true, true, "127.0.0.1", false)]
    [TestCase(false, false, "127.0.0.1", false)]
    public void Options_PairingWithoutTokens_WarnAboutTheMissingOperator(bool pairs, bool hasTokens, string bind, bool expected)
    {
        using var folder = new TemporaryFolder();
        var options = Gateways.Options() with
        {
            Bind = IPAddress.Parse(bind),
            Headsets = pairs ? new HeadsetList(Path.Combine(folder.Path, "headsets.txt")) : null,
            Tokens = hasTokens ? Gateways.Tokens : TokenList.None,
        };

        var text = PrecautionMessages.NoOperator(isLocalhostReachable: bind != "203.0.113.8");
        Assert.That(Precautions.Of(options, null).Contains(text), Is.EqualTo(expected));
    }
}
