using Nowpose.Prediction;
using Nowpose.Prediction.Candidates;
using Nowpose.Prediction.Samples;
using Nowpose.Prediction.State;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Prediction.Candidates
{
    public class MotionHistoryTests
    {
        const double Interval = 0.05;

        /// <summary>Speed of the motion, per second.</summary>
        const double Speed = 0.7;

        // A spline is exact for a line, also where its points are at both ends of the ring buffer.
        [Test]
        public void At_MoreGridPointsThanTheCapacity_IsThePositionAtEachStoredTime()
        {
            var buffer = new SampleBuffer<JointSample>(24, PredictionLimits.Unlimited);
            var (motion, history) = (new MotionState(1, 0, 24, buffer.Timing), new MotionHistory(1));

            for (var sample = 0; sample < MotionHistory.Capacity + 100; sample++)
            {
                buffer.Add(new JointSample(sample * Interval, Speed * sample * Interval), displayed: double.NaN);
                motion.Take(buffer);
                history.Take(motion);
            }

            Assert.That(history.Count, Is.GreaterThan(MotionHistory.Capacity));
            var start = history.IndexOf(0);
            for (var index = history.First + 0.25; history.Covers(index); index += 0.5)
                Assert.That(history.At(index, 0), Is.EqualTo(Speed * Interval * (index - start)).Within(1e-6), "index " + index);
        }
    }
}
