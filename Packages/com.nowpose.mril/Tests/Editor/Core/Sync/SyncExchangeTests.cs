using System;
using Nowpose.Protocol;
using Nowpose.Sync;
using NUnit.Framework;
using static Nowpose.Tests.Core.Lengths;

namespace Nowpose.Tests.Core.Sync
{
    public class SyncExchangeTests
    {
        static readonly HeadsetTime Start = HeadsetTime.FromSeconds(10);

        static SyncExchange Exchange(ClockOffset offset, double upMs, double serverMs, double downMs)
        {
            var arrival = Start + Ms(upMs);
            var sent = arrival + Ms(serverMs);
            return new SyncExchange(Start, offset.ToControl(arrival), offset.ToControl(sent), sent + Ms(downMs));
        }

        [TestCase(1234.5)]
        [TestCase(-1.7e9)]
        [TestCase(4e9)]
        public void Offset_SymmetricPath_IsExact(double offsetSeconds)
        {
            var offset = new ClockOffset(Seconds(offsetSeconds));

            var exchange = Exchange(offset, 7.5, 3, 7.5);

            Assert.That(exchange.Offset, Is.EqualTo(offset));
            Assert.That(exchange.RoundTripTime, Is.EqualTo(Ms(15)));
        }

        [TestCase(0.5, 9.0)]
        [TestCase(20.0, 1.0)]
        [TestCase(0, 30)]
        public void Offset_AsymmetricPath_ErrorIsHalfTheDifference(double upMs, double downMs)
        {
            var offset = new ClockOffset(Seconds(1234.5));

            var exchange = Exchange(offset, upMs, 0.2, downMs);

            var error = exchange.Offset - offset;
            Assert.That(error, Is.EqualTo(Ms((downMs - upMs) / 2)));
            Assert.That(error.Duration(), Is.LessThanOrEqualTo(new TimeSpan(exchange.RoundTripTime.Ticks / 2)));
        }

        [Test]
        public void Offset_ControlClockFlooredToItsCycle_IsUnbiasedOnAverage()
        {
            var cycle = Ms(1);
            var offset = new ClockOffset(Ms(250.3));
            double sum = 0;
            const int count = 1000;
            for (var i = 0; i < count; i++)
            {
                var sent = Start + Ms(i * 0.3717);
                var arrival = sent + Ms(2);
                var stamp = offset.ToControl(arrival).SinceEpoch.Ticks / cycle.Ticks * cycle.Ticks;
                var floored = new ControlTime(new TimeSpan(stamp));
                sum += (new SyncExchange(sent, floored, floored, arrival + Ms(2), cycle).Offset - offset).TotalMilliseconds;
            }

            Assert.That(sum / count, Is.EqualTo(0).Within(0.02), "half a cycle would be 0.5 ms");
        }

        [TestCase(0, 5, 4, 10, SyncExchangeFault.ControlTimeReversed)]
        [TestCase(10, 5, 6, 4, SyncExchangeFault.HeadsetTimeReversed)]
        [TestCase(0, 5, 17, 10, SyncExchangeFault.NegativeRoundTrip)]
        [TestCase(0, 5, 6, 10, SyncExchangeFault.None)]
        [TestCase(0, 5, 15, 10, SyncExchangeFault.None)]
        public void Check_EachViolatedRule_IsReported(int t1Ms, int t2Ms, int t3Ms, int t4Ms, object expected)
        {
            var exchange = new SyncExchange(
                new HeadsetTime(Ms(t1Ms)), new ControlTime(Ms(t2Ms)), new ControlTime(Ms(t3Ms)), new HeadsetTime(Ms(t4Ms)));

            Assert.That(SyncExchangeRules.Check(exchange), Is.EqualTo((SyncExchangeFault)expected));
        }

        [TestCase(1000, 999, 0u, SyncExchangeFault.ControlTimeReversed)]
        [TestCase(1000, 1001, 0u, SyncExchangeFault.NegativeRoundTrip)]
        [TestCase(1000, 1000, 0u, SyncExchangeFault.None)]
        [TestCase(1040, 1161, 120u, SyncExchangeFault.NegativeRoundTrip)]
        [TestCase(1040, 1160, 120u, SyncExchangeFault.None)]
        [TestCase(1000, 1149, 149u, SyncExchangeFault.None)]
        public void CheckReply_TimesWithinTheSameTick_AppliesTheRulesToNanoseconds(long t2Ns, long t3Ns, uint resolutionNs, object expected)
        {
            var reply = new SyncFrame(SyncFrameKind.Reply, 0, 1, 0, 0, t2Ns, t3Ns, resolutionNs);
            var exchange = SyncExchange.Of(default, reply, default);

            Assert.That(SyncExchangeRules.CheckReply(exchange, reply), Is.EqualTo((SyncExchangeFault)expected));
        }

        [TestCase(0u, 0)]
        [TestCase(1u, 1)]
        [TestCase(100u, 1)]
        [TestCase(101u, 2)]
        [TestCase(uint.MaxValue, 42_949_673)]
        public void Of_AnyResolution_IsRoundedUpToTicks(uint resolutionNs, long ticks)
        {
            var exchange = SyncExchange.Of(default, new SyncFrame(SyncFrameKind.Reply, 0, 1, 0, 0, 0, 0, resolutionNs), default);

            Assert.That(exchange.Resolution.Ticks, Is.EqualTo(ticks));
        }

        [Test]
        public void Check_CoarseServerClock_AllowsANegativeRoundTripOfOneCycle()
        {
            var exchange = new SyncExchange(
                new HeadsetTime(Ms(0)), new ControlTime(Ms(5)), new ControlTime(Ms(6)), new HeadsetTime(Ms(0.4)), Ms(1));

            Assert.That(SyncExchangeRules.Check(exchange), Is.EqualTo(SyncExchangeFault.None));
        }
    }
}
