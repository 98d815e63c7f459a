using System;
using Nowpose.Latency;
using Nowpose.Latency.Calibration;
using Nowpose.Messages;
using Nowpose.Simulation;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Latency.Calibration
{
    public class NudgeCalibrationTests
    {
        [TestCase(40, 62, 500, 7)]
        [TestCase(40, 31.5, 250, -12)]
        [TestCase(0, 40, 100, 0)]
        public void Result_TrueOffsets_FindsLatencyAndMisplacedBase(double usedVisuMs, double trueMs, double speedMmPerS, double misplacedMm)
        {
            var nudge = new NudgeCalibration(speedMmPerS, usedVisuMs);
            var lagMm = speedMmPerS * (trueMs - usedVisuMs) / 1000;

            nudge.AddForward(lagMm + misplacedMm);
            nudge.AddBackward(-lagMm + misplacedMm);

            Assert.That(nudge.Result.Visualisation.Length.TotalMilliseconds, Is.EqualTo(trueMs).Within(1e-3));
            Assert.That(nudge.Result.OffsetMm, Is.EqualTo(misplacedMm).Within(1e-9));
            Assert.That(nudge.Result.Count, Is.EqualTo(2));
        }

        [Test]
        public void Result_NoisyMarks_ErrorMatchesTheSpread([Values(2.0, 5.0)] double eyeMm)
        {
            const int runs = 400, repeats = 6;
            var random = new Random(11);
            double sumOfSquares = 0, spread = 0;
            double Mark(double mm) => mm + eyeMm * random.NextNormal();
            for (var run = 0; run < runs; run++)
            {
                var nudge = new NudgeCalibration(400, 40);
                for (var i = 0; i < repeats; i++)
                {
                    nudge.AddForward(Mark(8));
                    nudge.AddBackward(Mark(-8));
                }
                sumOfSquares += Math.Pow(nudge.Result.Visualisation.Length.TotalMilliseconds - 60, 2);
                spread += nudge.Result.Spread.TotalMilliseconds / runs;
            }

            var ofMean = Math.Sqrt(sumOfSquares / runs);
            Assert.That(ofMean, Is.EqualTo(spread / Math.Sqrt(repeats)).Within(0.1 * ofMean), "seed 11");
        }

        [Test]
        public void Result_OneMarkPerDirection_SpreadAssumesOneMillimetreOfEyeResolution()
        {
            var nudge = new NudgeCalibration(500, 40);
            nudge.AddForward(3);
            nudge.AddBackward(-3);

            Assert.That(nudge.Result.Spread.TotalMilliseconds, Is.EqualTo(1000 / (Math.Sqrt(2) * 500)).Within(1e-3));
        }

        [Test]
        public void Result_OneDirectionOnly_IsRefused()
        {
            var nudge = new NudgeCalibration(500, 40);
            nudge.AddForward(3);

            Assert.That(Assert.Throws<InputException>(() => nudge.Result.ToString()).Message,
                Is.EqualTo(NudgeMessages.NoMark(isForward: false)));
        }

        [Test]
        public void Result_DirectionsSwapped_Throws()
        {
            var nudge = new NudgeCalibration(500, 40);
            nudge.AddForward(-30);
            nudge.AddBackward(30);

            Assert.That(Assert.Throws<InputException>(() => nudge.Result.ToString()).Message,
                Is.EqualTo(SettingMessages.OutOfRange("nudge: visualisation latency", -20, " ms", 0, 500)));
        }

        static readonly object[][] InvalidSettings =
        {
            new object[] { 0, 40, SettingMessages.OutOfRange(SettingNames.ToolSpeed, 0, " mm/s", 1, 10000) },
            new object[] { double.NaN, 40, SettingMessages.OutOfRange(SettingNames.ToolSpeed, double.NaN, " mm/s", 1, 10000) },
            new object[] { 500, -1, SettingMessages.OutOfRange("visualisation latency", -1, " ms", 0, 500) },
        };

        [TestCaseSource(nameof(InvalidSettings))]
        public void Constructor_InvalidSetting_ThrowsWithTheReason(double speedMmPerS, double usedVisuMs, string message)
        {
            Assert.That(Assert.Throws<InputException>(() => new NudgeCalibration(speedMmPerS, usedVisuMs)).Message, Is.EqualTo(message));
        }

        [TestCase(double.NaN)]
        [TestCase(-1001)]
        public void AddForward_InvalidOffset_Throws(double offsetMm)
        {
            Assert.Throws<InputException>(() => new NudgeCalibration(500, 40).AddForward(offsetMm));
        }
    }
}
