using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Disturbances;

/// <summary>Disturbs a gateway at random in virtual time, and checks what it publishes, counts, records and shows.</summary>
public class GatewayDisturbanceTests
{
    [Test]
    public void Run_RandomDisturbances_KeepsTheRulesOfTheManual([Values(11, 25, 31, 55)] int seed) =>
        Assert.That(DisturbedGatewayRun.Run(seed), Is.Empty);
}
