using System;
using MathNet.Numerics.Statistics;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Session;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Session
{
    /// <summary>Checks that invalid settings are refused.</summary>
    public class SessionSettingsTests
    {
        [TestCase("", "host: ''")]
        [TestCase("not a host", "host: 'not a host'")]
        [TestCase("192.168.0.5", "is another machine")]
        public void ConnectionSettings_InvalidHost_ThrowsWithTheValue(string host, string named)
        {
            var error = Assert.Throws<InputException>(() => new ConnectionSettings(host));

            Assert.That(error.Message, Does.Contain(named));
        }

        [Test]
        public void ConnectionSettings_TokenInPlainTextBeyondLoopback_IsRefusedEvenOnATrustedLan()
        {
            var error = Assert.Throws<InputException>(() => new ConnectionSettings("192.168.0.5", token: "secret", insecureLan: true));

            Assert.That(error.Message, Does.Contain("unencrypted").And.Not.Contain("secret"));
        }

        [Test]
        public void Settings_OutOfRange_ThrowWithValueUnitAndRange()
        {
            Assert.That(Assert.Throws<InputException>(() => new PredictionSettings(horizonCapMs: -1)).Message,
                Is.EqualTo("horizon cap: -1 ms is out of range; allowed: 0 to 5000 ms"));
            Assert.That(Assert.Throws<InputException>(() => new SessionSettings(
                    new ConnectionSettings("127.0.0.1"), new VisualisationLatency(TimeSpan.Zero), syncIntervalMs: 5)).Message,
                Is.EqualTo("sync interval: 5 ms is out of range; allowed: 20 to 10000 ms"));
        }
    }
}
