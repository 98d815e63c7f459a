using System;
using System.Linq;
using Nowpose.Latency;
using Nowpose.Messages;
using Nowpose.Simulation;
using NUnit.Framework;
using static Nowpose.Tests.Core.Latency.MonitoredDisplay;

namespace Nowpose.Tests.Core.Latency
{
    public class ConstantLatencyMonitorTests
    {
        // Returns the numbers of frames until the state is outside, at most 60, for 1000 seeds. The numbers are in ascending order.
        static int[] FramesToLeave(double renderMs) => Enumerable.Range(1, 1000).Select(seed =>
        {
            var monitor = Monitor();
            var display = new DisplayPipeline(seed);
            for (var frame = 0; frame < 30; frame++) Add(monitor, display.Next(700_000).RenderTime.TotalMilliseconds);
            Assert.That(monitor.State, Is.EqualTo(RangeState.Inside), "seed " + seed);
            var frames = 0;
            for (; monitor.State != RangeState.Outside && frames < 60; frames++)
                Add(monitor, display.Next(Display.VerticesOf(renderMs)).RenderTime.TotalMilliseconds);
            return frames;
        }).OrderBy(frames => frames).ToArray();

        [Test]
        public void Add_LoadTenPercentAboveTheLimit_IsDetectedWithinTenFrames([Values(1.1, 1.2, 2)] double ofLimit)
        {
            var frames = FramesToLeave(ofLimit * Limit);

            Assert.That(frames.Last(), Is.InRange(2, 10));
        }

        // The render times scatter by 3 %, so some frames of this load are below the limit. Each such frame delays the detection by a frame.
        [TestCase(1.06, 0.99, 12)]
        [TestCase(1.05, 0.95, 16)]
        [TestCase(1.02, 0.4, 40)]
        public void Add_LoadJustAboveTheLimit_IsUsuallyDetectedWithinTenFrames(double ofLimit, double within10, int maxFrames)
        {
            var frames = FramesToLeave(ofLimit * Limit);

            Assert.That(frames.Count(each => each <= 10) / (double)frames.Length, Is.GreaterThanOrEqualTo(within10));
            Assert.That(frames.Last(), Is.LessThanOrEqualTo(maxFrames));
        }

        [Test]
        public void Add_LoadWellBelowTheLimit_RaisesAlmostNoFalseAlarms()
        {
            var alarms = Seeds.Select(seed => FlipsPerMinute(0.9 * Limit, seed, 3)).ToArray();

            Assert.That(alarms.Average(a => a.Monitor), Is.LessThanOrEqualTo(0.1));
            Assert.That(alarms.Average(a => a.SingleFrame), Is.GreaterThan(30), "single frames exceed the limit");
        }

        [Test]
        public void Add_LoadAtTheLimit_ChangesStateAtMostTwicePerMinute()
        {
            var flips = Seeds.Select(seed => FlipsPerMinute(Limit, seed, 3)).ToArray();

            Assert.That(flips.Average(f => f.Monitor), Is.LessThanOrEqualTo(2));
            Assert.That(flips.Average(f => f.SingleFrame), Is.GreaterThan(1500), "single frames exceed the limit about every second frame");
        }

        [Category("Study")]
        [Test]
        public void Add_LoadJustBelowTheLimit_ChangesStateAtMostTwicePerMinute([Values(0.94, 0.95, 0.96, 0.97, 0.98)] double ofLimit)
        {
            var flips = Seeds.Select(seed => FlipsPerMinute(ofLimit * Limit, seed, 3)).ToArray();

            Assert.That(flips.Average(f => f.Monitor), Is.LessThanOrEqualTo(2));
            Assert.That(flips.Average(f => f.SingleFrame), Is.GreaterThan(60), "a decision by single frames changes the state often");
        }

