using System;
using Nowpose.Latency;
using Nowpose.Latency.Profile;
using NUnit.Framework;

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

        [Test]
        public void LatencyProfile_LimitNotReached_HasAMeasuredMaximumButNoRange()
        {
            var profile = Profile(limitMs: null, validToMs: 12.5);

            Assert.That(profile.Range, Is.Null);
            Assert.That(profile.ValidToRenderTime, Is.EqualTo(Lengths.Ms(12.5)));
        }

        [TestCase(double.NaN, 1.1, "HoloLens 2", 60, 300, 15, 15, "visualisation latency: NaN ms is out of range; allowed: 0 to 500 ms")]
        [TestCase(501, 1.1, "HoloLens 2", 60, 300, 15, 15, "visualisation latency: 501 ms is out of range; allowed: 0 to 500 ms")]
        [TestCase(40, -1, "HoloLens 2", 60, 300, 15, 15, "spread of the visualisation latency: -1 ms is out of range; allowed: 0 to 500 ms")]
        [TestCase(40, 1, "Holo\nLens", 60, 300, 15, 15, "device: the model's name must be one line of up to 128 characters")]
        [TestCase(40, 1, "HoloLens 2", -60, 300, 15, 15, "display rate: -60 Hz is out of range; allowed: 0 to 1000 Hz")]
        [TestCase(40, 1, "HoloLens 2", 60, -1, 15, 15, "measurements: -1 is out of range; allowed: 0 to 2147483647")]
        [TestCase(40, 1, "HoloLens 2", 60, 300, 0, 15, "render time limit: 0 ms is out of range; allowed: 0.1 to 1000 ms")]
        [TestCase(40, 1, "HoloLens 2", 60, 300, 15, double.NaN, "maximum measured render time: NaN ms is out of range; allowed: 0.1 to 1000 ms")]
        public void LatencyProfile_InvalidValue_ThrowsWithTheReason(
            double visuMs, double spreadMs, string device, double displayHz, int measurements, double limitMs, double validToMs, string message)
        {
            var fault = Assert.Throws<InputException>(
                () => Profile(visuMs, spreadMs, device, displayHz, measurements, limitMs, validToMs: validToMs));

            Assert.That(fault.Message, Is.EqualTo(message));
        }

        [Test]
        public void LatencyProfile_LimitWithoutSource_IsRefused()
        {
            Assert.Throws<InputException>(() => Profile(source: RenderTimeSourceKind.None));
        }

        [TestCase("HoloLens 2", 60, null)]
        [TestCase("hololens 2", 59.94, null)]
        [TestCase("", 0, null)]
        [TestCase(null, double.NaN, null)]
        [TestCase("Quest 3", 60, "latency profile was measured on device 'HoloLens 2', but this device is 'Quest 3'; calibrate this device")]
        [TestCase("HoloLens 2", 72, "latency profile was measured at 60 Hz, but this display runs at 72 Hz; calibrate at this refresh rate")]
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
