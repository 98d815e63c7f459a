using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Protocol;
using Nowpose.Simulation;
using Nowpose.Sync;
using NUnit.Framework;

namespace Nowpose.Tests
{
    public class ExchangePaceTests
    {
        static readonly TimeSpan Usual = TimeSpan.FromMilliseconds(200);

        /// <summary>Exchanges as the client does: the next when the pace says so, but not before the last one has ended.</summary>
        sealed class PacedRun
        {
            readonly ExchangePace _pace;
            double _now;

            public PacedRun(double usualMs = 200) => _pace = new ExchangePace(Lengths.Ms(usualMs), TimeSpan.FromSeconds(2));

            public ClockSynchroniser Clock { get; } = new ClockSynchroniser(new EnvelopeClockEstimator(), ClockSettings.Default);
            public List<(double At, double PauseMs)> Exchanges { get; } = new List<(double, double)>();
            public List<(double At, double ErrorMs)> Errors { get; } = new List<(double, double)>();

            public void Run(SimulatedLink link, double until)
            {
                while (_now < until)
                {
                    var start = HeadsetTime.FromSeconds(_now);
                    while (!link.TryExchange(start, out _)) start += Usual;
                    link.TryExchange(start, out var exchange);
                    Clock.Add(exchange, out _);
                    var pause = _pace.Next(Clock, exchange.T4);
                    Exchanges.Add((_now, pause.TotalMilliseconds));
                    var next = Math.Max((start + pause).SinceEpoch.TotalSeconds, exchange.T4.SinceEpoch.TotalSeconds);
                    for (var s = exchange.T4.SinceEpoch.TotalSeconds; s < next; s += 0.05)
                    {
                        var at = HeadsetTime.FromSeconds(s);
                        Errors.Add((s, (Clock.ModelAt(at).OffsetAt(at) - link.TrueOffset(at)).TotalMilliseconds));
                    }
                    _now = next;
                }
            }

            public void Sleep(double until) => _now = until;

            public IEnumerable<double> Pauses(double from, double to) => Exchanges.Where(e => e.At >= from && e.At < to).Select(e => e.PauseMs);

            public double P95Ms(double from)
            {
                var sorted = Errors.Where(e => e.At >= from).Select(e => Math.Abs(e.ErrorMs)).OrderBy(e => e).ToArray();
                return sorted[(int)(0.95 * (sorted.Length - 1))];
            }
        }

        static SimulatedLink Link(string network, int seed = 400) => new SimulatedLink(NetworkProfile.Named(network), seed, 35, 2, driftPeriod: 400);

        [Test]
        public void Next_QuietNetwork_IsQuickAtTheStartAndSlowWhenSettled()
        {
            var run = new PacedRun();

            run.Run(Link("lan"), 120);

            Assert.That(run.Pauses(0, 4.9), Is.All.EqualTo(50));
            Assert.That(run.Pauses(60, 120).Average(), Is.GreaterThan(700), "most of them 1000 ms");
            Assert.That(run.P95Ms(10), Is.LessThan(0.03), "and no target is missed for it; seed 400");
        }

        [TestCase("wifi", 0.05)]
        [TestCase("busy-wifi", 0.12)]
        public void Next_Wifi_StaysAtTheUsualPaceForMoreDoesHelp(string network, double limitMs)
        {
            var run = new PacedRun();

            run.Run(Link(network), 200);

            Assert.That(run.Pauses(0, 4), Is.All.EqualTo(50));
            Assert.That(run.Pauses(30, 200).Average(), Is.EqualTo(200).Within(20));
            Assert.That(run.P95Ms(10), Is.LessThan(limitMs), "seed 400");
        }

        [Test]
        public void Next_AfterAStep_IsQuickAgain()
        {
            var link = Link("lan");
            var run = new PacedRun();
            run.Run(link, 120);

            link.Step = TimeSpan.FromMilliseconds(2);
            run.Run(link, 125);

            Assert.That(run.Clock.Steps, Is.EqualTo(1), "within five seconds, though one exchange a second was enough before");
            Assert.That(run.Pauses(122, 125), Is.All.EqualTo(50));
        }

        [Test]
        public void Next_AfterASilence_IsQuickForAWhile()
        {
            var link = Link("wifi");
            var run = new PacedRun();
            run.Run(link, 60);

            run.Sleep(90);
            run.Run(link, 100);

            Assert.That(run.Pauses(90, 91), Is.All.EqualTo(50));
            Assert.That(run.Pauses(95, 100), Is.All.EqualTo(200));
        }

        [Test]
        public void Next_SlowerSetting_IsNeverTakenForASilence()
        {
            var run = new PacedRun(usualMs: 500);

            run.Run(Link("lan"), 120);

            Assert.That(run.Pauses(60, 120).Average(), Is.GreaterThan(700), "slow, for it is settled");
            Assert.That(run.Pauses(0, 120).Max(), Is.LessThanOrEqualTo(ClockSettings.Default.HoldoverAfter.TotalMilliseconds / 2));
        }

        [TestCase(20)]
        [TestCase(200)]
        [TestCase(10_000)]
        public void Next_WhateverIsSet_TheServerBearsIt(double usualMs)
        {
            var run = new PacedRun(usualMs);

            run.Run(Link("lan"), 60 * usualMs / 200);

            var pauses = run.Pauses(0, double.MaxValue).ToArray();
            Assert.That(pauses.Min(), Is.GreaterThanOrEqualTo(2 * 1000.0 / ProtocolLimits.SyncRequestsPerSecond));
            Assert.That(pauses.Max(), Is.LessThan(ProtocolLimits.SyncSilence.TotalMilliseconds / 2));
        }
    }
}
