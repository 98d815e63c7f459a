using System;
using Nowpose.Latency;
using Nowpose.Latency.Load;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Latency
{
    public class FrameShareTests
    {
        const double ShareMs = 2;

        static TimeSpan Ms(double ms) => TimeSpan.FromTicks((long)(ms * TimeSpan.TicksPerMillisecond));

        // Executes steps of each kind in turn. Returns, for each frame, the working time in ms and the number of steps.
        static (double Ms, int Steps)[] Work(FrameShare share, Func<int, double> msOf, int kinds, int frames)
        {
            var done = new (double, int)[frames];
            var now = HeadsetTime.FromSeconds(100);
            var step = 0;
            for (var frame = 0; frame < frames; frame++)
            {
                var begin = now;
                share.BeginFrame(now);
                var before = step;
                for (; share.HasRoom(step % kinds, now); step++)
                {
                    var length = Ms(msOf(step));
                    now += length;
                    share.Took(step % kinds, length);
                }
                done[frame] = ((now - begin).TotalMilliseconds, step - before);
                now += Ms(16);
            }
            return done;
        }

        [Test]
        public void Frames_StepsOfSeveralKinds_UseTheShareWithoutExceedingIt()
        {
            double[] lengths = { 0.05, 0.4, 0.9, 0.3 };

            var frames = Work(new FrameShare(ShareMs, lengths.Length), step => lengths[step % lengths.Length], lengths.Length, 400);

            var used = 0.0;
            for (var i = 0; i < frames.Length; i++)
            {
                Assert.That(frames[i].Ms, Is.LessThanOrEqualTo(ShareMs), "frame " + i);
                if (i >= 200) used += frames[i].Ms / 200;
            }
            Assert.That(used, Is.GreaterThan(ShareMs / 2));
        }

        [Test]
        public void Frames_StepsOfVaryingLength_ExceedTheShareByAtMostTheVariation()
        {
            var random = new Random(4);

            var frames = Work(new FrameShare(ShareMs, 2), step => (step % 2 == 0 ? 0.1 : 0.6) * (0.8 + 0.4 * random.NextDouble()), 2, 2000);

            for (var i = 0; i < frames.Length; i++) Assert.That(frames[i].Ms, Is.LessThanOrEqualTo(ShareMs + 0.6 * 0.4), "seed 4, frame " + i);
        }

        [Test]
        public void Frames_StepLongerThanTheShare_RunsInAFrameOfItsOwn()
        {
            var frames = Work(new FrameShare(ShareMs, 2), step => step % 2 == 0 ? 0.5 : 5, 2, 100);

            foreach (var frame in frames)
            {
                Assert.That(frame.Steps, Is.GreaterThanOrEqualTo(1), "each frame runs at least one step");
                Assert.That(frame.Ms, Is.LessThanOrEqualTo(5));
            }
        }

        [Test]
        public void Frames_OneSlowStep_LaterFramesUseTheWholeShareAgain()
        {
            var frames = Work(new FrameShare(ShareMs, 1), step => step == 0 ? 30 : 0.1, 1, 200);

            Assert.That(frames[199].Steps, Is.InRange(19, 20));
        }

        [TestCase(0)]
        [TestCase(double.NaN)]
        [TestCase(101)]
        public void Share_OutOfRange_ThrowsWithTheAllowedRange(double ms) => Assert.That(
            () => new FrameShare(ms, 1), Throws.TypeOf<InputException>().With.Message.Contains("0.1 to 100 ms"));
    }
}
