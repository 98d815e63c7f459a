using NUnit.Framework;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Gateway;

/// <summary>What clients written for rosbridge ask it for, and say.</summary>
public class RosapiTests
{
    [TestCase("/rosapi/topics")]
    [TestCase("rosapi/topics")]
    public async Task Topics_AskedFor_AreListedWithTheirTypes(string service)
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);

        await client.SendAsync(RosbridgeWriter.CallService(service, "1"));

        var text = await client.ReceiveTextAsync();
        Assert.That(text, Does.Contain("\"" + RosTopics.JointStates + "\"").And.Contain("\"sensor_msgs/JointState\"").And.Contain("\"result\":true"));
        Assert.That(text, Does.Contain("\"service\":\"" + service + "\""), "answered by the name that was called");
    }

    [Test]
    public async Task GetTime_WithoutTheSlash_IsAnswered()
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);

        await client.SendAsync(RosbridgeWriter.CallService("rosapi/get_time", "1"));

        Assert.That((await client.ReceiveAsync()).Result, Is.True);
    }

    [TestCase("none", false)]
    [TestCase("error", true)]
    public async Task SetLevel_None_TellsNoStatusAnyMore(string level, bool isTold)
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);
        await client.SendAsync($$"""{"op":"set_level","level":"{{level}}"}""");

        await client.SendAsync("""{"op":"unheard_of"}""");

        if (isTold) await client.ExpectErrorAsync("Unknown operation");
        await client.RoundTripAsync();
    }
}
