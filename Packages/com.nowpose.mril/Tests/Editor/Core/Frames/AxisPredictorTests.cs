using Nowpose.Frames;
using Nowpose.Prediction;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Frames
{
    public class AxisPredictorTests
    {
        static AxisPredictor New(bool waitsForChange = true) =>
            new AxisPredictor(Predictors.Create("linear", PredictionLimits.Unlimited), waitsForChange);

        [Test]
        public void At_ConstantValue_IsThatValue()
        {
            var axis = New();
            for (var k = 0; k < 20; k++) axis.Add(new JointSample(0.05 * k, 0.7 + 1e-12 * k), 0.05 * k);

            Assert.That(axis.At(3), Is.EqualTo(0.7));
            Assert.That(axis.Hold, Is.EqualTo(0.7));
        }

        [Test]
        public void At_FromTheFirstChangeOn_IsPredicted()
        {
            var axis = New();
            for (var k = 0; k < 20; k++) axis.Add(new JointSample(0.05 * k, 0.7), 0.05 * k);

            axis.Add(new JointSample(1, 0.8), 1);

            Assert.That(axis.At(1.1), Is.EqualTo(1).Within(1e-12));
            Assert.That(axis.Hold, Is.EqualTo(0.8));
        }

        [Test]
        public void Reset_AfterAChange_WaitsForTheNextOne()
        {
            var axis = New();
            axis.Add(new JointSample(0, 1), 0);
            axis.Add(new JointSample(0.05, 2), 0.05);

            axis.Reset();
            axis.Add(new JointSample(0.1, 5), 0.1);
            axis.Add(new JointSample(0.15, 5), 0.15);

            Assert.That(axis.At(0.3), Is.EqualTo(5));
        }
    }
}
