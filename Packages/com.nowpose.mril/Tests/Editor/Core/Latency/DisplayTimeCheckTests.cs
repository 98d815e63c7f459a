using System;
using Nowpose.Latency;
using Nowpose.Latency.DisplayTime;
using Nowpose.Simulation;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Latency
{
    public class DisplayTimeCheckTests
    {
        DisplayTimeCheck _check;
        Random _random;
        int _frame;
        double _start;

        [SetUp]
        public void Begin()
        {
            _check = new DisplayTimeCheck();
            _random = new Random(4);
            _frame = 0;
            _start = 0;
        }

        // Adds frames whose differences scatter with a standard deviation of 1 ms. Stops when the state of the check changes, and returns the
        // number of frames that it added.
        int Frames(int count, double differenceMs, double outlierChance = 0)
        {
            var before = _check.IsInconsistent;
            for (var i = 0; i < count; i++)
            {
                var scatter = _random.NextNormal();
                var outlier = _random.NextDouble() < outlierChance ? 16.7 : 0;
                _check.Add(HeadsetTime.FromSeconds(_start + _frame++ / 60.0), Lengths.Ms(differenceMs + scatter + outlier));
                if (_check.IsInconsistent != before) return i + 1;
            }
            return count;
        }

        [TestCase(6)]
        [TestCase(-6)]
        [TestCase(20)]
        public void Add_LastingDifference_IsInconsistentWithinTwoSeconds(double differenceMs)
        {
            var frames = Frames(600, differenceMs);

            Assert.That(_check.IsInconsistent, Is.True);
            Assert.That(frames, Is.InRange(60, 126), "seed 4");
            Assert.That(_check.Difference.Value.TotalMilliseconds, Is.EqualTo(differenceMs).Within(0.6));
        }

        [TestCase(4)]
        [TestCase(-4)]
        [TestCase(0)]
        public void Add_SmallDifference_StaysConsistentForAMinute(double differenceMs)
        {
            Frames(3600, differenceMs, outlierChance: 0.05);

            Assert.That(_check.IsInconsistent, Is.False, "seed 4; single frames are 16.7 ms off");
        }

        [Test]
        public void Add_DeviationFor750Ms_StaysConsistent()
        {
            Frames(300, 0);
            Frames(45, 30);
            Frames(300, 0);

            Assert.That(_check.IsInconsistent, Is.False);
        }

        [Test]
        public void Add_InconsistentThenNearTheThreshold_StaysInconsistentUntilAgreement()
        {
            Frames(300, 8);
            Frames(600, 4.6);
            var atTheLimit = _check.IsInconsistent;

            Frames(300, 1);

            Assert.That(atTheLimit, Is.True);
            Assert.That(_check.IsInconsistent, Is.False);
        }

        [TestCase(0.2, true)]
        [TestCase(0.3, false)]
        [TestCase(10, false)]
        public void Add_GapAfterFewDeviatingFrames_CountsAsDeviationOnlyIfShort(double gapSeconds, bool isInconsistent)
        {
            // The median exceeds the threshold from the 31st deviating frame on, half a second before the gap. The frames after the gap last less
            // than half a second, so the deviation reaches the required second only if the gap counts.
            Frames(60, 0);
            Frames(60, 20);
            _start += gapSeconds;

            Frames(25, 20);

            Assert.That(_check.IsInconsistent, Is.EqualTo(isInconsistent), "seed 4");
        }

        [Test]
        public void Add_OneAgreeingFrameAfterAGap_StaysInconsistent()
        {
            Frames(300, 8);
            Frames(40, 0);
            _start += 10;

            Frames(1, 0);

            Assert.That(_check.IsInconsistent, Is.True);
        }

        [Test]
        public void Reset_Inconsistent_ClearsTheState()
        {
            Frames(300, 8);

            _check.Reset();

            Assert.That(_check.IsInconsistent, Is.False);
            Assert.That(_check.Difference, Is.Null);
        }
    }
}
