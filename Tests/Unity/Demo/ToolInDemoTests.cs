using Nowpose.Cli.Demo;
using Nowpose.Cli.Demo.Virtual;
using NUnit.Framework;

namespace Nowpose.Unity.Tests.Demo;

/// <summary>Tests the error of the displayed tool in a demo of one minute in virtual time.</summary>
public class ToolInDemoTests
{
    [TestCase("wifi", 78, 0.93, 0.985)]
    [TestCase("wifi", 101, 0.93, 0.985)]
    [TestCase("busy-wifi", 78, 0.90, 0.975)]
    [TestCase("busy-wifi", 101, 0.90, 0.975)]
    public void Reduction_RepeatedCycle_IsGreaterThanInTheFirstCycle(string network, int seed, double minFirst, double minRepeated)
    {
        var tool = new DemoScore(VirtualStage.Play(VirtualDemo.Settings(60, network, seed), hasScene: false)).Result().ToolErrorMm;

        Assert.That(tool.HoldRms, Is.GreaterThan(25), "without compensation, the error is large");
        Assert.That(tool.ReductionFirstCycle, Is.GreaterThan(minFirst));
        Assert.That(tool.ReductionRepeated, Is.GreaterThan(minRepeated));
    }
}
