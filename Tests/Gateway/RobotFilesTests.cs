using Nowpose.Gateway.Plants;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway;

/// <summary>Tests which robot files the commands accept.</summary>
public class RobotFilesTests
{
    // Each quotation mark has two bytes in a message.
    [Test]
    public void Load_LongerThanADescriptionInAMessage_IsRefusedOnlyIfItIsSentToHeadsets()
    {
        using var folder = new TemporaryFolder();
        var path = Path.Combine(folder.Path, "big.urdf");
        File.WriteAllText(path, "<robot name='a'><link name='base'/><!--" + new string('"', ProtocolLimits.DescriptionBytes * 3 / 5) + "--></robot>");

        var refused = Assert.Throws<InputException>(() => RobotFiles.Load(path, out _));

        Assert.That(refused.Message, Does.StartWith(path).And.Contain($"{ProtocolLimits.DescriptionBytes} bytes"));
        Assert.That(RobotFiles.Load(path).Links, Has.Count.EqualTo(1));
    }

    [TestCase("serve")]
    [TestCase("simulate")]
    public async Task Check_RobotLongerThanADescriptionInAMessage_IsRefused(string command)
    {
        using var folder = new TemporaryFolder();
        var path = Path.Combine(folder.Path, "big.urdf");
        File.WriteAllText(path, "<robot name='a'><link name='base'/><!--" + new string(' ', ProtocolLimits.DescriptionBytes) + "--></robot>");

        var (status, _, errors) = await CapturedConsole.OfAsync(
            () => Nowpose.Gateway.CommandLine.RunAsync([command, "--check", "--robot", path, "--ws-port", "0", "--sync-port", "0"]).Bounded());

        Assert.That(status, Is.EqualTo(2));
        Assert.That(errors, Does.Contain(path).And.Contain($"{ProtocolLimits.DescriptionBytes} bytes"));
    }
}
