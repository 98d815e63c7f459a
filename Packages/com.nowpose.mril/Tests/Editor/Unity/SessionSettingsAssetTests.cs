using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Session;
using Nowpose.Tests.Unity.Robot;
using Nowpose.Unity;
using Nowpose.Unity.Session;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Tests.Unity
{
    public class SessionSettingsAssetTests
    {
        const string Pin = "sha256/AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA=";

        static readonly (string Field, object Value, Func<SessionSettings, object> Read, object Expected)[] Fields =
        {
            ("_host", "localhost", s => s.Connection.Host, "localhost"),
            ("_syncPort", 1234, s => s.Connection.SyncPort, 1234),
            ("_webSocketPort", 65535, s => s.Connection.WebSocketPort, 65535),
            ("_pin", Pin, s => s.Connection.Pin?.ToString(), Pin),
            ("_pin", Pin, s => s.Connection.Security, TransportSecurity.Pinned),
            ("_deviceTrust", true, s => s.Connection.Security, TransportSecurity.DeviceTrust),
            ("_token", "secret", s => s.Connection.Token, "secret"),
            ("_headsetName", "left door", s => s.Connection.HeadsetName, "left door"),
            ("_robotNamespace", "arm1", s => s.RobotNamespace, "arm1"),
            ("_publishDisplayed", false, s => s.Connection.PublishesDisplayed, false),
            ("_visualisationMs", 33.25, s => s.Visualisation.Length.TotalMilliseconds, 33.25),
            ("_predictor", "cubic", s => s.Prediction.Predictor, "cubic"),
            ("_horizonCapMs", 250.5, s => s.Prediction.HorizonCap.TotalMilliseconds, 250.5),
            ("_maximumGapMs", 700.0, s => s.Prediction.MaximumGap.TotalMilliseconds, 700.0),
            ("_blendMs", 20.0, s => s.Prediction.Blend.TotalMilliseconds, 20.0),
            ("_followPlan", false, s => s.Prediction.FollowPlan, false),
            ("_speedPercent", 40.0, s => s.Prediction.SpeedShare, 0.4),
            ("_accelerationRadians", 7.5, s => s.Prediction.AccelerationLimit, 7.5),
            ("_jerkRadians", 75.0, s => s.Prediction.JerkLimit, 75.0),
            ("_clockSource", ControlClockSource.RosTime, s => s.Connection.ClockSource, ControlClockSource.RosTime),
            ("_clockEstimator", "ransac", s => s.ClockEstimator, "ransac"),
            ("_syncIntervalMs", 150.0, s => s.SyncInterval.TotalMilliseconds, 150.0),
            ("_outsideRange", OutsideRangeResponse.Hold, s => s.OutsideRange, OutsideRangeResponse.Hold),
            ("_rewriteBeforeRender", false, s => s.RewriteBeforeRender, false),
        };

        // These fields are valid only in combination, so they have tests of their own.
        static readonly string[] OtherFields = { "_insecureLan", "_renderTimeLimitMs", "_renderTimeLimitSource" };

        readonly SceneObjects _scene = new SceneObjects();

        [TearDown]
        public void Clean() => _scene.Destroy();

        SessionSettingsAsset Asset() => _scene.Asset<SessionSettingsAsset>("My Settings");

        [Test]
        public void Fields_All_AreTested()
        {
            var serialised = typeof(SessionSettingsAsset).GetFields(BindingFlags.Instance | BindingFlags.NonPublic)
                .Where(field => field.IsDefined(typeof(SerializeField), false)).Select(field => field.Name);

            Assert.That(serialised, Is.EquivalentTo(Fields.Select(f => f.Field).Concat(OtherFields).Distinct()));
        }

        [Test]
        public void ToSettings_EachField_IsUsed()
        {
            foreach (var (field, value, read, expected) in Fields)
            {
                Assert.That(read(Asset().ToSettings()), Is.Not.EqualTo(expected), field + ": the default must differ from the tested value");
                Assert.That(read(Asset().With(field, value).ToSettings()), Is.EqualTo(expected), field);
            }
        }

        [Test]
        public void ToSettings_EmptyFields_UsesTheDefaults()
        {
            var settings = Asset().ToSettings();

            Assert.That(settings.Connection.Pin, Is.Null);
            Assert.That(settings.Connection.Token, Is.Null);
            Assert.That(settings.Connection.Security, Is.EqualTo(TransportSecurity.Plain));
            Assert.That(settings.Range, Is.Null);
            Assert.That(settings.Prediction.Predictor, Is.EqualTo(PredictionSettings.Default.Predictor));
            Assert.That(settings.Prediction.HorizonCap, Is.EqualTo(PredictionSettings.Default.HorizonCap));
            Assert.That(settings.Prediction.MaximumGap, Is.EqualTo(PredictionSettings.Default.MaximumGap));
        }

        [Test]
        public void ToSettings_RenderTimeLimit_HasItsSource()
        {
            var range = Asset().With("_renderTimeLimitMs", 14.5).With("_renderTimeLimitSource", RenderTimeSourceKind.DisplayGpuTime).ToSettings().Range;

            Assert.That(range.Limit.TotalMilliseconds, Is.EqualTo(14.5));
            Assert.That(range.Source, Is.EqualTo(RenderTimeSourceKind.DisplayGpuTime));
        }

        [Test]
        public void ToSettings_InsecureLan_AllowsAnotherMachine()
        {
            var asset = Asset().With("_host", "192.168.7.9");

            Assert.That(Assert.Throws<InputException>(() => asset.ToSettings()).Message, Does.Contain("192.168.7.9").And.Contain("Insecure Lan"));
            Assert.That(asset.With("_insecureLan", true).ToSettings().Connection.Host, Is.EqualTo("192.168.7.9"));
        }

        [TestCase(null, "of-the-asset")]
        [TestCase("of-the-code", "of-the-code")]
        [TestCase("", null)]
        public void ToSettings_TokenArgument_ReplacesTheTokenOfTheAsset(string given, string expected)
        {
            var asset = Asset().With("_token", "of-the-asset").With("_host", "localhost");

            var connection = asset.ToSettings(given).Connection;

            Assert.That(connection.Token, Is.EqualTo(expected));
            Assert.That(connection.Host, Is.EqualTo("localhost"), "the other settings come from the asset");
        }

        [Test]
        public void ToSettings_TokenArgumentInPlainText_IsRefused()
        {
            var asset = Asset().With("_host", "192.168.7.9").With("_insecureLan", true);

            var message = Assert.Throws<InputException>(() => asset.ToSettings("s3cret")).Message;

            Assert.That(message, Does.Contain("token").And.Contain("192.168.7.9").And.Not.Contain("s3cret"));
            Assert.That(asset.ToSettings().Connection.Token, Is.Null, "the token is not stored in the asset");
        }

        [TestCase(null)]
        [TestCase("")]
        public void HeadsetName_Empty_UsesTheDeviceName(string name) =>
            Assert.That(Asset().With("_headsetName", name).ToSettings().Connection.HeadsetName, Is.EqualTo(SystemInfo.deviceName));

        [TestCase("_host", "no host", "host", "'no host'", "name", "address")]
        [TestCase("_host", "", "host", "''", "name", "address")]
        [TestCase("_syncPort", 0, "sync port", "0", "1 to 65535")]
        [TestCase("_webSocketPort", 65536, "WebSocket port", "65536", "1 to 65535")]
        [TestCase("_pin", "sha256/AAAA", "pin", "sha256/AAAA", "32 bytes")]
        [TestCase("_token", "with blank", "token", "ASCII")]
        [TestCase("_headsetName", " ", "headset name", "1 to 128")]
        [TestCase("_robotNamespace", "1st arm", "robot namespace", "1st arm", "32 characters")]
        [TestCase("_visualisationMs", -1.0, "visualisation latency", "-1 ms", "0 to 500 ms")]
        [TestCase("_visualisationMs", 500.5, "visualisation latency", "500.5 ms", "0 to 500 ms")]
        [TestCase("_visualisationMs", double.NaN, "visualisation latency", "NaN ms", "0 to 500 ms")]
        [TestCase("_visualisationMs", double.MaxValue, "visualisation latency", "ms", "0 to 500 ms")]
        [TestCase("_renderTimeLimitMs", -5.0, "render time limit", "-5 ms", "0.1 to 1000 ms")]
        [TestCase("_renderTimeLimitMs", 16.0, "render time limit", "source")]
        [TestCase("_predictor", "psychic", "predictor", "'psychic'", "quadratic-h3")]
        [TestCase("_predictor", "", "predictor", "''", "quadratic-h3")]
        [TestCase("_horizonCapMs", 5001.0, "horizon cap", "5001 ms", "0 to 5000 ms")]
        [TestCase("_speedPercent", 0.0, "speed share", "0 times the URDF's velocity", "0.01 to 1")]
        [TestCase("_accelerationRadians", -2.0, "acceleration limit", "-2 rad/s²", "0.01 to 1000000")]
        [TestCase("_jerkRadians", double.NaN, "jerk limit", "NaN rad/s³", "0.01 to 1000000")]
        [TestCase("_maximumGapMs", 0.5, "maximum gap", "0.5 ms", "1 to 60000 ms")]
        [TestCase("_blendMs", 250.0, "blend", "250 ms", "0 to 200 ms")]
        [TestCase("_clockSource", (ControlClockSource)2, "clock source", "2 is unknown", "0 (clock sync) and 1 (ROS time)")]
        [TestCase("_clockEstimator", "paper", "clock estimator", "'paper'", "default, ransac")]
        [TestCase("_syncIntervalMs", 19.0, "sync interval", "19 ms", "20 to 10000 ms")]
        public void ToSettings_InvalidValue_OneLineMessageNamesAssetFieldValueAndRange(string field, object value, params string[] named)
        {
            var message = Assert.Throws<InputException>(() => Asset().With(field, value).ToSettings()).Message;

            Assert.That(message, Does.StartWith("'My Settings': "));
            foreach (var part in named) Assert.That(message, Does.Contain(part));
            Assert.That(message, Does.Not.Contain("\n"));
        }

        [Test]
        public void ToSettings_InvalidToken_IsNotShown()
        {
            var message = Assert.Throws<InputException>(() => Asset().With("_token", "s3cret word").ToSettings()).Message;

            Assert.That(message, Does.Not.Contain("s3cret"));
        }
    }
}
