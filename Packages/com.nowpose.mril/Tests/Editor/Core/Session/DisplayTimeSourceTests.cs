using System;
using Nowpose.Latency;
using Nowpose.Latency.Profile;
using Nowpose.Session;
using Nowpose.Simulation;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Session
{
    public class DisplayTimeSourceTests
    {
        /// <summary>
        /// Returns the true L_visu in ms. It alternates between two and three refreshes every half second, and only the display's runtime
        /// reports it.
        /// </summary>
        static double TrueMs(double seconds) => (int)(seconds * 2) % 2 == 0 ? 33.3 : 50;

        sealed class Runtime : IDisplayTimeSource
        {
            public Func<double, double?> Ms { get; set; } = seconds => TrueMs(seconds);

            public HeadsetTime? LightOf(HeadsetTime frameStart) => Ms(frameStart.SinceEpoch.TotalSeconds) is double ms
                ? frameStart + Lengths.Ms(ms) : (HeadsetTime?)null;
        }

        static SimulatedSession Running(IDisplayTimeSource source)
        {
            var simulated = new SimulatedSession(NetworkProfile.Lan, 5);
            simulated.Session.DisplayTimeSource = source;
            simulated.Run(10);
            return simulated;
        }

        // Returns the RMS error of the shoulder joint over 20 s, in rad, relative to its true position at the true display time.
        static double ErrorOf(IDisplayTimeSource source)
        {
            var simulated = Running(source);
            double sum = 0;
            var frames = 0;
            simulated.Run(20, (frame, _) =>
            {
                var start = frame.Start.SinceEpoch.TotalSeconds;
                var shoulder = frame.Joints[TestRobot.Model.IndexOfMovingJoint("shoulder")];
                sum += Math.Pow(shoulder - SimulatedSession.TruthAt(start + TrueMs(start) / 1000).Shoulder, 2);
                frames++;
            });
            return Math.Sqrt(sum / frames);
        }

        [Test]
        public void DisplayTimeSource_VaryingLatency_IsCompensatedOnlyWithASource()
        {
            var with = ErrorOf(new Runtime());
            var without = ErrorOf(null);

            Assert.That(without, Is.GreaterThan(0.006), "the latency is wrong by 8 ms at about 1 rad/s");
            Assert.That(with, Is.LessThan(0.4 * without), "only the error of the prediction remains");
        }

        [Test]
        public void DisplayTimeSource_NoOrInvalidTime_UsesTheCalibratedLatency([Values(null, -1.0, 501.0)] double? ms)
        {
            var simulated = Running(new Runtime { Ms = _ => ms });

            var statistics = simulated.Session.Statistics(default);

            Assert.That(statistics.VisualisationLatency, Is.EqualTo(Lengths.Ms(40)));
            Assert.That(statistics.IsLightPredicted, Is.False);
            Assert.That(statistics.DisplayTimeDifference, Is.Null);
        }

        [TestCase(501.0)]
        [TestCase(46.5)]
        public void DisplayTimeSource_StopsAfterAFault_IsReportedForOneMoreSecond(double ms)
        {
            var source = new Runtime { Ms = _ => ms };
            var simulated = Running(source);
            source.Ms = _ => null;

            simulated.Run(0.5);
            var stopped = simulated.Session.Statistics(default);
            var (isReported, ahead) = (stopped.IsDisplayTimeImplausible || stopped.IsDisplayTimeInconsistent, stopped.DisplayTimeAhead);
            simulated.Run(1);
            var later = simulated.Session.Statistics(default);

            Assert.That((isReported, ahead), Is.EqualTo((true, (TimeSpan?)Lengths.Ms(ms))));
            Assert.That(later.IsDisplayTimeImplausible || later.IsDisplayTimeInconsistent, Is.False);
            Assert.That((later.DisplayTimeDifference, later.DisplayTimeAhead), Is.EqualTo(((TimeSpan?)null, (TimeSpan?)null)));
        }

        [TestCase(46.5, true)]
        [TestCase(44, false)]
        public void DisplayTimeSource_LastingDifference_IsReportedOnceAboveFiveMilliseconds(double ms, bool isReported)
        {
            var simulated = Running(null);
            var watch = new SessionWatch();
            var reports = 0;
            void See(DisplayFrame frame, double light)
            {
                if ((watch.Changed(frame) & SessionChange.DisplayTimeInconsistent) != 0) reports++;
            }
            simulated.Run(1, See);

            simulated.Session.DisplayTimeSource = new Runtime { Ms = _ => ms };
            simulated.Run(2.1, See);
            simulated.Run(10, See);

            var statistics = simulated.Session.Statistics(default);
            Assert.That(reports, Is.EqualTo(isReported ? 1 : 0));
            Assert.That(statistics.IsDisplayTimeInconsistent, Is.EqualTo(isReported));
            Assert.That(statistics.DisplayTimeDifference.Value.TotalMilliseconds, Is.EqualTo(ms - 40).Within(1e-3));
            Assert.That(statistics.VisualisationLatency, Is.EqualTo(Lengths.Ms(ms)), "the runtime's value is used");
        }

        [TestCase(46.5, 40, true)]
        [TestCase(40, 46.5, false)]
        public void DisplayTimeSource_FrameComputedTwice_ComparesOnlyTheSecondComputation(double lastMs, double firstMs, bool isInconsistent)
        {
            var simulated = Running(null);
            var ms = lastMs;
            simulated.Session.DisplayTimeSource = new Runtime { Ms = _ => ms };

            simulated.Run(5, (frame, _) =>
            {
                ms = firstMs;
                simulated.Session.Tick(frame.Start + Lengths.Ms(1), isLast: false);
                ms = lastMs;
            });

            var statistics = simulated.Session.Statistics(default);
            Assert.That(statistics.DisplayTimeDifference.Value.TotalMilliseconds, Is.EqualTo(lastMs - 40).Within(1e-3));
            Assert.That(statistics.IsDisplayTimeInconsistent, Is.EqualTo(isInconsistent));
        }

        [Test]
        public void DisplayTimeSource_RenderTimeOutsideTheRange_IsNotCompared()
        {
            var simulated = Running(null);
            simulated.Session.Calibrate(new LatencyProfile(
                40, 1, "", 0, DateTime.UnixEpoch, CalibrationMethod.Sine, 1, 15, RenderTimeSourceKind.DisplayGpuTime));
            for (var i = 0; i < 20; i++) simulated.Session.Rendered(Lengths.Ms(20), RenderTimeSourceKind.DisplayGpuTime);

            simulated.Session.DisplayTimeSource = new Runtime { Ms = _ => 57 };
            simulated.Run(5);

            Assert.That(simulated.Session.Statistics(default).IsDisplayTimeInconsistent, Is.False);
            Assert.That(simulated.Session.Statistics(default).VisualisationLatency, Is.EqualTo(Lengths.Ms(57)));
        }
    }
}
