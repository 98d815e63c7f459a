using System;
using Nowpose.Prediction;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Prediction
{
    public class PredictionLimitsTests
    {
        [Test]
        public void Constructor_NoArguments_UsesTheDefaults()
        {
            var limits = new PredictionLimits();

            Assert.That(limits.HorizonCap, Is.EqualTo(0.3));
            Assert.That(limits.MaximumGap, Is.EqualTo(0.5));
            Assert.That(limits.Lower, Is.EqualTo(double.NegativeInfinity));
            Assert.That(limits.Upper, Is.EqualTo(double.PositiveInfinity));
        }

        [TestCase(1, 0, 0.3, 0.5)]
        [TestCase(double.NaN, 1, 0.3, 0.5)]
        [TestCase(0, double.NaN, 0.3, 0.5)]
        [TestCase(double.PositiveInfinity, double.PositiveInfinity, 0.3, 0.5)]
        [TestCase(0, 1, -0.1, 0.5)]
        [TestCase(0, 1, double.NaN, 0.5)]
        [TestCase(0, 1, 0.3, 0)]
        [TestCase(0, 1, 0.3, double.NaN)]
        public void Constructor_InvalidLimits_Throws(double lower, double upper, double cap, double gap)
        {
            Assert.That(() => new PredictionLimits(lower, upper, cap, gap), Throws.InstanceOf<ArgumentException>());
        }

        [TestCase(-1, double.PositiveInfinity)]
        [TestCase(double.NegativeInfinity, 1)]
        [TestCase(-1, 1)]
        public void Constructor_ContinuousJointWithALimit_Throws(double lower, double upper) =>
            Assert.That(() => new PredictionLimits(lower, upper, isEndless: true), Throws.InstanceOf<ArgumentException>());
    }
}
