using Nowpose.Network;

namespace Nowpose.Headless.Tests.Network;

/// <summary>Topics to which clients subscribe in tests.</summary>
static class Subscribed
{
    public static Subscriptions ToRobot(string robot = "")
    {
        var subscriptions = new Subscriptions();
        subscriptions.AddRobot(robot);
        return subscriptions;
    }
}
