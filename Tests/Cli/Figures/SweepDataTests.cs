using Nowpose.Cli.Figures.Sweeps;
using Nowpose.Cli.Messages;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Figures;

public class SweepDataTests
{
    static readonly SweepData Data = new([0, 10, 20], new Dictionary<string, double[]>
    {
        ["hold"] = [10, 20, 40],
        ["a"] = [1, 2, 8],
        ["b"] = [3, 3, 3],
    });

    [Test]
    public void Ratio_Predictor_IsRelativeToHold()
    {
        Assert.That(Data.Ratio("a", 2), Is.EqualTo(0.2).Within(1e-12));
        Assert.That(Data.Growth("a", 0, 20), Is.EqualTo(8).Within(1e-12));
    }

    [Test]
    public void Best_EachValue_ReturnsTheNameWithTheSmallestError()
    {
        Assert.That(Enumerable.Range(0, 3).Select(i => Data.Best(i, "a", "b")), Is.EqualTo(new[] { "a", "a", "b" }));
    }

    [Test]
    public void Crossover_CrossingLines_Interpolates()
    {
        // The difference of the errors is −1 at the value 10 and 5 at the value 20.
        Assert.That(Data.Crossover("b", "a"), Is.EqualTo(10 + 10.0 / 6).Within(1e-12));
        Assert.That(Data.Crossover("a", "b"), Is.Null, "a is not better at the end");
        Assert.That(Data.Crossover("a", "hold"), Is.EqualTo(0), "a is better everywhere");
    }

    [Test]
    public void RmsAt_ValueNotInTheSweep_Throws()
    {
        Assert.That(() => Data.RmsAt("a", 15), Throws.ArgumentException.With.Message.StartsWith(FigureErrors.NotAValue(15)));
    }

    [TestCase(new double[0], "none")]
    [TestCase(new[] { 7.5 }, "7.5 ms")]
    [TestCase(new[] { 10.0, 20, 30 }, "10, 20 and 30 ms")]
    public void List_Values_JoinsThemWithCommasAndAnd(double[] values, string words)
    {
        Assert.That(SweepData.List(values), Is.EqualTo(words));
    }
}
