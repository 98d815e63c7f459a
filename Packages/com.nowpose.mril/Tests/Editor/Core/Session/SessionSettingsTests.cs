using System;
using MathNet.Numerics.Statistics;
using Nowpose.Latency;
using Nowpose.Messages;
using Nowpose.Network;
using Nowpose.Session;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Session
{
    /// <summary>Checks that invalid settings are refused.</summary>
    public class SessionSettingsTests
    {
        [TestCase("")]
        [TestCase("not a host")]
        public void ConnectionSettings_InvalidHost_ThrowsWithTheValue(string host) => Assert.That(
            Assert.Throws<InputException>(() => new ConnectionSettings(host)).Message, Is.EqualTo(ConnectionMessages.NotAHost(host)));

        [Test]
        public void ConnectionSettings_AnotherMachineInPlainText_IsRefused() => Assert.That(
            Assert.Throws<InputException>(() => new ConnectionSettings("192.168.0.5")).Message,
            Is.EqualTo(ConnectionMessages.PlainNotAllowed("192.168.0.5")));

        [Test]
        public void ConnectionSettings_TokenInPlainTextBeyondLoopback_IsRefusedEvenOnATrustedLan()
        {
            var error = Assert.Throws<InputException>(() => new ConnectionSettings("192.168.0.5", token: "secret", insecureLan: true));

            Assert.That(error.Message, Is.EqualTo(ConnectionMessages.TokenUnencrypted("192.168.0.5")));
        }

        [Test]
        public void Settings_OutOfRange_ThrowWithValueUnitAndRange()
        {
            Assert.That(Assert.Throws<InputException>(() => new PredictionSettings(horizonCapMs: -1)).Message,
                Is.EqualTo(SettingMessages.OutOfRange("horizon cap", -1, " ms", 0, 5000)));
            Assert.That(Assert.Throws<InputException>(() => new SessionSettings(
                    new ConnectionSettings("127.0.0.1"), new VisualisationLatency(TimeSpan.Zero), syncIntervalMs: 5)).Message,
                Is.EqualTo(SettingMessages.OutOfRange("sync interval", 5, " ms", 20, 10000)));
        }
    }
}
