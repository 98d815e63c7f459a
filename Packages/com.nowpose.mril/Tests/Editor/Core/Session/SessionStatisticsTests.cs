using System;
using System.Linq;
using MathNet.Numerics.Statistics;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Session;
using Nowpose.Simulation;
using Nowpose.Sync;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Session
{
    /// <summary>Tests the values that a session reports about its clock, latency and samples.</summary>
    public class SessionStatisticsTests
    {
        const int Seed = 7;

        [Test]
        public void Statistics_WholeSession_MeasureTheSimulatedLatency()
        {
            var simulated = new SimulatedSession(NetworkProfile.Lan, Seed);
            simulated.Run(20);
            var arrived = simulated.TrueLatenciesMs.Take((int)simulated.Session.Statistics(default).Samples).ToList();
            var recent = arrived.Skip(arrived.Count - 200).ToArray();

            var statistics = simulated.Session.Statistics(HeadsetTime.FromSeconds(simulated.Now));

            Assert.That(statistics.Clock.State, Is.EqualTo(ClockState.Synchronised));
            Assert.That(statistics.ApplicationLatency.Value.TotalMilliseconds, Is.EqualTo(recent.Quantile(0.5)).Within(0.2));
            Assert.That(statistics.ApplicationLatency95.Value.TotalMilliseconds, Is.EqualTo(recent.Quantile(0.95)).Within(0.5));
            Assert.That(statistics.NegativeLatencies, Is.EqualTo(0));
            Assert.That(statistics.Samples, Is.EqualTo(20 / 0.05).Within(5));
            Assert.That(statistics.Dropped, Is.EqualTo(0));
            Assert.That(statistics.VisualisationLatency, Is.EqualTo(TimeSpan.FromMilliseconds(40)));
        }

        [Test]
        public void Fill_ReusedStatistics_ReplacesAllValues()
        {
            var simulated = new SimulatedSession(NetworkProfile.Lan, Seed);
            simulated.Run(10);
            var statistics = simulated.Session.Statistics(HeadsetTime.FromSeconds(simulated.Now));
            var known = statistics.ApplicationLatency;

            new SimulatedSession(NetworkProfile.Lan, Seed).Session.Fill(statistics, default);

            var fresh = new SessionStatistics();
            Assert.That(known, Is.Not.Null);
            var others = new[] { "VisualisationLatency", "RangeUnknownReason", "JointErrors", "JointStatuses" };
            foreach (var property in typeof(SessionStatistics).GetProperties().Where(p => !others.Contains(p.Name)))
                Assert.That(property.GetValue(statistics), Is.EqualTo(property.GetValue(fresh)), property.Name);
            Assert.That(statistics.RangeUnknownReason, Is.EqualTo(RangeUnknownReason.NoLimit));
            Assert.That(statistics.JointErrors.Select(j => j.Error), Is.All.Null);
            Assert.That(statistics.JointStatuses.Select(j => j.Age), Is.All.Null);
        }

        [Test]
        public void Diagnostics_BeforeAndAfterTheClockIsKnown_OmitUnknownValues()
        {
            var clock = new SetClock();
            var session = new CompensationSession(
                new SessionSettings(
                    new ConnectionSettings("127.0.0.1", headsetName: "left"), new VisualisationLatency(TimeSpan.FromMilliseconds(40))),
                TestRobot.Model, clock);
            var before = session.Listener.Diagnostics();
            session.Clock.Add(new SyncExchange(
                HeadsetTime.FromSeconds(1), ControlTime.FromSeconds(101.001),
                ControlTime.FromSeconds(101.001), HeadsetTime.FromSeconds(1.002)), out _);
            clock.Now = HeadsetTime.FromSeconds(1.002);

            var after = session.Listener.Diagnostics();

            Assert.That(before.HardwareId, Is.EqualTo("left"));
            Assert.That(before.Values.Select(v => v.Key), Is.EqualTo(new[]
            {
                "version", "state", "pose", "missing_joints", "joint_status/shoulder", "joint_status/elbow", "objects_not_current", "signals_not_current",
                "l_visu_ms", "samples", "dropped",
            }));
            Assert.That(before.Values[1].Value, Is.EqualTo("unsynchronised"));
            Assert.That(before.Level, Is.EqualTo(2));
            Assert.That(before.Message, Does.EndWith("missing joints: shoulder,elbow"));
            Assert.That(after.Stamp, Is.EqualTo(ControlTime.FromSeconds(101.002)));
            var values = after.Values.ToDictionary(v => v.Key, v => v.Value);
            Assert.That(values["state"], Is.EqualTo("converging"));
            Assert.That(values["offset_ns"], Is.EqualTo("-100000000000"));
            Assert.That(values["rtt_ms"], Is.EqualTo("2"));
            Assert.That(values["error_bound_us"], Is.EqualTo("1001.4"), "half the round-trip time, plus 700 ppm of the round-trip time for the skew");
            Assert.That(values["l_visu_ms"], Is.EqualTo("40"));
            Assert.That(values.Keys, Has.No.Member("l_app_ms"), "no sample yet");
        }
    }
}
