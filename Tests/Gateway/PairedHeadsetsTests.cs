using System.Net;
using Nowpose.Gateway.Messages;
using Nowpose.Messages;
using NUnit.Framework;
using static Nowpose.Headless.Tests.Gateway.RosbridgeAnswer;

namespace Nowpose.Headless.Tests.Gateway;

/// <summary>Tests the gateway's list of paired headsets.</summary>
public sealed class PairedHeadsetsTests
{
    [Test]
    public async Task List_GatewayRestarted_ContainsOnlyHashesAndStillAcceptsTheToken()
    {
        await using var gateway = await PairingGateway.StartAsync();
        var own = (await gateway.ExchangeAsync((await gateway.ShownAsync()).Token, "Anna's\n \u0007headset")).Token;

        await gateway.RestartAsync();

        Assert.That(await RosbridgeStatusAsync(gateway, own), Is.EqualTo(HttpStatusCode.SwitchingProtocols));
        var list = File.ReadAllText(gateway.ListPath);
        Assert.That(list, Does.Not.Contain(own));
        Assert.That(list.Split('\n')[1], Does.Match("^observer sha256/[A-Za-z0-9+/]{43}= 2026-11-20T12:00:00Z Anna's headset$"));
        if (!OperatingSystem.IsWindows())
            Assert.That(File.GetUnixFileMode(gateway.ListPath), Is.EqualTo(UnixFileMode.UserRead | UnixFileMode.UserWrite));
    }

    [Test]
    public async Task List_LineRemoved_RevokesTheToken()
    {
        await using var gateway = await PairingGateway.StartAsync();
        var first = (await gateway.ExchangeAsync((await gateway.ShownAsync()).Token, "first")).Token;
        var second = (await gateway.ExchangeAsync((await gateway.ShownAsync()).Token, "second")).Token;

        File.WriteAllLines(gateway.ListPath, File.ReadAllLines(gateway.ListPath).Where(line => !line.EndsWith(" first", StringComparison.Ordinal)));

        Assert.That(await RosbridgeStatusAsync(gateway, first), Is.EqualTo(HttpStatusCode.Unauthorized));
        Assert.That(await RosbridgeStatusAsync(gateway, second), Is.EqualTo(HttpStatusCode.SwitchingProtocols));
    }

    [Test]
    public async Task Pairings_Revoke_RemovesOnlyTheHeadsetWithThatName()
    {
        await using var gateway = await PairingGateway.StartAsync();
        var first = (await gateway.ExchangeAsync((await gateway.ShownAsync()).Token, "Anna's headset")).Token;
        var second = (await gateway.ExchangeAsync((await gateway.ShownAsync()).Token, "second")).Token;

        var status = await Nowpose.Gateway.CommandLine.RunAsync(["pairings", "--pairing", gateway.ListPath, "--revoke", "Anna's headset"]).Bounded();

        Assert.That(status, Is.EqualTo(0));
        Assert.That(await RosbridgeStatusAsync(gateway, first), Is.EqualTo(HttpStatusCode.Unauthorized));
        Assert.That(await RosbridgeStatusAsync(gateway, second), Is.EqualTo(HttpStatusCode.SwitchingProtocols));
    }

    [Test]
    public async Task List_DamagedWhileRunning_IsLoggedOnceAndThePreviousListIsUsed()
    {
        await using var gateway = await PairingGateway.StartAsync();
        var own = (await gateway.ExchangeAsync((await gateway.ShownAsync()).Token)).Token;

        File.AppendAllText(gateway.ListPath, "something else\n");

        Assert.That(await RosbridgeStatusAsync(gateway, own), Is.EqualTo(HttpStatusCode.SwitchingProtocols));
        Assert.That(await RosbridgeStatusAsync(gateway, own), Is.EqualTo(HttpStatusCode.SwitchingProtocols));
        var fault = HeadsetListMessages.NotAnEntry(gateway.ListPath, 3);
        Assert.That(gateway.Log.Count(line => line.StartsWith(fault, StringComparison.Ordinal)), Is.EqualTo(1));
    }

    [TestCase(false)]
    [TestCase(true)]
    public async Task List_UnreadableWhileRunning_IsLoggedAndThePreviousListIsUsed(bool isFolder)
    {
        await using var gateway = await PairingGateway.StartAsync();
        var own = (await gateway.ExchangeAsync((await gateway.ShownAsync()).Token)).Token;
        await RosbridgeStatusAsync(gateway, own);

        File.Delete(gateway.ListPath);
        if (isFolder) Directory.CreateDirectory(gateway.ListPath);

        Assert.That(await RosbridgeStatusAsync(gateway, own), Is.EqualTo(HttpStatusCode.SwitchingProtocols));
        // The gateway may have read the list before the folder was created, which is another reason.
        Assert.That(gateway.Log.Where(line => line.StartsWith(gateway.ListPath, StringComparison.Ordinal)), Is.Not.Empty.And.Unique);
    }

    [Test]
    public async Task Exchange_ListCannotBeWritten_FailsAndTheCodeStaysValid()
    {
        await using var gateway = await PairingGateway.StartAsync();
        var code = await gateway.ShownAsync();
        File.Delete(gateway.ListPath);
        Directory.CreateDirectory(gateway.ListPath);

        var failed = await gateway.ExchangeAsync(code.Token);
        Directory.Delete(gateway.ListPath);
        // A new file would contain this headset alone, and all others would lose their access.
        var missing = await gateway.ExchangeAsync(code.Token);
        await File.WriteAllTextAsync(gateway.ListPath, "");
        var worked = await gateway.ExchangeAsync(code.Token);

        Assert.That((failed.Problem, missing.Problem), Is.EqualTo((PairingAnswerMessages.NotSaved, PairingAnswerMessages.NotSaved)));
        Assert.That(failed.IsWorthRetrying, Is.True);
        Assert.That(worked.Token, Is.Not.Null);
    }
}
