using System;
using System.Linq;
using Nowpose.Messages;
using Nowpose.Simulation;
using Nowpose.Sync;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Sync
{
    /// <summary>Tests the states of the clock, its steps, and the exchanges that it drops, with both estimators.</summary>
    [TestFixture(ClockEstimators.Default)]
    [TestFixture(ClockEstimators.Ransac)]
    public class ClockSynchroniserTests
    {
        readonly string _estimator;

        public ClockSynchroniserTests(string estimator) => _estimator = estimator;

        SyncRun NewRun() => new SyncRun(ClockEstimators.Create(_estimator));

        [Test]
        public void State_FromTheStart_PassesThroughAllStatesInOrder()
        {
            var run = NewRun();

            run.Run(new SimulatedLink(NetworkProfile.Wifi, 1, 40), 0, 10);

            var states = run.Instants.Select(i => i.Model.State).ToList();
            Assert.That(states.First(), Is.EqualTo(ClockState.Unsynchronised));
            Assert.That(states.Distinct(), Is.EqualTo(new[] { ClockState.Unsynchronised, ClockState.Converging, ClockState.Coarse, ClockState.Synchronised }));
            Assert.That(run.FirstAt(m => m.State == ClockState.Synchronised), Is.LessThan(5));
        }

        [TestCase("lan", 0, 0.2)]
        [TestCase("wifi", 0, 0.8)]
        [TestCase("busy-wifi", 0.02, 3)]
        public void State_Synchronised_ErrorIsBelowTheLimit(string network, double loss, double limitMs)
        {
            for (var seed = 0; seed < 12; seed++)
            {
                var run = NewRun();
                run.Run(new SimulatedLink(NetworkProfile.Named(network), seed, 40, 2, loss), 0, 20);

                var since = run.FirstAt(m => m.State == ClockState.Synchronised);
                Assert.That(run.PercentileMs(since, 1), Is.LessThan(limitMs), "seed " + seed);
            }
        }

        [Test]
        public void State_NoExchanges_IsHoldoverWithAGrowingValidBound()
        {
            var link = new SimulatedLink(NetworkProfile.Wifi, 2, -60, skewVariationPpm: 2);
            var run = NewRun();
            run.Run(link, 0, 60);
            var boundBefore = run.Instants.Last().Model.ErrorBound;

            run.Run(link, 60, 90, exchange: false);

            var last = run.Instants.Last();
            Assert.That(last.Model.State, Is.EqualTo(ClockState.Holdover));
            Assert.That(last.Model.ErrorBound, Is.GreaterThan(boundBefore));
            Assert.That(Math.Abs(last.ErrorMs), Is.LessThan(last.Model.ErrorBound.TotalMilliseconds).And.LessThan(1));

            run.Run(link, 90, 91);

            Assert.That(run.Instants.Last().Model.State, Is.EqualTo(ClockState.Synchronised), "one exchange ends the holdover");
        }

        [Test]
        public void Step_DuringSleepOfTheDevice_StateIsConvergingAfterWaking()
        {
            var link = new SimulatedLink(NetworkProfile.Wifi, 12, 20);
            var run = NewRun();
            run.Run(link, 0, 30);
            link.Step = TimeSpan.FromMilliseconds(100);

            run.Run(link, 120, 121);

            var awake = run.Instants.Where(i => i.At > 120.1).ToList();
            Assert.That(awake.All(i => Math.Abs(i.ErrorMs) <= i.Model.ErrorBound.TotalMilliseconds), Is.True);
            Assert.That(awake.First().Model.State, Is.EqualTo(ClockState.Converging));
        }

        [TestCase(50)]
        [TestCase(-50)]
        [TestCase(86_400_000)]
        public void ControlClock_Steps_SynchronisationRestartsWithinASecond(int stepMs)
        {
            var link = new SimulatedLink(NetworkProfile.Wifi, 3, 20);
            var run = NewRun();
            run.Run(link, 0, 30);

            link.Step = Lengths.Ms(stepMs);
            run.Run(link, 30, 60);

            Assert.That(run.Clock.Steps, Is.EqualTo(1));
            Assert.That(run.Instants.First(i => i.At > 30 && i.Model.State == ClockState.Converging).At, Is.LessThan(31));
            Assert.That(run.PercentileMs(31.5, 1), Is.LessThan(3));
            Assert.That(run.Instants.Last().Model.State, Is.EqualTo(ClockState.Synchronised));
        }

        [Test]
        public void Step_NotYetConfirmed_BoundIncludesTheStepAndTheStateIsConverging()
        {
            var link = new SimulatedLink(NetworkProfile.Lan, 5, 20);
            var run = NewRun();
            run.Run(link, 0, 30);

            link.Step = TimeSpan.FromMilliseconds(100);
            run.Run(link, 30, 32);

            var unconfirmed = run.Instants.Where(i => i.At > 30.45).ToList();
            var isBounded = unconfirmed.All(i => Math.Abs(i.ErrorMs) <= i.Model.ErrorBound.TotalMilliseconds);
            Assert.That(isBounded, Is.True, "two exchanges contradict the old offset by then");
            Assert.That(unconfirmed.First().Model.State, Is.EqualTo(ClockState.Converging));
        }

        [TestCase(200, 0.2)]
        [TestCase(-600, 0.2)]
        [TestCase(150, 2)]
        [TestCase(150, 10)]
        public void Steps_FastOrSlowClocks_AreZero(double skewPpm, double intervalSeconds)
        {
            foreach (var network in NetworkProfile.All)
            {
                var run = NewRun();
                run.Run(new SimulatedLink(network, 6, skewPpm, skewVariationPpm: 2), 0, 60 * intervalSeconds, intervalSeconds: intervalSeconds);

                Assert.That(run.Clock.Steps, Is.EqualTo(0), network.Name);
                Assert.That(run.Instants.Last().Model.IsKnown, Is.True);
            }
        }

        [Test]
        public void State_AfterALongSleep_ConvergesAgain()
        {
            var link = new SimulatedLink(NetworkProfile.Wifi, 8, 60, skewVariationPpm: 2);
            var run = NewRun();
            run.Run(link, 0, 30);

            run.Run(link, 3600, 3620);

            var awake = run.Instants.Where(i => i.At > 3600.3).ToList();
            Assert.That(awake.First().Model.State, Is.EqualTo(ClockState.Converging));
            Assert.That(awake.Last().Model.State, Is.EqualTo(ClockState.Synchronised));
            Assert.That(awake.Where(i => i.Model.State == ClockState.Synchronised).All(i => Math.Abs(i.ErrorMs) < 1), Is.True);
            Assert.That(run.Clock.Steps, Is.EqualTo(0));
        }

        [Test]
        public void Add_RandomTimes_KeepsTheModelValid()
        {
            var random = new Random(11);
            var clock = new ClockSynchroniser(ClockEstimators.Create(_estimator), ClockSettings.Default);
            var now = HeadsetTime.FromSeconds(0);
            for (var i = 0; i < 2000; i++)
            {
                now += Lengths.Seconds(random.NextDouble() < 0.02 ? 100 : 0.2);
                var control = ControlTime.FromNanoseconds((long)((2 * random.NextDouble() - 1) * long.MaxValue));
                clock.Add(new SyncExchange(now - TimeSpan.FromMilliseconds(2), control, control, now), out _);

                var model = clock.ModelAt(now + TimeSpan.FromSeconds(60));
                if (model.IsKnown) Assert.DoesNotThrow(() => model.ToControl(now + TimeSpan.FromSeconds(60)), "seed 11, exchange " + i);
            }
        }

        [Test]
        public void Add_OneOutlier_IsSetAsideAndTheOffsetIsUnchanged()
        {
            var link = new SimulatedLink(NetworkProfile.Wifi, 4, 20);
            var run = NewRun();
            run.Run(link, 0, 10);
            var before = run.Clock.ModelAt(HeadsetTime.FromSeconds(10.5));

            var at = HeadsetTime.FromSeconds(10.4);
            var wild = link.TrueOffset(at).ToControl(at) + TimeSpan.FromSeconds(5);
            var verdict = run.Clock.Add(new SyncExchange(at, wild, wild, at + TimeSpan.FromMilliseconds(3)), out _);

            var after = run.Clock.ModelAt(HeadsetTime.FromSeconds(10.5));
            Assert.That(verdict, Is.EqualTo(SyncVerdict.SetAside));
            Assert.That(after.ReferenceOffset, Is.EqualTo(before.ReferenceOffset));
        }

        [Test]
        public void IsStepSuspected_AfterAContradiction_RemainsUntilAnExchangeRefutesTheStep()
        {
            var run = NewRun();
            var link = new SimulatedLink(NetworkProfile.Lan, 7, 20);
            run.Run(link, 0, 20);

            Exchange(run, link, 20, stepMs: 20);
            Assert.That(run.Clock.IsStepSuspected, Is.True);
            Exchange(run, link, 20.2, stepMs: 0, longerMs: 50);
            Assert.That(run.Clock.IsStepSuspected, Is.True, "the round-trip time hides the step");
            Exchange(run, link, 20.4, stepMs: 0);
            Assert.That(run.Clock.IsStepSuspected, Is.False);
        }

        [TestCase(1, ClockState.Synchronised)]
        [TestCase(2, ClockState.Converging)]
        public void Model_ExchangesHideASuspectedStep_KeepsStateAndBoundUntilAnExchangeRefutesTheStep(int contradictions, ClockState state)
        {
            var run = NewRun();
            var link = new SimulatedLink(NetworkProfile.Lan, 7, 20);
            run.Run(link, 0, 20);
            for (var i = 0; i < contradictions; i++) Exchange(run, link, 20 + i * 0.2, stepMs: 10);

            for (var at = 21; at < 25; at++)
            {
                var model = Exchange(run, link, at, stepMs: 10, longerMs: 50);

                Assert.That(model.State, Is.EqualTo(state), at + " s");
                var errorMs = Math.Abs((model.ReferenceOffset - link.TrueOffset(model.Reference)).TotalMilliseconds);
                Assert.That(errorMs, Is.GreaterThan(9).And.LessThan(model.ErrorBound.TotalMilliseconds), at + " s");
                if (state == ClockState.Converging) Assert.That(model.EstimatedError.TotalMilliseconds, Is.GreaterThan(errorMs), at + " s");
            }

            var refuted = Exchange(run, link, 25, stepMs: 0);
            Assert.That(refuted.State, Is.EqualTo(ClockState.Synchronised));
            Assert.That(refuted.ErrorBound.TotalMilliseconds, Is.LessThan(1));
        }

        [Test]
        public void IsStepSuspected_StepIsHiddenForTenSeconds_IsFalseAndTheContradictionNoLongerCounts()
        {
            var run = NewRun();
            var link = new SimulatedLink(NetworkProfile.Lan, 7, 20);
            run.Run(link, 0, 20);
            Exchange(run, link, 20, stepMs: 20);

            for (var at = 21; at < 32; at++)
            {
                Exchange(run, link, at, stepMs: 0, longerMs: 50);
                Assert.That(run.Clock.IsStepSuspected, Is.EqualTo(at < 30), at + " s");
            }

            Exchange(run, link, 32, stepMs: 20);
            Exchange(run, link, 32.2, stepMs: 20);
            Assert.That(run.Clock.Steps, Is.EqualTo(0));
            Exchange(run, link, 32.4, stepMs: 20);
            Assert.That(run.Clock.Steps, Is.EqualTo(1));
        }

        static ClockModel Exchange(SyncRun run, SimulatedLink link, double atSeconds, double stepMs, double longerMs = 0)
        {
            (link.Step, link.LongerUpMs, link.LongerDownMs) = (Lengths.Ms(stepMs), longerMs, longerMs);
            link.TryExchange(HeadsetTime.FromSeconds(atSeconds), out var exchange);
            run.Clock.Add(exchange, out _);
            return run.Clock.ModelAt(exchange.T4);
        }

        [Test]
        public void Add_NotNewerThanTheLast_IsDroppedWithTheReason()
        {
            var clock = new ClockSynchroniser(ClockEstimators.Create(_estimator), ClockSettings.Default);
            var exchange = new SyncExchange(HeadsetTime.FromSeconds(1), default, default, HeadsetTime.FromSeconds(1.01));
            clock.Add(exchange, out _);

            var verdict = clock.Add(exchange, out var fault);

            Assert.That(verdict, Is.EqualTo(SyncVerdict.Dropped));
            Assert.That(fault, Is.EqualTo(SyncExchangeFault.NotNewer));
        }

        [Test]
        public void State_ServerIsNotSynchronised_StaysConverging()
        {
            var clock = new ClockSynchroniser(ClockEstimators.Create(_estimator), ClockSettings.Default);
            for (var i = 0; i < 50; i++)
            {
                var t = HeadsetTime.FromSeconds(i * 0.2);
                var at = new ControlTime(t.SinceEpoch);
                clock.Add(new SyncExchange(t, at, at, t + TimeSpan.FromMilliseconds(1), serverSynchronised: false), out _);
            }

            Assert.That(clock.ModelAt(HeadsetTime.FromSeconds(10)).State, Is.EqualTo(ClockState.Converging));
        }

        [Test]
        public void Settings_OutOfRange_NameValueUnitAndRange()
        {
            var error = Assert.Throws<InputException>(() => new ClockSettings(holdoverAfterSeconds: -1));

            Assert.That(error.Message, Is.EqualTo(SettingMessages.OutOfRange("holdover after", -1, " s", 0.1, 3600)));
        }
    }
}
