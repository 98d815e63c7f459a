using Nowpose.Gateway.Plants;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway;

/// <summary>Tests what the gateway does with a robot description that is invalid or too long.</summary>
public class RobotDescriptionTests
{
    const string Valid = "<robot name='a'><link name='base'/></robot>";

    static string Text(string urdf) => RosbridgeWriter.Publish(RosTopics.RobotDescription, new StringMessage(urdf));

    [TestCase("not xml")]
    [TestCase("")]
    public async Task Publish_FirstDescriptionIsInvalid_IsForwardedWithAWarningToItsSender(string invalid)
    {
        await using var gateway = await Gateways.StartAsync();
        using var source = await RawRosbridgeClient.ConnectAsync(gateway);
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);
        await client.SubscribeAsync(RosTopics.RobotDescription);

        await source.SendAsync(Text(invalid));

        var status = await source.ReceiveAsync();
        Assert.That((status.Op, status.Level), Is.EqualTo((RosbridgeOp.Status, "warning")));
        Assert.That(status.Text, Does.StartWith("publish /robot_description ").And.Contain("/robot_description:1"));
        Assert.That((await client.ReceiveAsync()).Data, Is.EqualTo(invalid));
        Assert.That(gateway.Drops.Total, Is.Zero);
    }

    [TestCase("not xml")]
    [TestCase("")]
    public async Task Publish_InvalidAfterAValidDescription_IsDroppedAndTheValidOneStays(string invalid)
    {
        await using var gateway = await Gateways.StartAsync();
        using (var former = await RawRosbridgeClient.ConnectAsync(gateway))
        {
            await former.SendAsync(Text(Valid));
            await former.RoundTripAsync();
        }

        await Soon.BecomesAsync(() => gateway.WebSocketConnections.Open == 0, "the former source has ended");
        using var source = await RawRosbridgeClient.ConnectAsync(gateway);
        await source.SendAsync(Text(invalid));
        await source.ExpectErrorAsync(nameof(DropReason.NotUrdf));

        using var client = await RawRosbridgeClient.ConnectAsync(gateway);
        await client.SendAsync("""{"op":"subscribe","topic":"/robot_description"}""");
        Assert.That((await client.ReceiveAsync()).Data, Is.EqualTo(Valid));
        Assert.That(gateway.Hub.DescriptionOf(""), Is.EqualTo(Valid));
    }

    [Test]
    public async Task Publish_InvalidWhileAnotherSourceIsConnected_IsRefusedBecauseOfThatSource()
    {
        await using var gateway = await Gateways.StartAsync();
        using var former = await RawRosbridgeClient.ConnectAsync(gateway);
        await former.SendAsync(Text(Valid));
        await former.RoundTripAsync();
        using var source = await RawRosbridgeClient.ConnectAsync(gateway);

        await source.SendAsync(Text("not xml"));

        await source.ExpectErrorAsync(nameof(DropReason.JointTaken));
    }

    [Test]
    public async Task Publish_RefusedNameAfterAnInvalidDescription_HasNoWarningAboutTheDescription()
    {
        await using var gateway = await Gateways.StartAsync();
        using var owner = await RawRosbridgeClient.ConnectAsync(gateway);
        using var source = await RawRosbridgeClient.ConnectAsync(gateway);
        await owner.SendAsync(Diagnostics("goggles"));
        await owner.RoundTripAsync();
        await source.SendAsync(Text("not xml"));
        Assert.That((await source.ReceiveAsync()).Level, Is.EqualTo("warning"));

        await source.SendAsync(Diagnostics("goggles"));

        await source.ExpectErrorAsync(nameof(DropReason.JointTaken));
        await source.RoundTripAsync();
    }

    [Test]
    public async Task Publish_ValidAfterAnotherDescription_ReplacesIt()
    {
        await using var gateway = await Gateways.StartAsync();
        using var source = await RawRosbridgeClient.ConnectAsync(gateway);
        var other = RobotFiles.LoadText("youbot");

        await source.SendAsync(Text(Valid));
        await source.SendAsync(Text(other));

        await source.RoundTripAsync();
        Assert.That(gateway.Hub.DescriptionOf(""), Is.EqualTo(other));
    }

    // The gateway writes such a character with six bytes instead of three.
    [Test]
    public async Task Publish_LongerThanTheLimitAsTheGatewayWritesIt_IsDropped()
    {
        await using var gateway = await Gateways.StartAsync();
        using var source = await RawRosbridgeClient.ConnectAsync(gateway);

        var name = new string('\u2028', 300_000);

        await source.SendAsync("{\"op\":\"publish\",\"topic\":\"/robot_description\",\"msg\":{\"data\":\"<robot name='" + name + "'><link name='base'/></robot>\"}}");

        await source.ExpectErrorAsync(nameof(DropReason.TooLarge));
        Assert.That(gateway.Hub.DescriptionOf(""), Is.Null);
    }

    static string Diagnostics(string hardwareId) => RosbridgeWriter.Publish(
        RosTopics.Diagnostics, new DiagnosticsMessage(Gateways.Start, hardwareId, [KeyValuePair.Create("state", "connected")]), RosTimeForm.Sec);
}
