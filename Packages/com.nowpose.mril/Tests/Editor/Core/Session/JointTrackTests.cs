using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Kinematics;
using Nowpose.Prediction;
using Nowpose.Protocol;
using Nowpose.Session;
using NUnit.Framework;

namespace Nowpose.Tests
{
    public class JointTrackTests
    {
        const double Interval = 0.02;
        const int Newest = 100;

        static double PositionAt(double time) => Math.Sin(2 * time);

        static JointSample Sample(double time) => new JointSample(time, PositionAt(time));

        static JointTrack NewTrack(string predictor = "quadratic-h4") =>
            new JointTrack(new PredictionSettings(predictor, blendMs: 0), JointLimits.None);

        // Up to two seconds, in order.
        static JointTrack FedTrack()
        {
            var track = NewTrack();
            for (var i = 0; i <= Newest; i++) track.Add(Sample(i * Interval), out _);
            return track;
        }

        static (SampleOutcome Outcome, DropCounters Useless) Add(JointTrack track, JointSample sample)
        {
            var drops = new DropCounters();
            var outcome = track.Add(sample, out var useless);
            useless.CountIn(drops);
            return (outcome, drops);
        }

        [TestCase(1, 3, 2, 4)]
        [TestCase(4, 1, 2, 3, 5)]
        [TestCase(5, 1, 2, 3, 4, 6)]
        [TestCase(4, 3, 2, 1, 5)]
        [TestCase(6, 2, 5, 1, 4, 3, 7)]
        public void Add_SamplesOvertaken_PredictAsInOrder(params int[] order)
        {
            JointTrack shuffled = FedTrack(), inOrder = FedTrack();

            foreach (var i in order)
            {
                shuffled.Add(Sample((Newest + i) * Interval), out _);
                Assert.That(shuffled.HasStartedAnew, Is.False, "at " + i);
            }
            foreach (var i in order.OrderBy(i => i)) inOrder.Add(Sample((Newest + i) * Interval), out _);

            var time = (Newest + order.Max() + 4) * Interval;
            Assert.That(shuffled.At(time).Position, Is.EqualTo(inOrder.At(time).Position).Within(1e-12));
            Assert.That(shuffled.NewestTime, Is.EqualTo(inOrder.NewestTime));
        }

        [TestCase(3600, 2)]
        [TestCase(1, 2)]
        [TestCase(0.45, 2)]
        [TestCase(0.13, 2)]
        [TestCase(0.12, 2, TestName = "Add_ClockWentBackByWholeIntervals_IsFollowed")]
        public void Add_ClockWentBack_IsFollowedWithinAFewSamples(double seconds, int samples)
        {
            var track = FedTrack();
            var needed = 0;

            // Where the joint is goes on; only its stamps are less.
            for (var i = 1; !track.HasStartedAnew && i < 10; i++, needed++)
                track.Add(new JointSample((Newest + i) * Interval - seconds, PositionAt((Newest + i) * Interval)), out _);

            Assert.That(needed, Is.EqualTo(samples));
            var now = (Newest + needed) * Interval;
            Assert.That(track.NewestTime, Is.EqualTo(now - seconds));
            Assert.That(track.Hold, Is.EqualTo(PositionAt(now)));
            Assert.That(
                track.At(now - seconds + Interval).Position, Is.EqualTo(PositionAt(now + Interval)).Within(2e-3), "a straight line through two");
        }

        [TestCase(3600, 2)]
        [TestCase(0.45, 2)]
        [TestCase(0.13, 5)]
        public void Add_ClockWentBackWhileTheJointRests_IsFollowedWithinAFewSamples(double seconds, int samples)
        {
            var track = NewTrack();
            for (var i = 0; i <= Newest; i++) track.Add(new JointSample(i * Interval, 0.5), out _);
            var needed = 0;

            for (var i = 1; !track.HasStartedAnew && i < 10; i++, needed++)
                track.Add(new JointSample((Newest + i) * Interval - seconds, 0.5), out _);

            Assert.That(needed, Is.EqualTo(samples));
        }

