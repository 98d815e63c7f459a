using Nowpose.Editor;
using Nowpose.Editor.Inspectors;
using NUnit.Framework;

namespace Nowpose.Tests.Unity.Inspectors
{
    public class ChartRangeTests
    {
        [TestCase(0.0, 0.7, 0, 1)]
        [TestCase(0.0, 1.0, 0, 1)]
        [TestCase(12.0, 41.0, 0, 50)]
        [TestCase(12.0, 199.0, 0, 200)]
        [TestCase(0.0, 0.031, 0, 0.05)]
        [TestCase(0.0, 601.0, 0, 1000)]
        [TestCase(-3.0, 18.0, -5, 20)]
        [TestCase(-3.0, -2.0, -5, 0)]
        [TestCase(0.0, 0.0, 0, 1)]
        public void Range_AnyValues_HasRoundBoundsAndContainsZero(double a, double b, double bottom, double top)
        {
            var series = new RollingSeries(10, 10);
            series.Add(0, a);
            series.Add(1, b);

            var range = ChartRange.Of(series);

            Assert.That(range.Bottom, Is.EqualTo(bottom).Within(1e-6));
            Assert.That(range.Top, Is.EqualTo(top).Within(1e-6));
            Assert.That(range.PartOf(range.Bottom), Is.EqualTo(0));
            Assert.That(range.PartOf(range.Top), Is.EqualTo(1));
        }

        [Test]
        public void Range_UnknownValues_IsNotEmpty()
        {
            var series = new RollingSeries(10, 10);
            series.Add(0, null);

            var range = ChartRange.Of(series);

            Assert.That(range.Top, Is.GreaterThan(range.Bottom));
        }
    }
}
