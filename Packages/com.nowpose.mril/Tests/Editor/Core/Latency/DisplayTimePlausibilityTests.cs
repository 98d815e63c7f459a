using Nowpose.Latency;
using Nowpose.Latency.DisplayTime;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Latency
{
    public class DisplayTimePlausibilityTests
    {
        DisplayTimePlausibility _check;
        double _now;

        [SetUp]
        public void Begin()
        {
            _check = new DisplayTimePlausibility();
            _now = 100;
        }

        // Adds frames at 60 Hz.
        void Frames(int count, double aheadMs)
        {
            for (var i = 0; i < count; i++) _check.Add(HeadsetTime.FromSeconds(_now += 1 / 60.0), Lengths.Ms(aheadMs));
        }

        [TestCase(0, true)]
        [TestCase(500, true)]
        [TestCase(-0.1, false)]
        [TestCase(500.1, false)]
        public void Add_OneDisplayTime_IsPlausibleUpToHalfASecondAhead(double aheadMs, bool isPlausible)
        {
            Assert.That(_check.Add(HeadsetTime.FromSeconds(1), Lengths.Ms(aheadMs)), Is.EqualTo(isPlausible));
            Assert.That(_check.Ahead, Is.EqualTo(Lengths.Ms(aheadMs)));
        }

        [TestCase(54, false)]
        [TestCase(59, false)]
        [TestCase(61, true)]
        public void Add_ImplausibleDisplayTimes_AreDetectedAfterASecond(int frames, bool isFound)
        {
            Frames(30, 47);

            Frames(frames, 1e6);

            Assert.That(_check.IsImplausible, Is.EqualTo(isFound));
        }

        [Test]
        public void Add_PlausibleDisplayTimesAgain_RecoversAfterASecond()
        {
            Frames(300, -20);
            Frames(59, 47);
            var early = _check.IsImplausible;

            Frames(2, 47);

            Assert.That(early, Is.True);
            Assert.That(_check.IsImplausible, Is.False);
        }

        [TestCase(2, 1, true)]
        [TestCase(1, 2, false)]
        public void Add_MixedDisplayTimes_AreImplausibleIfMostOfThemAre(int bad, int good, bool isFound)
        {
            for (var i = 0; i < 120; i++)
            {
                Frames(bad, 9999);
                Frames(good, 47);
            }

            Assert.That(_check.IsImplausible, Is.EqualTo(isFound));
        }

        [Test]
        public void Add_PauseBetweenImplausibleFrames_IsNotCounted()
        {
            Frames(30, 9999);
            _now += 10;

            Frames(25, 9999);

            Assert.That(_check.IsImplausible, Is.False);
        }

        [Test]
        public void Reset_Implausible_ClearsTheState()
        {
            Frames(300, 9999);

            _check.Reset();

            Assert.That(_check.IsImplausible, Is.False);
            Assert.That(_check.Ahead, Is.Null);
        }
    }
}
