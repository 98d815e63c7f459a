using System;
using Nowpose.Prediction;
using Nowpose.Prediction.Stamps;
using NUnit.Framework;

namespace Nowpose.Tests
{
    public class DejitteredPredictorTests
    {
        const int Seed = 21;

        readonly TakenSamples _taken = new TakenSamples();

        [TestCase(0.050, 0.005, 0)]
        [TestCase(0.050, 0.010, 0)]
        [TestCase(0.020, 0.005, 0)]
        [TestCase(0.100, 0.010, 0.01)]
        [TestCase(0.050, 0.010, 0.02)]
        [TestCase(0.0333, 0.004, 0.02)]
        public void Add_PeriodicSourceWithScatteredStamps_TakesMostOfTheScatterAway(double interval, double scatter, double loss)
        {
            var error = RmsErrorOfTheLast200(interval, scatter, 0, loss);

            // Uniform scatter has a deviation of its half-width over the root of three.
            Assert.That(error, Is.LessThan(0.32 * scatter / Math.Sqrt(3)), "seed " + Seed);
        }

        [Test]
        public void Add_SourceOffTheBeatThatSaysSo_IsBelieved()
        {
            Assert.That(RmsErrorOfTheLast200(0.050, 0, 0.008, 0), Is.EqualTo(0), "seed " + Seed);
        }

        [Test]
        public void Add_ExactStamps_AreLeftAlone()
        {
            Assert.That(RmsErrorOfTheLast200(0.050, 0, 0, 0.05), Is.EqualTo(0));
        }

        [Test]
        public void Add_StampsWithoutABeat_AreLeftAlone()
        {
            var random = new Random(Seed);
            var predictor = new DejitteredPredictor(_taken);
            var touched = 0;
            for (double t = 0, i = 0; i < 500; i++)
            {
                t += 0.01 - 0.05 * Math.Log(1 - random.NextDouble());
                predictor.Add(new JointSample(t, Motion(t)));
                if (_taken.Newest.Time != t) touched++;
            }

            // Eight stamps at random may look like a beat by chance, until the ninth.
            Assert.That(touched, Is.LessThan(25), "seed " + Seed);
        }

        [Test]
        public void Add_OvertakenSample_GoesToItsBeat()
        {
            var random = new Random(Seed);
            var predictor = new DejitteredPredictor(_taken);
            for (var k = 0; k < 100; k++)
                if (k != 97) predictor.Add(Sample(k, random));

            predictor.Add(Sample(97, random));

            Assert.That(_taken.Newest.Time, Is.EqualTo(97 * 0.05).Within(0.0015), "seed " + Seed);
            Assert.That(predictor.Hold, Is.EqualTo(Motion(99 * 0.05)));
        }

        [Test]
        public void Add_BeatThatStartsAnewAfterAPause_IsFoundAgain()
        {
            var random = new Random(Seed);
            var predictor = new DejitteredPredictor(_taken);
            for (var k = 0; k < 100; k++) predictor.Add(Sample(k, random));
            var worst = 0.0;
            for (var k = 0; k < 100; k++)
            {
                var time = 60.0173 + k * 0.02;
                predictor.Add(new JointSample(time + 0.004 * (2 * random.NextDouble() - 1), Motion(time), time));
                if (k > 30) worst = Math.Max(worst, Math.Abs(_taken.Newest.Time - time));
            }

            Assert.That(worst, Is.LessThan(0.002), "seed " + Seed);
        }

        [TestCase(0.05, 0.02)]
        [TestCase(0.1, 0.05)]
        public void Add_SourceBecomesFaster_IsFollowedAtOnce(double before, double after)
        {
            var predictor = new DejitteredPredictor(_taken);
            var random = new Random(Seed);
            var t = 0.0;
            var worst = 0.0;
            for (var k = 0; k < 400; k++)
            {
                t += k < 200 ? before : after;
                predictor.Add(new JointSample(t + 0.001 * random.NextDouble(), Motion(t), t));
                if (k >= 200) worst = Math.Max(worst, Math.Abs(_taken.Newest.Time - t));
            }

            Assert.That(worst, Is.LessThan(0.01), "seed " + Seed);
        }

        [Test]
        public void Add_StampThatIsLateNowAndThen_IsPutOnTheBeat()
        {
            var predictor = new DejitteredPredictor(_taken);
            var random = new Random(Seed);
            var worst = 0.0;
            for (var k = 0; k < 400; k++)
            {
                var late = random.NextDouble() < 0.05 ? 0.02 : 0;
                predictor.Add(new JointSample(k * 0.05 + late, Motion(k * 0.05), k * 0.05));
                if (k > 100) worst = Math.Max(worst, Math.Abs(_taken.Newest.Time - k * 0.05));
            }

            Assert.That(worst, Is.LessThan(0.004), "seed " + Seed);
        }

        [Test]
        public void Reset_ForgetsTheBeat()
        {
            var random = new Random(Seed);
            var predictor = new DejitteredPredictor(_taken);
            for (var k = 0; k < 100; k++) predictor.Add(Sample(k, random));

            predictor.Reset();

            Assert.That(predictor.NewestTime, Is.EqualTo(double.NegativeInfinity));
            predictor.Add(new JointSample(1.2345, 1));
            Assert.That(_taken.Newest.Time, Is.EqualTo(1.2345));
        }

        static JointSample Sample(int k, Random random) =>
            new JointSample(k * 0.05 + 0.005 * (2 * random.NextDouble() - 1), Motion(k * 0.05), k * 0.05);

        static double Motion(double t) => 0.5 * Math.Sin(3 * t) + 0.2 * Math.Sin(7.1 * t);

        double RmsErrorOfTheLast200(double interval, double stampError, double trueJitter, double loss)
        {
            const int samples = 500;
            var random = new Random(Seed);
            var predictor = new DejitteredPredictor(_taken);
            var squares = 0.0;
            for (var k = 0; k < samples; k++)
            {
                var time = 3 + k * interval + trueJitter * (2 * random.NextDouble() - 1);
                var told = time + stampError * (2 * random.NextDouble() - 1);
                if (random.NextDouble() < loss) continue;
                predictor.Add(new JointSample(told, Motion(time), time));
                var error = _taken.Newest.Time - time;
                if (k >= samples - 200) squares += error * error;
            }
            return Math.Sqrt(squares / 200);
        }

        sealed class TakenSamples : IJointPredictor
        {
            public JointSample Newest { get; private set; }
            public double Hold => Newest.Position;
            public double NewestTime => Newest.Time;

            public SampleOutcome Add(in JointSample sample)
            {
                Newest = sample;
                return SampleOutcome.Accepted;
            }

            public JointPrediction At(double time) => default;

            public void Reset() { }
        }
    }
}
