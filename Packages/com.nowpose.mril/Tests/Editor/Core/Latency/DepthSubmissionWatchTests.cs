using Nowpose.Latency;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Latency
{
    public class DepthSubmissionWatchTests
    {
        DepthSubmissionWatch _watch;
        double _now;
        int _changes;

        [SetUp]
        public void Begin()
        {
            _watch = new DepthSubmissionWatch();
            _now = 5;
            _changes = 0;
        }

        void Observe(double seconds, DepthSubmission depth)
        {
            for (var end = _now + seconds - 1e-6; _now < end; _now += 0.25)
                if (_watch.Follow(HeadsetTime.FromSeconds(_now), depth)) _changes++;
        }

        [TestCase(1.0, false)]
        [TestCase(1.25, true)]
        public void Follow_NewState_AppliesAfterASecond(double seconds, bool isKnown)
        {
            Observe(seconds, DepthSubmission.TurnedOff);

            Assert.That(_watch.State, Is.EqualTo(isKnown ? DepthSubmission.TurnedOff : DepthSubmission.Unknown));
            Assert.That(_changes, Is.EqualTo(isKnown ? 1 : 0));
        }

        [Test]
        public void Follow_CameraChangedBriefly_ReportsNothing()
        {
            Observe(3, DepthSubmission.Active);

            Observe(0.75, DepthSubmission.NoMainCamera);
            Observe(3, DepthSubmission.Active);

            Assert.That(_watch.State, Is.EqualTo(DepthSubmission.Active));
            Assert.That(_changes, Is.EqualTo(1));
        }

        [Test]
        public void Reset_KnownState_IsUnknownAndTakesASecondAgain()
        {
            Observe(3, DepthSubmission.Active);

            _watch.Reset();
            Observe(0.5, DepthSubmission.Active);

            Assert.That(_watch.State, Is.EqualTo(DepthSubmission.Unknown));
        }
    }
}
