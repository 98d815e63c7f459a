using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Sync;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Session
{
    /// <summary>Tests the events that a session reports to a recorder.</summary>
    public class SessionEventsTests
    {
        static readonly HeadsetTime Start = HeadsetTime.FromSeconds(100);

        readonly List<string> _events = new List<string>();
        CompensationSession _session;

        [SetUp]
        public void Listen()
        {
            _events.Clear();
            _session = new CompensationSession(
                new SessionSettings(new ConnectionSettings("127.0.0.1"), new VisualisationLatency(Lengths.Ms(40))), TestRobot.Model, new SetClock());
            _session.Clock.Judged += (in SyncExchange exchange, SyncVerdict verdict, SyncExchangeFault fault) => _events.Add(verdict + " " + fault);
            _session.Intake.SampleJudged += (arrival, reason) => _events.Add("sample " + reason);
            _session.Restarted += (at, clock) => _events.Add("restarted " + clock.IsKnown);
            _session.Ticked += frame => _events.Add("frame");
        }

        static SyncExchange Exchange(HeadsetTime at) =>
            new SyncExchange(at - Lengths.Ms(2), new ControlTime(at.SinceEpoch), new ControlTime(at.SinceEpoch), at);

        static JointStateMessage Sample(TimeSpan stamp, string joint = "elbow") =>
            new JointStateMessage(new ControlTime(stamp), new[] { joint }, new[] { 0.1 });

        [Test]
        public void Tick_FirstExchangeAndSample_RaisesEventsInOrder()
        {
            _session.Clock.Add(Exchange(Start), out _);
            _session.Listener.Received(Sample(Start.SinceEpoch), Start);

            _session.Tick(Start + Lengths.Ms(10));

            Assert.That(_events, Is.EqualTo(new[] { "Consistent None", "restarted True", "sample None", "frame" }));
        }

        [Test]
        public void Exchange_Dropped_RaisesAnEventWithItsFault()
        {
            _session.Clock.Add(Exchange(Start), out _);
            _session.Clock.Add(Exchange(Start), out _);

            Assert.That(_events.Last(), Is.EqualTo("Dropped NotNewer"));
        }

        [TestCase("elbow", 0, "DuplicateSample")]
        [TestCase("elbow", 5000, "StampInFuture")]
        [TestCase("unknown", 0, "UnknownJoint")]
        public void Sample_Dropped_RaisesAnEventWithTheReason(string joint, double aheadMs, string reason)
        {
            _session.Clock.Add(Exchange(Start), out _);
            _session.Listener.Received(Sample(Start.SinceEpoch), Start);
            _session.Listener.Received(Sample(Start.SinceEpoch + Lengths.Ms(aheadMs), joint), Start);

            _session.Tick(Start + Lengths.Ms(10));

            Assert.That(
                _events.Where(e => e.StartsWith("sample", StringComparison.Ordinal)), Is.EqualTo(new[] { "sample None", "sample " + reason }));
        }

        // The queue has 1000 messages, and the newest message that left it is kept.
        [Test]
        public void Sample_OverflowsTheQueue_RaisesAnEventImmediately()
        {
            for (var i = 0; i <= 1001; i++) _session.Listener.Received(Sample(Start.SinceEpoch + Lengths.Ms(i)), Start);

            Assert.That(_events, Is.EqualTo(new[] { "sample SlowReader" }));
        }

        [Test]
        public void NewestRenderTime_AfterRendered_IsTheLastMeasuredTime()
        {
            Assert.That(_session.NewestRenderTime, Is.Null);
            _session.Rendered(Lengths.Ms(9), RenderTimeSourceKind.DisplayGpuTime);
            Assert.That(_session.NewestRenderTime, Is.EqualTo(Lengths.Ms(9)));
            _session.Rendered(TimeSpan.Zero, RenderTimeSourceKind.None);
            Assert.That(_session.NewestRenderTime, Is.Null);
        }
    }
}
