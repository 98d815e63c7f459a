using System;
using NUnit.Framework;
using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Prediction;
using Nowpose.Prediction.Candidates;
using Nowpose.Prediction.Samples;
using Nowpose.Prediction.State;

namespace Nowpose.Tests.Core.Prediction.Candidates
{
    public class TemplateComponentsTests
    {
        const double Interval = 0.05, Ahead = 0.12;

        // Period of the motion, s. It is not a multiple of the sampling interval.
        const double Cycle = 2.7183;

        // A portal that moves one axis after the other, and back.
        static readonly Func<double, double>[] Portal = { t => Axis(t, 0), t => Axis(t, 0.5), t => 0.3 * Axis(t, 1) };

        [Test]
        public void At_AxesThatMoveOneAfterTheOther_AreAllContinued()
        {
            var fed = new Fed(Portal);
            double squares = 0, hold = 0;
            while (fed.Time < 6 * Cycle)
            {
                fed.Add();
                if (fed.Time < 3 * Cycle) continue;
                var (continued, newest, truth) = (fed.At(fed.Time + Ahead), fed.Truth(fed.Time), fed.Truth(fed.Time + Ahead));
                for (var c = 0; c < Portal.Length; c++)
                {
                    squares += Math.Pow(continued[c] - truth[c], 2);
                    hold += Math.Pow(newest[c] - truth[c], 2);
                }
            }

            Assert.That(Math.Sqrt(squares / hold), Is.LessThan(0.05));
        }

        [Test]
        public void At_ComponentsThatNeverChange_DoNotInfluenceTheOthers()
        {
            Fed alone = new Fed(Portal[0]), among = new Fed(_ => 4, Portal[0], _ => -2);
            while (alone.Time < 6 * Cycle)
            {
                alone.Add();
                among.Add();
                var ahead = alone.Time + Ahead;

                Assert.That(among.HasMatch, Is.EqualTo(alone.HasMatch));
                if (!alone.HasMatch) continue;
                Assert.That(among.At(ahead)[1], Is.EqualTo(alone.At(ahead)[0]).Within(1e-12));
                Assert.That(among.At(ahead)[0], Is.EqualTo(4).Within(1e-12));
            }
            Assert.That(alone.HasMatch);
        }

        [Test]
        public void At_ComponentsInAnotherOrder_GiveTheSamePositions()
        {
            Fed one = new Fed(Portal), other = new Fed(Portal[2], Portal[0], Portal[1]);
            while (one.Time < 6 * Cycle)
            {
                one.Add();
                other.Add();
            }

            double[] expected = one.At(one.Time + Ahead), actual = other.At(one.Time + Ahead);
            Assert.That(one.HasMatch);
            Assert.That(actual, Is.EqualTo(new[] { expected[2], expected[0], expected[1] }).Within(1e-6));
        }

        [Test]
        public void Solve_WithoutASimilarMotion_ReturnsFalse()
        {
            var fed = new Fed(Portal);
            for (var i = 0; i < 12; i++) fed.Add();

            Assert.That(fed.HasMatch, Is.False);
        }

        // The grid of the history starts with the ninth sample, which shows that the one before it is wrong.
        [Test]
        public void Solve_SampleBeforeTheStartOfTheHistoryIsWrong_FindsTheRepetition()
        {
            var fed = new Fed(t => Axis(t, 0) + (Math.Abs(t - 7 * Interval) < 1e-9 ? 10 : 0));

            while (fed.Time < 3 * Cycle) fed.Add();

            Assert.That(fed.HasMatch);
        }

        // Moves by 1 in 0.4 s, starting at a given time in the cycle, and back in the second half of the cycle.
        static double Axis(double t, double start)
        {
            var u = (t + Cycle) % Cycle;
            return Step((u - start * 0.8) / 0.4) - Step((u - Cycle / 2 - start * 0.8) / 0.4);
        }

        static double Step(double u)
        {
            u = Math.Max(0, Math.Min(1, u));
            return u * u * u * (10 + u * (6 * u - 15));
        }

        // A forecaster, and the motion of up to three components that it is fed.
        sealed class Fed
        {
            readonly Func<double, double>[] _components;
            readonly SampleBuffer<BodySample> _buffer = new SampleBuffer<BodySample>(24, PredictionLimits.Unlimited);
            readonly TemplateForecaster _forecaster;
            readonly MotionState _motion;
            int _samples;

            public Fed(params Func<double, double>[] components)
            {
                _components = components;
                _forecaster = new TemplateForecaster(new MotionHistory(components.Length), matchInterval: 0);
                _motion = new MotionState(components.Length, 0, 24, _buffer.Timing);
            }

            public bool HasMatch { get; private set; }

            /// <summary>Time of the newest sample.</summary>
            public double Time { get; private set; }

            public double[] Truth(double time) => Array.ConvertAll(_components, component => component(time));

            public void Add()
            {
                Time = _samples++ * Interval;
                var position = Truth(Time);
                Array.Resize(ref position, 3);
                _buffer.Add(new BodySample(Time, new Vector3D(position[0], position[1], position[2]), default, Time), displayed: double.NaN);
                _motion.Take(_buffer);
                HasMatch = _forecaster.Solve(_motion);
            }

            public double[] At(double time)
            {
                var position = new double[_components.Length];
                for (var c = 0; c < position.Length; c++) position[c] = _motion.Newest[c] + _forecaster.At(time - Time, c);
                return position;
            }
        }
    }
}
