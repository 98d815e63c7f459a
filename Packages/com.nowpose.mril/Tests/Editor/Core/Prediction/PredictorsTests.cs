using System;
using System.Linq;
using System.Threading.Tasks;
using Nowpose.Prediction;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Prediction
{
    public class PredictorsTests
    {
        static readonly string[] Names = Predictors.Names.ToArray();

        // Values at 5 s of the fits through t⁴ at 0, 1, 2, 3, 4 s, computed separately in rational numbers.
        [TestCase("hold", 256)]
        [TestCase("linear", 431)]
        [TestCase("quadratic", 541)]
        [TestCase("cubic", 601)]
        [TestCase("quadratic-h3", 496)]
        [TestCase("quadratic-h4", 447.4)]
        [TestCase("linear-h1", 431)]
        [TestCase("linear-h2", 1073 / 3.0)]
        [TestCase("cubic-h4", 581.8)]
        public void Create_Name_ReturnsThePredictorWithItsDegreeAndHistory(string name, double expected)
        {
            var predictor = Predictors.Create(name, PredictionLimits.Unlimited);
            for (var t = 0; t < 5; t++) predictor.Add(t, t * t * t * t);

            Assert.That(predictor.At(5).Position, Is.EqualTo(expected).Within(1e-9));
        }

        [TestCaseSource(nameof(Names))]
        public void Create_SameNameTwice_ReturnsIndependentPredictors(string name)
        {
            var one = Predictors.Create(name, PredictionLimits.Unlimited);
            var other = Predictors.Create(name, PredictionLimits.Unlimited);

            one.Add(0, 5);

            Assert.That(one.At(0).Position, Is.EqualTo(5));
            Assert.That(other.At(0).Kind, Is.EqualTo(PredictionKind.None));
        }

        // At only reads, so it may be called from any thread between two samples.
        [TestCaseSource(nameof(Names))]
        public void AtAndDeviationAt_TwoThreads_EqualThoseOfOneThread(string name)
        {
            const int times = 10_000;
            var predictor = Predictors.Create(name, PredictionLimits.Unlimited);
            for (var k = 0; k < 40; k++) predictor.Add(k * 0.05, Math.Sin(k * 0.05));
            double TimeOf(int i) => 1.95 + i % 100 * 0.003;
            var expected = Enumerable.Range(0, 100).Select(i => (predictor.At(TimeOf(i)).Position, predictor.DeviationAt(TimeOf(i)))).ToArray();

            var differences = new int[2];
            Parallel.For(0, differences.Length, thread =>
            {
                for (var i = 0; i < times; i++)
                {
                    var at = i + 37 * thread;
                    var (position, deviation) = expected[at % 100];
                    if (!predictor.At(TimeOf(at)).Position.Equals(position) || !predictor.DeviationAt(TimeOf(at)).Equals(deviation)) differences[thread]++;
                }
            });

            Assert.That(differences, Is.EqualTo(new[] { 0, 0 }));
        }

        // A frame shows the time 80 ms after each sample, and one half of an interval later on average until the next sample.
        [TestCaseSource(nameof(Names))]
        public void Horizon_DisplayedTimes_IsTheirMeanTimeAfterTheNewestSample(string name)
        {
            var predictor = Predictors.Create(name, PredictionLimits.Unlimited);
            for (var k = 0; k < 200; k++) predictor.Add(new JointSample(k * 0.05, k % 7), k * 0.05 + 0.08);

            Assert.That(predictor.Horizon, Is.EqualTo(0.105).Within(1e-3));
        }

        [Test]
        public void Create_HoldWithABlend_IsNotBlended()
        {
            var joint = new DisplayedJoint(Predictors.Create("hold", PredictionLimits.Unlimited, 0.1));
            for (var k = 0; k < 20; k++) joint.Add(k * 0.05, 0.1 * k);
            joint.Show(1);
            joint.Add(1, 2);

            Assert.That(joint.Show(1.01).Position, Is.EqualTo(2));
        }

        [TestCase("quartic")]
        [TestCase("quartic-h4")]
        [TestCase("linear-h0")]
        [TestCase("cubic-h2")]
        [TestCase("linear-h101")]
        [TestCase("linear-h+4")]
        [TestCase("Quadratic")]
        [TestCase("")]
        [TestCase(null)]
        public void Create_UnknownName_ThrowsWithAllNames(string name)
        {
            var e = Assert.Throws<InputException>(() => Predictors.Create(name, PredictionLimits.Unlimited));

            Assert.That(e.Message, Does.Contain("'" + name + "'").And.Contain("hold, linear, quadratic, cubic, quadratic-h3, quadratic-h4"));
        }

        [Test]
        public void Default_IsOneOfTheNames() => Assert.That(Names, Does.Contain(Predictors.Default));
    }
}
