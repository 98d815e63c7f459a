using System;
using System.Linq;
using Nowpose.Motion;
using Nowpose.Prediction;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Prediction
{
    /// <summary>Checks that the adaptive predictor recovers from irregular samples of real plants.</summary>
    public class AdaptiveInTheFieldTests
    {
        const double Latency = 0.1;

        [TestCase(0.5)]
        [TestCase(2 * Math.PI)]
        [TestCase(1000)]
        [TestCase(1e40)]
        public void Play_OneWrongSample_RecoversWithinSeconds(double glitch)
        {
            var joint = new DisplayedJoint(Predictors.Create("adaptive", PredictionLimits.Unlimited));
            double Rms(double from, double to) => Math.Sqrt(joint
                .Play(k => new JointSample(k * 0.05, Motion(k * 0.05) + (k == 400 ? glitch : 0)), from, to)
                .Average(frame => Math.Pow(frame.Shown.Position - Motion(frame.At), 2)));

            Rms(0, 40);
            var soon = Rms(40, 80);
            var later = Rms(80, 140);

            Assert.That(soon, Is.LessThan(0.03), "the error of hold is 0.3");
            Assert.That(later, Is.LessThan(0.006));
        }

        // The way back is not a velocity, although the wrong position is not far enough away to be noticed at once.
        [TestCase(0.15)]
        [TestCase(0.3)]
        [TestCase(0.34)]
        [TestCase(0.4)]
        [TestCase(-0.4)]
        public void Play_OneWrongSample_TheNextOneIsPredictedFromTheOthers(double glitch)
        {
            double Error(double wrong)
            {
                var joint = new DisplayedJoint(Predictors.Create("adaptive", PredictionLimits.Unlimited));
                double Truth(double t) => 0.5 * Math.Sin(2 * t);
                // At sample 377, at 18.85 s, the joint has its maximum speed.
                joint.Play(k => new JointSample(k * 0.05, Truth(k * 0.05) + (k == 376 ? wrong : 0)), 0, 18.96);
                return Math.Abs(joint.Show(19).Position - Truth(19));
            }

            Assert.That(Error(glitch), Is.LessThan(0.03).And.LessThan(0.03 + Error(0)), "hold has an error of 0.15");
        }

        // The repetition that was learned before remains.
        [TestCase(0.2)]
        [TestCase(0.9)]
        public void Play_OneStampInTheFuture_RecoversAfterTwoMoreSamples(double seconds)
        {
            var move = new SevenPhaseProfile(1, 1.5, 8, 80);
            double Position(double t) => t % 4 < 2 ? move.PositionAt(t % 4 - 0.4) : 1 - move.PositionAt(t % 4 - 2.4);
            var joint = new DisplayedJoint(Predictors.Create("adaptive", PredictionLimits.Unlimited));
            // Sample 412, at 20.6 s, is taken while the joint accelerates.
            for (int frame = 0, k = 0; frame < 1500; frame++)
            {
                var time = frame / 60.0;
                for (; k * 0.05 + Latency <= time + 1e-9; k++) joint.Add(k * 0.05 + (k == 412 ? seconds : 0), Position(k * 0.05));
                var shown = joint.Show(time);
                if (time > 20.81) Assert.That(shown.Position, Is.EqualTo(Position(time)).Within(5e-3), "at " + time);
            }
            Assert.That(joint.Predictor.Restarts, Is.Zero);
        }

        // The stamp is in the future by one to two intervals, at any place of the move. Sections with intervals of a few milliseconds, or a
        // repetition of them, would be wrong by more than 1 rad.
        [TestCase(0.02, 0.05)]
        [TestCase(0.05, 0.1)]
        [TestCase(0.1, 0.2)]
        public void Play_OneStampInTheNearFuture_IsNotRepeated(double interval, double maxError)
        {
            var move = new SevenPhaseProfile(1, 1.5, 8, 80);
            double Position(double t) => t % 4 < 2 ? move.PositionAt(t % 4 - 0.4) : 1 - move.PositionAt(t % 4 - 2.4);
            for (var seed = 0; seed < 16; seed++)
            {
                var random = new Random(seed);
                var (wrong, future) = ((int)((20 + 4 * random.NextDouble()) / interval), interval * (1 + random.NextDouble()));
                var joint = new DisplayedJoint(Predictors.Create("adaptive", PredictionLimits.Unlimited));
                for (int frame = 0, k = 0; frame < 30 * 60; frame++)
                {
                    var time = frame / 60.0;
                    for (; k * interval + Latency <= time + 1e-9; k++) joint.Add(k * interval + (k == wrong ? future : 0), Position(k * interval));
                    var shown = joint.Show(time);
                    if (time <= (wrong + 2) * interval + Latency) continue;
                    Assert.That(shown.Position, Is.EqualTo(Position(time)).Within(maxError), $"at {time}, seed {seed}");
                }
            }
        }

        // The weights must not learn from the wrong position, nor from the forecasts that were made from it.
        [TestCase(0.02, 2)]
        [TestCase(0.02, 20)]
        [TestCase(0.05, 2)]
        [TestCase(0.05, 5)]
        [TestCase(0.05, 20)]
        public void Play_SeveralWrongSamples_LaterErrorsAreTheSame(double interval, int wrong)
        {
            double Rms(int count)
            {
                var (joint, first) = (new DisplayedJoint(Predictors.Create("adaptive", PredictionLimits.Unlimited)), (int)(20 / interval));
                JointSample Sample(int k) => new JointSample(k * interval, k >= first && k < first + count ? 3 : Motion(k * interval));
                joint.Play(Sample, 0, 22);
                return Math.Sqrt(joint.Play(Sample, 22, 40).Average(frame => Math.Pow(frame.Shown.Position - Motion(frame.At), 2)));
            }

            Assert.That(Rms(wrong), Is.LessThan(1.2 * Rms(0)));
        }

        // A robot that repeats its move. The wrong sample must not close the gate of the repetition.
        [TestCase(0.5)]
        [TestCase(2 * Math.PI)]
        [TestCase(1000)]
        public void Play_OneWrongSampleOfARepeatedMove_RepetitionContinuesAfterHalfASecond(double glitch)
        {
            var move = new SevenPhaseProfile(1, 1.5, 8, 80);
            double Position(double t) => t % 4 < 2 ? move.PositionAt(t % 4 - 0.4) : 1 - move.PositionAt(t % 4 - 2.4);
            double Rms(double wrong)
            {
                var joint = new DisplayedJoint(Predictors.Create("adaptive", PredictionLimits.Unlimited));
                JointSample Sample(int k) => new JointSample(k * 0.05, Position(k * 0.05) + (k == 417 ? wrong : 0));
                joint.Play(Sample, 0, 21.5);
                return Math.Sqrt(joint.Play(Sample, 21.5, 25).Average(frame => Math.Pow(frame.Shown.Position - Position(frame.At), 2)));
            }

            Assert.That(Rms(glitch), Is.LessThan(2 * Rms(0)));
        }

        // The way back from a wrong sample is not a velocity that the drive would have to slow down.
        [Test]
        public void At_SampleAfterAWrongOneOfADriveWithKnownAcceleration_IsPredictedFromTheOthers()
        {
            var predictor = Predictors.Create("adaptive", new PredictionLimits(velocity: 3, acceleration: 5));
            for (var k = 0; k <= 60; k++) predictor.Add(k * 0.05, 0.2 * k * 0.05 + (k == 59 ? 0.5 : 0));

            var shown = predictor.At(3 + Latency);
            Assert.That(shown.Kind, Is.EqualTo(PredictionKind.Predicted));
            Assert.That(shown.Position, Is.EqualTo(0.62).Within(1e-9));
        }

        [TestCase(0.05, 0.06, 0)]
        [TestCase(0.02, 0.0205, 0)]
        [TestCase(0.05, 0.051, 0)]
        [TestCase(0.05, 0.02, 0)]
        [TestCase(0.1, 0.05, 0)]
        [TestCase(0.05, 0.05, 0.01)]
        [TestCase(0.02, 0.02, 0.008)]
        public void Play_SamplingIntervalChanges_ErrorStaysSmall(double before, double after, double shift)
        {
            var joint = new DisplayedJoint(Predictors.Create("adaptive", PredictionLimits.Unlimited));
            var turn = (int)(30 / before);
            double TimeOf(int k) => k < turn ? k * before : turn * before + shift + (k - turn) * after;

            var worst = joint.Play(k => new JointSample(TimeOf(k), Motion(TimeOf(k))), 0, 60)
                .Where(frame => frame.At > 20).Max(frame => Math.Abs(frame.Shown.Position - Motion(frame.At)));

            Assert.That(worst, Is.LessThan(0.08), "the error of hold is 0.3");
        }

        [Test]
        public void Play_RestWithoutNoiseAtStart_DoesNotAmplifyNoiseAtALaterRest()
        {
            const double noise = 1e-4;
            var random = new Random(4);
            var predictor = Predictors.Create("adaptive", PredictionLimits.Unlimited);
            double squares = 0, count = 0;
            for (var k = 0; k < 1600; k++)
            {
                var t = k * 0.05;
                var truth = t < 5 ? 0 : t < 35 ? Motion(t - 5) - Motion(0) : Motion(30) - Motion(0);
                predictor.Add(t, truth + (t < 5 ? 0 : noise * 2 * (random.NextDouble() + random.NextDouble() + random.NextDouble() - 1.5)));
                if (t < 40) continue;
                squares += Math.Pow(predictor.At(t + Latency).Position - truth, 2);
                count++;
            }

            Assert.That(Math.Sqrt(squares / count), Is.LessThan(8 * noise), "seed 4");
        }

        static double Motion(double t) => Math.Sin(2 * t) + 0.4 * Math.Sin(5.1 * t + 1);

        // The forecast from reported velocities needs the newest sample only, so it would move although the position is stated to be held.
        [Test]
        public void At_ReturnFromWrongSamplesWithReportedVelocity_IsHeld()
        {
            var predictor = Predictors.Create("adaptive", PredictionLimits.Unlimited);
            for (var i = 0; i < 40; i++)
                predictor.Add(new JointSample(0.05 * i, 0.05 * i + (i == 37 || i == 38 ? 20 : 0), 0.05 * i, velocity: 1, acceleration: 0), 0.05 * i + 0.1);

            var ahead = predictor.At(0.05 * 39 + 0.04);

            Assert.That((ahead.Kind, ahead.Position - predictor.Hold), Is.EqualTo((PredictionKind.Held, 0.0)));
        }
    }
}
