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

    // The numbers of the README: the paper's predictor learns nothing from earlier cycles.
    [TestCase("wifi", 78)]
    [TestCase("wifi", 101)]
    public void Reduction_PapersPredictor_IsThatOfEachCycle(string network, int seed)
    {
        var tool = new DemoScore(VirtualStage.Play(VirtualDemo.Settings(60, network, seed, "quadratic"), hasScene: false)).Result().ToolErrorMm;

        var message = FormattableString.Invariant(
            $"{tool.HoldRms:0.0} to {tool.Rms:0.0} mm, {tool.Reduction:P1}, {tool.ReductionFirstCycle:P1}, {tool.ReductionRepeated:P1}, seed {seed}");
        TestContext.Out.WriteLine(message);
        Assert.That(tool.Reduction, Is.InRange(0.87, 0.93), message);
        Assert.That(tool.ReductionRepeated, Is.EqualTo(tool.ReductionFirstCycle).Within(0.03), message);
    }
}
