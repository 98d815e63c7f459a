using Nowpose.Cli.Figures.Pictures;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Figures;

public class AxisTicksTests
{
    [TestCase(0, 43, new double[] { 0, 10, 20, 30, 40 })]
    [TestCase(10, 100, new double[] { 20, 40, 60, 80, 100 })]
    [TestCase(-0.5, 0.5, new[] { -0.4, -0.2, 0, 0.2, 0.4 })]
    public void Of_Range_ReturnsRoundNumbersInside(double low, double high, double[] ticks)
    {
        Assert.That(AxisTicks.Of(low, high), Is.EqualTo(ticks).Within(1e-12));
    }

    [TestCase(43, 43, 50)]
    [TestCase(40, 40, 40)]
    public void Ceiling_Value_ReturnsTheNextTickOrItself(double value, double span, double tick)
    {
        Assert.That(AxisTicks.Ceiling(value, span), Is.EqualTo(tick).Within(1e-12));
        Assert.That(AxisTicks.Floor(-value, span), Is.EqualTo(-tick).Within(1e-12));
    }

    [Test]
    public void Of_AnyRange_ReturnsFewSteps([Values(0.013, 0.7, 1, 3.99, 4, 9.99, 42, 777, 12_345)] double span)
    {
        Assert.That(AxisTicks.Of(0, span).Count(), Is.InRange(4, 11));
    }
}
