using System;
using System.Collections.Generic;
using NUnit.Framework;
using Nowpose.Protocol;
using Nowpose.Signals;

namespace Nowpose.Tests.Core.Signals
{
    public class SignalTableTests
    {
        const double FrameSeconds = 1 / 60.0;
        const double Visu = 0.04;

        static ControlTime At(double seconds) => ControlTime.FromSeconds(1000 + seconds);

        [TestCase(-0.2)]
        [TestCase(0)]
        [TestCase(0.03)]
        [TestCase(0.1)]
        [TestCase(0.25)]
        public void Changed_AnyLatency_IsRaisedInTheFirstFrameDisplayedAtOrAfterTheStamp(double latency)
        {
            var table = new SignalTable();
            var seen = new List<(double Light, double Value)>();
            var light = 0.0;
            table.Changed += signal => seen.Add((light, signal.Value));
            double[] stamps = { 0.5, 0.93, 1.31, 1.32, 1.8 };
            var sent = 0;

            for (var frame = 0; frame < 150; frame++)
            {
                var now = frame * FrameSeconds;
                for (; sent < stamps.Length && stamps[sent] + latency <= now; sent++) table.FindOrAdd("grip").Add(At(stamps[sent]), (sent + 1) % 2);
                light = now + Visu;
                table.Evaluate(At(light));
            }

            Assert.That(seen, Has.Count.EqualTo(stamps.Length));
            for (var i = 0; i < stamps.Length; i++)
            {
                Assert.That(seen[i].Value, Is.EqualTo((i + 1) % 2));
                // A late message becomes visible in the first frame that starts after its arrival.
                var possible = Math.Max(stamps[i], stamps[i] + latency + Visu);
                Assert.That(seen[i].Light - possible, Is.InRange(-1e-9, FrameSeconds + 1e-9), "change " + i);
            }
        }

        [Test]
        public void Add_MoreSignalsThanAllowed_IsRefused()
        {
            var table = new SignalTable();
            for (var i = 0; i < ProtocolLimits.Signals; i++)
                Assert.That(table.FindOrAdd("s" + i).Add(At(0), i), Is.EqualTo(DropReason.None));

            Assert.That(table.FindOrAdd("one more"), Is.Null);
            Assert.That(table.FindOrAdd("s7").Add(At(1), 1), Is.EqualTo(DropReason.None), "a known signal is still accepted");
            Assert.That(table.Count, Is.EqualTo(ProtocolLimits.Signals));
        }

        [Test]
        public void Restart_SourceWithEarlierStamps_KeepsTheValueUntilTheNextValue()
        {
            var table = new SignalTable();
            table.FindOrAdd("grip").Add(At(1000), 1);
            table.Evaluate(At(1000));

            table.Restart();
            table.Evaluate(At(3));

            var grip = table.Find("grip");
            Assert.That((grip.Value, grip.Since), Is.EqualTo((1.0, (ControlTime?)null)));
            table.FindOrAdd("grip").Add(At(5), 0);
            table.Evaluate(At(4));
            Assert.That(grip.Value, Is.EqualTo(1));
            table.Evaluate(At(5));
            Assert.That((grip.Value, grip.Since), Is.EqualTo((0.0, (ControlTime?)At(5))));
        }

        [Test]
        public void Restart_ChangeNotYetVisible_BecomesVisible()
        {
            var table = new SignalTable();
            var seen = new List<double>();
            table.Changed += signal => seen.Add(signal.Value);
            table.FindOrAdd("grip").Add(At(1000), 1);
            table.Evaluate(At(1000));
            table.FindOrAdd("grip").Add(At(1010), 0);

            table.Restart();
            table.Evaluate(At(3));

            Assert.That(seen, Is.EqualTo(new[] { 1.0, 0.0 }));
        }

        [Test]
        public void Restart_VisibleValue_IsReportedWithoutATime()
        {
            var table = new SignalTable();
            var seen = new List<(double Value, ControlTime? Since)>();
            table.Restarted += signal => seen.Add((signal.Value, signal.Since));
            table.FindOrAdd("grip").Add(At(1000), 1);
            table.Evaluate(At(1000));

            table.Restart();

            Assert.That(seen, Is.EqualTo(new[] { (1.0, (ControlTime?)null) }));
        }

        [Test]
        public void Restart_NeverReceived_StaysUnknown()
        {
            var track = new SignalTrack("grip");

            track.Restart();

            Assert.That(track.IsKnown, Is.False);
        }
    }
}
