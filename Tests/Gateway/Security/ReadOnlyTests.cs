using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Security;

public class ReadOnlyTests
{
    [Test]
    public async Task Source_WithoutSubscriptions_ReceivesNoMessagesFromOtherClients()
    {
        await using var gateway = await Gateways.StartAsync();
        using var plant = await RawRosbridgeClient.ConnectAsync(gateway);
        using var other = await RawRosbridgeClient.ConnectAsync(gateway);
        await plant.SendAsync(Gateways.StateText(1));
        await plant.RoundTripAsync();

        foreach (var attempt in new[]
            {
                Gateways.StateText(2, "b"),
                Gateways.StateText(2, "a"),
                """{"op":"publish","topic":"/cmd_vel","msg":{"linear":{"x":1}}}""",
                """{"op":"publish","topic":"/joint_trajectory_controller/command","msg":{}}""",
                RosbridgeWriter.CallService("/set_pose", "1"),
                RosbridgeWriter.CallService("/nowpose/plant_time/cell", "2"),
                """{"op":"service_response","service":"/x","id":"3","result":true,"values":{}}""",
            })
            await other.SendAsync(attempt);
        // The gateway responds in order, so when the response to this call arrives, it has handled all attempts.
        while ((await AskAsync(other)).Id != "done")
        {
        }

        await plant.RoundTripAsync(); // the plant must receive the response to this call first
    }

    static async Task<RosbridgeMessage> AskAsync(RawRosbridgeClient client)
    {
        await client.SendAsync(RosbridgeWriter.CallService(RosTopics.GetTime, "done"));
        return await client.ReceiveAsync();
    }
}