        [Test]
        public void Add_ClockWentBackBehindAnOvertakenSample_IsFollowed()
        {
            var track = FedTrack();
            track.Add(Sample((Newest - 0.5) * Interval), out _);

            for (var i = 1; i <= 2; i++) track.Add(new JointSample(i * Interval - 50, 0.1 * i), out _);

            Assert.That(track.HasStartedAnew, Is.True);
            Assert.That(track.NewestTime, Is.EqualTo(2 * Interval - 50));
        }

        [Test]
        public void Add_SamplesSentAgain_AreDuplicatesHoweverMany()
        {
            var track = FedTrack();
            var before = track.At((Newest + 5) * Interval).Position;

            for (var i = Newest - 60; i <= Newest; i++)
            {
                Assert.That(track.Add(Sample(i * Interval), out _), Is.EqualTo(SampleOutcome.Duplicate), "sample " + i);
                Assert.That(track.HasStartedAnew, Is.False, "sample " + i);
            }

            Assert.That(track.At((Newest + 5) * Interval).Position, Is.EqualTo(before));
        }

        [Test]
        public void Add_WaitingSampleSentAgain_IsADuplicate()
        {
            var track = NewTrack();
            track.Add(Sample(1), out _);
            track.Add(Sample(0.9), out _);

            Assert.That(track.Add(Sample(0.9), out _), Is.EqualTo(SampleOutcome.Duplicate));
        }

        [Test]
        public void Add_SampleOfLongAgo_IsForgottenWhenANewerOneComes()
        {
            var track = FedTrack();
            var inOrder = FedTrack();
            Assert.That(Add(track, Sample(-20)).Outcome, Is.EqualTo(SampleOutcome.Late));

            var (outcome, useless) = Add(track, Sample((Newest + 1) * Interval));

            inOrder.Add(Sample((Newest + 1) * Interval), out _);
            Assert.That(outcome, Is.EqualTo(SampleOutcome.Accepted));
            Assert.That(useless[DropReason.LateSample], Is.EqualTo(1));
            Assert.That(useless.Total, Is.EqualTo(1));
            Assert.That(track.At(2.1).Position, Is.EqualTo(inOrder.At(2.1).Position));
        }

        [Test]
        public void Add_TwoSourcesOfWhichOneLags_NeverStartsAnew()
        {
            var track = FedTrack();
            for (var i = 1; i <= 500; i++)
            {
                track.Add(Sample((Newest + i) * Interval), out _);
                track.Add(Sample((Newest + i) * Interval - 0.33 * Interval - 0.4), out _);
                Assert.That(track.HasStartedAnew, Is.False, "sample " + i);
            }
        }

        [TestCase(0.02)]
        [TestCase(0.01)]
        public void Add_DelaysOfAWirelessNetwork_NeverStartAnewAndKeepEverySample(double interval)
        {
            const int seed = 41;
            var random = new Random(seed);
            var track = NewTrack("quadratic-h4");
            var arrivals = new List<(double At, double Stamp)>();
            for (var i = 0; i < 10_000; i++)
            {
                var normal = Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())) * Math.Cos(2 * Math.PI * random.NextDouble());
                arrivals.Add((i * interval + Math.Min(0.120, 0.012 * Math.Exp(normal)), i * interval));
            }
            var (late, restarts) = (0, 0);

            foreach (var (_, stamp) in arrivals.OrderBy(a => a.At))
            {
                if (track.Add(Sample(stamp), out _) == SampleOutcome.Late) late++;
                if (track.HasStartedAnew) restarts++;
            }

            Assert.That(late, Is.GreaterThan(500), "samples overtake each other, seed " + seed);
            Assert.That(restarts, Is.EqualTo(0), "seed " + seed);
        }
    }
}
