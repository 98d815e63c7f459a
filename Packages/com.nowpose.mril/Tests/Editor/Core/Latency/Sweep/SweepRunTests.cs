using System;
using Nowpose.Latency;
using Nowpose.Latency.Sweep;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Latency.Sweep
{
    public class SweepRunTests
    {
        const double Frame = 1 / 60.0;

        static readonly SweepPlan Plan = new SweepPlan(1000, 2, 1, 0.5, goesDown: false);

        static HeadsetTime At(double seconds) => HeadsetTime.FromSeconds(seconds);

        [Test]
        public void Advance_AllLoads_ShowsEachLoadForTheSameTime()
        {
            var run = new SweepRun(Plan);
            var frames = new int[3];

            for (var t = 0.0; !run.IsDone; t += Frame)
            {
                frames[run.Index]++;
                Assert.That(run.Vertices, Is.EqualTo(Plan.Loads[run.Index]));
                run.Advance(At(t), isReady: true);
            }

            Assert.That(frames, Has.All.InRange(91, 92), "1.5 s at 60 Hz, the last frame included");
            Assert.That(run.Vertices, Is.Zero);
        }

        [Test]
        public void Advance_FramesBeforeReady_DoNotCount()
        {
            var run = new SweepRun(Plan);
            for (var t = 0.0; t < 100; t += Frame) run.Advance(At(t), isReady: false);

            Assert.That(run.Advance(At(100), isReady: true), Is.False);
            Assert.That(run.Advance(At(101.49), isReady: true), Is.False);
            Assert.That(run.Advance(At(101.5), isReady: true), Is.True);
            Assert.That(run.Vertices, Is.EqualTo(500));
        }

        [Test]
        public void Advance_LoadInterrupted_RestartsTheTimeOfTheLoad()
        {
            var run = new SweepRun(Plan);
            run.Advance(At(0), isReady: true);
            run.Advance(At(1), isReady: false);
            run.Advance(At(1.1), isReady: true);

            Assert.That(run.Advance(At(2), isReady: true), Is.False);
            Assert.That(run.Advance(At(2.6), isReady: true), Is.True);
        }

        [Test]
        public void Advance_AfterTheEnd_StaysDone()
        {
            var run = new SweepRun(Plan);
            for (var t = 0.0; !run.IsDone; t += 1) run.Advance(At(t), isReady: true);

            Assert.That(run.Advance(At(1000), isReady: true), Is.False);
            Assert.That(run.Index, Is.EqualTo(3));
        }

        [Test]
        public void Constructor_NoPlan_Throws() => Assert.That(() => new SweepRun(null), Throws.TypeOf<ArgumentNullException>());
    }
}
