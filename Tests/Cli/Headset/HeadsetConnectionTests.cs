using Nowpose.Cli.Headset;
using Nowpose.Cli.Messages;
using Nowpose.Messages;
using Nowpose.Network;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Headset;

/// <summary>Tests that the message about an invalid value names the option instead of a setting of the runtime.</summary>
public class HeadsetConnectionTests
{
    static readonly string[][] Invalid =
    [
        ["--pin", "x", CertificateMessages.PinInvalid("x")],
        ["--name", new string('x', ProtocolLimits.NameLength + 1), ConnectionMessages.HeadsetName(ProtocolLimits.NameLength + 1, ProtocolLimits.NameLength)],
        ["--host", "a b", ConnectionMessages.NotAHost("a b")],
    ];

    [TestCaseSource(nameof(Invalid))]
    public async Task Headset_InvalidValue_NamesTheOption(string option, string value, string reason)
    {
        var run = await CliRun.OfAsync("headset", option, value);

        Assert.That(run.ExitStatus, Is.EqualTo(2));
        Assert.That(run.Errors.TrimEnd(), Is.EqualTo(ConsoleMessages.Line($"{option}: {reason}")));
    }

    static readonly string[][] InvalidTokens =
    [
        [" \n", ProtocolMessages.TokenLength(0, ProtocolLimits.TokenBytes)], ["two words", ConnectionMessages.TokenCharacter],
    ];

    [TestCaseSource(nameof(InvalidTokens))]
    public async Task Headset_InvalidToken_NamesTheOptionAndTheFile(string text, string reason)
    {
        using var file = new TemporaryFile(text, ".txt");

        var run = await CliRun.OfAsync("headset", "--token-file", file.Path);

        Assert.That(run.ExitStatus, Is.EqualTo(2));
        Assert.That(run.Errors.TrimEnd(), Is.EqualTo(ConsoleMessages.Line($"--token-file: {file.Path}: {reason}")));
    }

    const string Other = "10.0.0.1";

    static ConnectionSettings Connection(string pin = null, string tokenFile = null, bool insecureLan = false) =>
        HeadsetConnection.Of(Other, 1, 2, pin, tokenFile, insecureLan, "headless");

    [Test]
    public void Of_PlainConnectionToAnotherMachine_NamesTheOptions()
    {
        using var token = new TemporaryFile(Gateways.ObserverToken, ".txt");

        Assert.That(() => Connection(), Throws.TypeOf<InputException>().With.Message.EqualTo(HeadsetMessages.PlainNotAllowed(Other)));
        foreach (var insecureLan in new[] { false, true })
            Assert.That(
                () => Connection(tokenFile: token.Path, insecureLan: insecureLan),
                Throws.TypeOf<InputException>().With.Message.EqualTo(HeadsetMessages.TokenUnencrypted(Other)));
    }

    [Test]
    public void Of_ValidOptions_AreTheSettings()
    {
        using var token = new TemporaryFile(Gateways.ObserverToken + "\n", ".txt");
        var pin = "sha256/" + Convert.ToBase64String(new byte[32]);

        var connection = Connection(pin, token.Path);

        Assert.That((connection.Host, connection.SyncPort, connection.WebSocketPort), Is.EqualTo((Other, 1, 2)));
        Assert.That((connection.Token, connection.HeadsetName), Is.EqualTo((Gateways.ObserverToken, "headless")));
        Assert.That(connection.Pin, Is.EqualTo(CertificatePin.Parse(pin)));
        Assert.That(Connection(insecureLan: true).Pin, Is.Null);
    }
}
