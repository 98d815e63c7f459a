using System;
using Nowpose.Latency;
using Nowpose.Messages;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Latency
{
    public class ApplicationLatencyTests
    {
        static readonly ControlTime Taken = ControlTime.FromSeconds(1.7e9);

        [Test]
        public void Add_ArrivalAfterTheStamp_LatencyIsTheDifference()
        {
            var latency = new ApplicationLatency();

            latency.Add(Taken + TimeSpan.FromMilliseconds(85), Taken);

            Assert.That(latency.Newest, Is.EqualTo(TimeSpan.FromMilliseconds(85)));
            Assert.That(latency.Median, Is.EqualTo(TimeSpan.FromMilliseconds(85)));
            Assert.That(latency.NegativeCount, Is.EqualTo(0));
        }

        [Test]
        public void Add_ArrivalBeforeTheStamp_IsCountedAndStaysNegative()
        {
            var latency = new ApplicationLatency();

            latency.Add(Taken - TimeSpan.FromMilliseconds(2), Taken);

            Assert.That(latency.NegativeCount, Is.EqualTo(1));
            Assert.That(latency.Newest, Is.EqualTo(TimeSpan.FromMilliseconds(-2)));
        }

        [Test]
        public void Median_WithoutSamples_IsUnknown()
        {
            Assert.That(new ApplicationLatency().Median, Is.Null);
        }

        [Test]
        public void EndToEnd_ApplicationLatency_AddsTheVisualisationLatency()
        {
            var visualisation = new VisualisationLatency(TimeSpan.FromMilliseconds(40));

            Assert.That(visualisation.EndToEnd(TimeSpan.FromMilliseconds(85)), Is.EqualTo(TimeSpan.FromMilliseconds(125)));
            Assert.That(visualisation.LightOf(HeadsetTime.FromSeconds(2)), Is.EqualTo(HeadsetTime.FromSeconds(2.04)));
        }

        [TestCase(-1)]
        [TestCase(501)]
        public void VisualisationLatency_OutOfRange_NamesValueUnitAndRange(int ms)
        {
            var error = Assert.Throws<InputException>(() => new VisualisationLatency(Lengths.Ms(ms)));

            Assert.That(error.Message, Is.EqualTo(SettingMessages.OutOfRange("visualisation latency", ms, " ms", 0, 500)));
        }
    }
}