        [Test]
        public void Add_AlternatingLoad_AgreesWithTheLatencyOfTheDisplay()
        {
            var monitor = Monitor();
            var display = new DisplayPipeline(1);
            var (longer, wrong) = (0, 0);
            const int frames = 36_000;
            for (var frame = 0; frame < frames; frame++)
            {
                var shown = display.Next(frame / 300 % 2 == 0 ? 700_000 : 1_600_000);
                Add(monitor, shown.RenderTime.TotalMilliseconds);
                var isLonger = shown.Visualisation.TotalMilliseconds > Display.PlateauMs + 1;
                if (isLonger) longer++;
                if (isLonger != (monitor.State == RangeState.Outside)) wrong++;
            }

            Assert.That(longer, Is.EqualTo(frames / 2).Within(frames / 20), "half of the frames have a longer latency");
            Assert.That(wrong, Is.LessThan(0.15 * frames), "38 of 300 frames until inside, 8 until outside, and single slow frames");
        }

        [TestCase(9.3, 37, true, TestName = "Add_ClearlyInsideForThirtyFrames_IsInsideAgain")]
        [TestCase(9.3, 36, false, TestName = "Add_ClearlyInsideForTwentyNineFrames_IsStillOutside")]
        [TestCase(9.5, 2000, false, TestName = "Add_JustInsideForALongTime_IsStillOutside")]
        public void Add_AfterTheLoadFell_HasTheExpectedState(double renderMs, int frames, bool isInside)
        {
            var monitor = Monitor(10);
            Add(monitor, 20, 100);

            Add(monitor, renderMs, frames);

            Assert.That(monitor.State, Is.EqualTo(isInside ? RangeState.Inside : RangeState.Outside), "the median falls after 7 frames");
        }

        [Test]
        public void Add_FastFramesInterrupted_RestartsTheCount()
        {
            var monitor = Monitor(10);
            Add(monitor, 20, 100);
            Add(monitor, 9, 20);
            Add(monitor, 9.5, 8);
            Add(monitor, 9, 36);
            var before = monitor.State;

            Add(monitor, 9);

            Assert.That(before, Is.EqualTo(RangeState.Outside));
            Assert.That(monitor.State, Is.EqualTo(RangeState.Inside));
        }

        [TestCase(0)]
        [TestCase(-3)]
        public void Add_InvalidMeasurement_IsIgnored(double renderMs)
        {
            var monitor = Monitor();

            Add(monitor, renderMs, 100);

            Assert.That(monitor.State, Is.EqualTo(RangeState.Unknown));
            Assert.That(monitor.RenderTime, Is.Null);
        }

        [Test]
        public void Range_ChangedWhileRunning_AppliesFromTheNextFrame()
        {
            var monitor = Monitor(10);
            Add(monitor, 12, 100);
            var before = monitor.State;
            monitor.Range = new ConstantLatencyRange(15, Source);
            var (between, reason) = (monitor.State, monitor.UnknownReason);

            Add(monitor, 12);

            Assert.That(before, Is.EqualTo(RangeState.Outside));
            Assert.That(between, Is.EqualTo(RangeState.Unknown));
            Assert.That(reason, Is.EqualTo(RangeUnknownReason.TooFewFrames));
            Assert.That(monitor.State, Is.EqualTo(RangeState.Inside));
        }

        [TestCase(0)]
        [TestCase(double.NaN)]
        public void ConstantLatencyRange_InvalidLimit_ThrowsWithValueAndRange(double limitMs)
        {
            Assert.That(
                Assert.Throws<InputException>(() => new ConstantLatencyRange(limitMs, RenderTimeSourceKind.DisplayGpuTime)).Message,
                Is.EqualTo(SettingMessages.OutOfRange("render time limit", limitMs, " ms", 0.1, 1000)));
        }

        [Test]
        public void ConstantLatencyRange_NoSource_Throws()
        {
            Assert.That(
                Assert.Throws<InputException>(() => new ConstantLatencyRange(15, RenderTimeSourceKind.None)).Message,
                Is.EqualTo(ProfileMessages.LimitWithoutSource));
        }
    }
}
