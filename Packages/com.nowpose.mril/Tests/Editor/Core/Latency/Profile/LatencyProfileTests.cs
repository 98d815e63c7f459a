using System;
using Nowpose.Latency;
using Nowpose.Latency.Profile;
using Nowpose.Messages;
using NUnit.Framework;
using NUnit.Framework.Constraints;

namespace Nowpose.Tests.Core.Latency.Profile
{
    public class LatencyProfileTests
    {
        static readonly DateTime Measured = new DateTime(2026, 11, 20, 13, 0, 0, DateTimeKind.Utc);

        static LatencyProfile Profile(
            double visuMs = 40.2, double spreadMs = 1.1, string device = "HoloLens 2", double displayHz = 60, int measurements = 300,
            double? limitMs = 15, RenderTimeSourceKind source = RenderTimeSourceKind.DisplayGpuTime, double? validToMs = null) =>
            new LatencyProfile(visuMs, spreadMs, device, displayHz, Measured, CalibrationMethod.VisibleLight, measurements, limitMs, source, validToMs);

        [Test]
        public void LatencyProfile_Limit_SetsRangeAndValidity()
        {
            var profile = Profile();

            Assert.That(profile.Range.Limit, Is.EqualTo(Lengths.Ms(15)));
            Assert.That(profile.Range.Source, Is.EqualTo(RenderTimeSourceKind.DisplayGpuTime));
            Assert.That(profile.ValidToRenderTime, Is.EqualTo(Lengths.Ms(15)));
        }

        [TestCase(500, 500, true)]
        [TestCase(-500, 0, true)]
        [TestCase(501, 1, false)]
        [TestCase(-501, 1, false)]
        [TestCase(1, 501, false)]
        [TestCase(1, -1, false)]
        public void HeadMotionLatency_Values_AreAcceptedWithinTheirRanges(double latencyMs, double uncertaintyMs, bool expected) =>
            Assert.That(
                () => new HeadMotionLatency(latencyMs, uncertaintyMs),
                expected ? (IResolveConstraint)Throws.Nothing : Throws.TypeOf<InputException>());

        [Test]
        public void LatencyProfile_LimitNotReached_HasAMeasuredMaximumButNoRange()
        {
            var profile = Profile(limitMs: null, validToMs: 12.5);

            Assert.That(profile.Range, Is.Null);
            Assert.That(profile.ValidToRenderTime, Is.EqualTo(Lengths.Ms(12.5)));
        }

        [TestCase(double.NaN, 1.1, 60, 300, 15, 15, "visualisation latency", double.NaN, " ms", 0, 500)]
        [TestCase(501, 1.1, 60, 300, 15, 15, "visualisation latency", 501, " ms", 0, 500)]
        [TestCase(40, -1, 60, 300, 15, 15, SettingNames.VisualisationSpread, -1, " ms", 0, 500)]
        [TestCase(40, 1, -60, 300, 15, 15, "display rate", -60, " Hz", 1, 1000)]
        [TestCase(40, 1, 1e-12, 300, 15, 15, "display rate", 1e-12, " Hz", 1, 1000)]
        [TestCase(40, 1, 60, -1, 15, 15, "measurements", -1, "", 0, int.MaxValue)]
        [TestCase(40, 1, 60, 300, 0, 15, "render time limit", 0, " ms", 0.1, 1000)]
        [TestCase(40, 1, 60, 300, 15, double.NaN, SettingNames.MaxRenderTime, double.NaN, " ms", 0.1, 1000)]
        public void LatencyProfile_ValueOutOfRange_ThrowsWithNameValueAndRange(
            double visuMs, double spreadMs, double displayHz, int measurements, double limitMs, double validToMs,
            string name, double value, string unit, double min, double max)
        {
            var fault = Assert.Throws<InputException>(
                () => Profile(visuMs, spreadMs, "HoloLens 2", displayHz, measurements, limitMs, validToMs: validToMs));

            Assert.That(fault.Message, Is.EqualTo(SettingMessages.OutOfRange(name, value, unit, min, max)));
        }

        [Test]
        public void LatencyProfile_DeviceWithLineBreak_Throws()
        {
            Assert.That(
                Assert.Throws<InputException>(() => Profile(device: "Holo\nLens")).Message,
                Is.EqualTo(ConditionMessages.NotOneLine("device", SettingNames.DeviceModel, 128)));
        }

        [Test]
        public void LatencyProfile_LimitWithoutSource_IsRefused()
        {
            Assert.Throws<InputException>(() => Profile(source: RenderTimeSourceKind.None));
        }

        static readonly object[][] Devices =
        {
            new object[] { "HoloLens 2", 60, null },
            new object[] { "hololens 2", 59.94, null },
            new object[] { "", 0, null },
            new object[] { null, double.NaN, null },
            new object[] { "Quest 3", 60, ConditionMessages.OtherDevice("HoloLens 2", "Quest 3") },
            new object[] { "HoloLens 2", 72, ConditionMessages.OtherRate("60", "72") },
        };

        [TestCaseSource(nameof(Devices))]
        public void RefusalFor_DeviceAndRate_NamesBothValuesIfOneDiffers(string device, double displayHz, string refusal)
        {
            Assert.That(Profile().RefusalFor(device, displayHz), Is.EqualTo(refusal));
        }

        [Test]
        public void RefusalFor_ProfileWithoutDeviceAndRate_IsNull()
        {
            Assert.That(Profile(device: null, displayHz: double.NaN).RefusalFor("Quest 3", 72), Is.Null);
        }

        [Test]
        public void RenderTimeSourceNames_AllSources_RoundTrip([Values] RenderTimeSourceKind source)
        {
            Assert.That(LatencyNames.RenderTimeSource.TryParse(LatencyNames.RenderTimeSource.NameOf(source), out var parsed), Is.True);
            Assert.That(parsed, Is.EqualTo(source));
        }

        [TestCase("Display_gpu_time")]
        [TestCase("gpu")]
        [TestCase(null)]
        public void RenderTimeSourceNames_OtherText_IsNone(string name)
        {
            Assert.That(LatencyNames.RenderTimeSource.TryParse(name, out _), Is.False);
        }
    }
}
