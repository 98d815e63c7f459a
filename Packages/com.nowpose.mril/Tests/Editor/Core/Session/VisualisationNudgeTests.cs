using System;
using Nowpose.Latency;
using Nowpose.Latency.Profile;
using Nowpose.Network;
using Nowpose.Prediction;
using Nowpose.Session;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Session
{
    public class VisualisationNudgeTests
    {
        static readonly RenderTimeSourceKind Source = RenderTimeSourceKind.DisplayGpuTime;

        static readonly LatencyProfile Measured = Profile(62);

        static LatencyProfile Profile(double visuMs) => new LatencyProfile(
            visuMs, 1, "HoloLens 2", 60, new DateTime(2026, 11, 20, 0, 0, 0, DateTimeKind.Utc), CalibrationMethod.VisibleLight, 300, 12, Source);

        static CompensationSession NewSession(double visuMs = 40) => new CompensationSession(
            new SessionSettings(new ConnectionSettings("127.0.0.1"), VisualisationLatency.FromMilliseconds(visuMs), new PredictionSettings()),
            TestRobot.Model, new SetClock());

        static double VisuMs(CompensationSession session) => session.Visualisation.Length.TotalMilliseconds;

        static VisualisationNudge Following(CompensationSession session)
        {
            var nudge = new VisualisationNudge();
            nudge.Follow(session);
            return nudge;
        }

        [Test]
        public void Ms_ProfileInUse_IsAddedToItsLatencyAndRemovesTheProfile()
        {
            var session = NewSession();
            session.Calibrate(Measured);
            var nudge = Following(session);

            nudge.Ms = 5;
            nudge.Ms = -3;

            Assert.That(VisuMs(session), Is.EqualTo(59).Within(1e-6));
            Assert.That(session.Profile, Is.Null);
            Assert.That(session.Range.Limit.TotalMilliseconds, Is.EqualTo(12), "the render time limit does not change");
        }

        [Test]
        public void Ms_BackToZero_RestoresTheProfile()
        {
            var session = NewSession();
            session.Calibrate(Measured);
            var nudge = Following(session);

            nudge.Ms = 5;
            nudge.Ms = 0;

            Assert.That(VisuMs(session), Is.EqualTo(62).Within(1e-6));
            Assert.That(session.Profile, Is.SameAs(Measured));
        }

        [Test]
        public void Ms_BackToZeroWithoutProfile_RestoresTheConfiguredValue()
        {
            var session = NewSession();
            var nudge = Following(session);

            nudge.Ms = 5;
            nudge.Ms = 0;

            Assert.That(VisuMs(session), Is.EqualTo(40).Within(1e-6));
        }

        [TestCase(80, 40, 50)]
        [TestCase(-80, 100, -50)]
        [TestCase(-80, 40, -40)]
        [TestCase(30, 490, 10)]
        [TestCase(double.NaN, 40, 0)]
        [TestCase(double.PositiveInfinity, 40, 50)]
        public void Ms_BeyondTheRange_IsClamped(double asked, double calibratedMs, double expected)
        {
            var session = NewSession(calibratedMs);
            var nudge = Following(session);

            nudge.Ms = asked;

            Assert.That(nudge.Ms, Is.EqualTo(expected).Within(1e-6));
            Assert.That(VisuMs(session), Is.EqualTo(calibratedMs + expected).Within(1e-6));
        }

        [Test]
        public void Follow_SessionRestartsWithTheSameCalibration_AppliesTheNudge()
        {
            var nudge = Following(NewSession());
            nudge.Ms = 5;
            var next = NewSession();

            nudge.Follow(null);
            nudge.Follow(next);

            Assert.That(nudge.Ms, Is.EqualTo(5));
            Assert.That(VisuMs(next), Is.EqualTo(45).Within(1e-6));
        }

        [TestCase(62)]
        [TestCase(45, Description = "equal to the nudged value")]
        public void Follow_SessionCalibrated_EndsTheNudge(double visuMs)
        {
            var session = NewSession();
            var nudge = Following(session);
            nudge.Ms = 5;
            var found = Profile(visuMs);

            session.Calibrate(found);
            nudge.Follow(session);

            Assert.That(nudge.Ms, Is.EqualTo(0));
            Assert.That(VisuMs(session), Is.EqualTo(visuMs).Within(1e-6));
            Assert.That(session.Profile, Is.SameAs(found));
        }

        [Test]
        public void Ms_BeforeTheFirstSession_AppliesOnceItStarts()
        {
            var nudge = new VisualisationNudge { Ms = 5 };
            var session = NewSession();

            nudge.Follow(session);

            Assert.That(VisuMs(session), Is.EqualTo(45).Within(1e-6));
        }

        [Test]
        public void IsIdle_DisplayTimeIsPredicted_IsTrue([Values] bool predicted)
        {
            var session = NewSession();
            if (predicted) session.DisplayTimeSource = new Ahead();
            var nudge = Following(session);

            session.Tick(HeadsetTime.FromSeconds(1));

            Assert.That(nudge.IsIdle, Is.EqualTo(predicted));
        }

        sealed class Ahead : IDisplayTimeSource
        {
            public HeadsetTime? LightOf(HeadsetTime frameStart) => frameStart + TimeSpan.FromMilliseconds(30);
        }
    }
}
