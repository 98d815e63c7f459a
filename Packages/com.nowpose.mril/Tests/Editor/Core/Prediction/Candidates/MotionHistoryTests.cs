using System;
using NUnit.Framework;
using Nowpose.Prediction;
using Nowpose.Prediction.Candidates;
using Nowpose.Prediction.Samples;
using Nowpose.Prediction.State;

namespace Nowpose.Tests.Core.Prediction.Candidates
{
    public sealed class MotionHistoryTests
    {
        const double Interval = 0.05;

        readonly SampleBuffer<JointSample> _buffer = new SampleBuffer<JointSample>(24, PredictionParts.None, PredictionLimits.Unlimited);
        readonly MotionHistory _history = new MotionHistory(components: 1);
        MotionState _motion;

        [SetUp]
        public void SetUp()
        {
            _buffer.Clear();
            _motion = new MotionState(1, 0, 24, _buffer.Timing);
            _history.Start(Interval);
        }

        [Test]
        public void Add_SampleThatWasOvertaken_IsAGridPoint()
        {
            foreach (var k in new[] { 0, 1, 2, 3, 4, 5, 7, 6, 8, 9, 10 }) Add(k, Truth(k));

            Assert.That(_history.Count, Is.EqualTo(10));
            Assert.That(_history.Points[6], Is.EqualTo(Truth(6)).Within(1e-12));
        }

        [Test]
        public void Add_WrongSample_IsReplacedWithTheLineBetweenItsNeighbours()
        {
            for (var k = 0; k <= 10; k++) Add(k, k == 6 ? Truth(k) + 3 : Truth(k));

            Assert.That(_history.Points[6], Is.EqualTo((Truth(5) + Truth(7)) / 2).Within(1e-12));
        }

        static double Truth(int k) => Math.Sin(5 * k * Interval);

        void Add(int k, double position)
        {
            _buffer.Add(new JointSample(k * Interval, position), displayed: double.NaN);
            _motion.Take(_buffer);
            if (_motion.IsNewest) _history.Add(_motion);
        }
    }
}
