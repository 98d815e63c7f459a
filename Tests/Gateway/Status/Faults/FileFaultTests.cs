using Nowpose.Gateway;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Pairing;
using Nowpose.Gateway.Security;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Status.Faults;

/// <summary>Tests how the gateway reports files of tokens, headsets and certificate that become invalid while it runs.</summary>
public class FileFaultTests
{
    const string Tokens = "observer first-token-of-this-test\n";

    string _folder;
    int _writes;

    [SetUp]
    public void SetUp() => _folder = Directory.CreateTempSubdirectory("nowpose-files").FullName;

    [TearDown]
    public void TearDown() => Directory.Delete(_folder, true);

    // A revoked token stays valid while its file is invalid, so this must not be visible in the log only.
    [TestCase(Tokens + "source second-token-of-this-test\n", TestName = "Tokens_FileIsInvalid_AddsAnEventUntilItIsCorrected")]
    [TestCase(null, TestName = "Tokens_FileIsInvalid_AddsAnEventUntilItIsRestored")]
    public async Task Tokens_FileIsInvalid_AddsAnEvent(string corrected)
    {
        var path = Write("tokens.txt", Tokens);
        var copy = Path.Combine(_folder, "copy.txt");
        File.Copy(path, copy);
        await using var gateway = new MonitoredGateway();
        await gateway.StartAsync(options => options with { Tokens = TokenList.Read(path) });
        bool IsActive() => gateway.Server.Events.Read().Any(one => one.Condition.Kind == "file" && one.Until == null);

        Write("tokens.txt", "observr third-token-of-this-test\n");

        await Soon.BecomesAsync(IsActive, "the event begins");
        var condition = gateway.Server.Events.Read().Single().Condition;
        Assert.That((condition.Which, condition.What), Is.EqualTo(("tokens.txt", EventTexts.IsInvalid)));
        Assert.That(condition.Reason, Does.Contain(path).And.EndsWith(AccessMessages.FormerContentUsed));
        if (corrected == null) File.Move(copy, path, overwrite: true);
        else Write("tokens.txt", corrected);
        await Soon.BecomesAsync(() => !IsActive(), "the event ends");
    }

    [Test]
    public void Headsets_LineIsInvalid_IsAFaultOfTheirFile()
    {
        var path = Write("headsets.txt", "# headsets\n");
        var options = new GatewayOptions { Headsets = new HeadsetList(path) };
        Assert.That(options.FileFaults, Is.Empty);

        Write("headsets.txt", "# headsets\nno headset\n");
        options.Follow();

        Assert.That(options.FileFaults, Is.EqualTo(new[] { (path, HeadsetListMessages.NotAnEntry(path, 2) + AccessMessages.OtherLinesUsed) }));
    }

    [Test]
    public void Certificate_HasAnotherKey_IsAFaultOfItsFile()
    {
        var path = Path.Combine(_folder, "gateway.pem");
        var options = new GatewayOptions { CertificateFile = new CertificateFile(path, null, null) };
        Assert.That(options.FileFaults, Is.Empty);

        File.Delete(path);
        CertificateFiles.LoadOrGenerate(path, null).Dispose();
        MakeOlder(path);
        options.Follow();

        var (file, fault) = options.FileFaults.Single();
        Assert.That(file, Is.EqualTo(path));
        Assert.That(fault, Does.EndWith(AccessMessages.FormerContentUsed));
    }

    string Write(string name, string text)
    {
        var path = Path.Combine(_folder, name);
        File.WriteAllText(path, text);
        MakeOlder(path);
        return path;
    }

    // Gives the file another time than before that is so old that the gateway does not wait for further changes.
    void MakeOlder(string path) => File.SetLastWriteTimeUtc(path, DateTime.UtcNow.AddHours(-1).AddMinutes(_writes++));
}
