using System;
using System.Linq;
using Nowpose.Protocol;
using Nowpose.Simulation;
using Nowpose.Sync;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Sync
{
    public class ExchangePaceTests
    {
        static SimulatedLink Link(string network, int seed = 400) => new SimulatedLink(NetworkProfile.Named(network), seed, 35, 2, skewPeriod: 400);

        [Test]
        public void Next_QuietNetwork_IsFastAtTheStartAndSlowWhenSettled()
        {
            var run = new PacedRun();

            run.Run(Link("lan"), 120);

            Assert.That(run.Pauses(0, 4.9), Is.Not.Empty.And.All.EqualTo(50));
            Assert.That(run.Pauses(60, 120).Average(), Is.GreaterThan(700), "most pauses are 1000 ms");
            Assert.That(run.P95Ms(10), Is.LessThan(0.03), "the slow pace does not impair the accuracy; seed 400");
        }

        [TestCase("wifi", 0.05)]
        [TestCase("busy-wifi", 0.12)]
        public void Next_Wifi_StaysAtTheConfiguredPace(string network, double limitMs)
        {
            var run = new PacedRun();

            run.Run(Link(network), 200);

            Assert.That(run.Pauses(0, 4), Is.All.EqualTo(50));
            Assert.That(run.Pauses(30, 200).Average(), Is.EqualTo(200).Within(20));
            Assert.That(run.P95Ms(10), Is.LessThan(limitMs), "seed 400");
        }

        [Test]
        public void Next_ConstantPace_IsTheConfiguredIntervalFromTheStart()
        {
            var clock = new ClockSynchroniser(ClockEstimators.Create(ClockEstimators.Default), ClockSettings.Default);
            var pace = new ExchangePace(TimeSpan.FromMilliseconds(200), TimeSpan.FromSeconds(2), new Random(1), isConstant: true);

            foreach (var second in new[] { 0, 1, 60, 200 })
                Assert.That(pace.Next(clock, HeadsetTime.FromSeconds(second)), Is.EqualTo(TimeSpan.FromMilliseconds(200)));
        }

        [Test]
        public void Next_AfterAStep_IsFastAgain()
        {
            var link = Link("lan");
            var run = new PacedRun();
            run.Run(link, 120);

            link.Step = TimeSpan.FromMilliseconds(2);
            run.Run(link, 125);

            Assert.That(run.Clock.Steps, Is.EqualTo(1), "the step is detected within five seconds although the pace was one exchange per second");
            Assert.That(run.Pauses(122, 125), Is.All.EqualTo(50));
        }

        [TestCase(400)]
        [TestCase(401)]
        [TestCase(402)]
        public void Next_SlowPaceNotAllowed_FindsAStepInHalfASecond(int seed)
        {
            var link = Link("lan", seed);
            var run = new PacedRun(maySlow: false);
            run.Run(link, 120);

            link.Step = TimeSpan.FromMilliseconds(100);
            run.Run(link, 121);

            Assert.That(run.Pauses(10, 120).Max(), Is.EqualTo(200));
            Assert.That(run.Errors.FindAll(e => e.At > 120.5).ConvertAll(e => Math.Abs(e.ErrorMs)), Is.Not.Empty.And.All.LessThan(1), $"seed {seed}");
        }

        [Test]
        public void Next_AfterAPauseWithoutExchanges_IsFastForAWhile()
        {
            var link = Link("wifi");
            var run = new PacedRun();
            run.Run(link, 60);

            run.Sleep(90);
            run.Run(link, 100);

            Assert.That(run.Pauses(90, 91), Is.Not.Empty.And.All.EqualTo(50));
            Assert.That(run.Pauses(95, 100), Is.Not.Empty.And.All.EqualTo(200));
        }

        [Test]
        public void Next_LongConfiguredInterval_IsNotTreatedAsAPause()
        {
            var run = new PacedRun(configuredMs: 500);

            run.Run(Link("lan"), 120);

            Assert.That(run.Pauses(60, 120).Average(), Is.GreaterThan(700), "the pace is slow because the clock has settled");
            Assert.That(run.Pauses(0, 120).Max(), Is.LessThanOrEqualTo(ClockSettings.Default.HoldoverAfter.TotalMilliseconds / 2));
        }

        [TestCase(20)]
        [TestCase(200)]
        [TestCase(10_000)]
        public void Next_AnyConfiguredInterval_StaysWithinTheServersRateLimit(double configuredMs)
        {
            var run = new PacedRun(configuredMs);

            run.Run(Link("lan"), 60 * configuredMs / 200);

            var pauses = run.Pauses(0, double.MaxValue).ToArray();
            Assert.That(pauses.Min(), Is.GreaterThanOrEqualTo(2 * 1000.0 / ProtocolLimits.SyncRequestsPerSecond));
            Assert.That(pauses.Max(), Is.LessThan(ProtocolLimits.SyncSilence.TotalMilliseconds / 2));
        }

        [TestCase(1)]
        [TestCase(10)]
        public void Next_CoarseControlClock_SpreadsExchangesOverItsCycle(double resolutionMs)
        {
            var link = Link("lan");
            link.Resolution = Lengths.Ms(resolutionMs);
            var run = new PacedRun();

            run.Run(link, 4);

            var parts = run.Exchanges.Select(e => e.At * 1000 % resolutionMs / resolutionMs).ToArray();
            for (var quarter = 0; quarter < 4; quarter++)
                Assert.That(parts.Count(p => (int)(4 * p) == quarter), Is.GreaterThan(parts.Length / 10), "quarter " + quarter);
            Assert.That(run.Pauses(0.1, 4), Is.Not.Empty.And.All.InRange(50, 50 + resolutionMs));
        }

        [Test]
        public void Next_ImplausibleResolutionOfTheServer_IsStillFast()
        {
            var link = Link("lan");
            link.Resolution = TimeSpan.FromSeconds(4);
            var run = new PacedRun();

            run.Run(link, 4);

            Assert.That(run.Pauses(0, 4), Is.Not.Empty.And.All.InRange(50, 100));
        }
    }
}
