using System;
using Nowpose.Latency;
using Nowpose.Latency.Conditions;
using Nowpose.Latency.Profile;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Latency.Profile
{
    public class LatencyProfileJsonTests
    {
        const string Good = @"{""format"": ""nowpose-latency-profile"", ""version"": 1, ""visu_ms"": 40.2, ""visu_spread_ms"": 1.1,
            ""limit_render_ms"": 15.0, ""valid_to_render_ms"": 15.0, ""render_source"": ""display_gpu_time"", ""device"": ""HoloLens 2"",
            ""display_hz"": 60, ""measured"": ""2026-11-20T13:00:00Z"", ""method"": ""vlc"", ""measurements"": 300}";

        static string FaultOf(string text) => Assert.Throws<InputException>(() => LatencyProfileJson.Read(text, "profile.json")).Message;

        [Test]
        public void Read_WrittenProfile_RoundTrips(
            [Values(CalibrationMethod.VisibleLight, CalibrationMethod.Sine, CalibrationMethod.Nudge, CalibrationMethod.Manual)] object method)
        {
            var random = new Random((int)(CalibrationMethod)method);
            for (var i = 0; i < 200; i++)
            {
                double? limitMs = null, validToMs = null;
                if (random.Next(2) == 0) limitMs = 0.1 + 900 * random.NextDouble();
                if (random.Next(2) == 0) validToMs = 0.1 + 900 * random.NextDouble();
                var source = limitMs.HasValue ? (RenderTimeSourceKind)random.Next(1, 5) : (RenderTimeSourceKind)random.Next(5);
                var written = new LatencyProfile(
                    500 * random.NextDouble(), 20 * random.NextDouble(), "Gerät \"" + (char)random.Next(' ', 0x2fff) + "\" \\ 2", 120 * random.NextDouble(),
                    new DateTime(random.Next(), DateTimeKind.Utc).AddYears(2020), (CalibrationMethod)method, random.Next(), limitMs, source, validToMs);

                var read = LatencyProfileJson.Read(LatencyProfileJson.Write(written), "profile.json");

                Assert.That(Values(read), Is.EqualTo(Values(written)), "seed " + (int)(CalibrationMethod)method + ", profile " + i);
            }
        }

        static object[] Values(LatencyProfile p) => new object[]
        {
            p.Visualisation.Length, p.Spread, p.Device, p.DisplayHz, p.MeasuredUtc, p.Method, p.Measurements, p.RenderTimeSource,
            p.Range?.Limit, p.Range?.Source, p.ValidToRenderTime,
        };

        [Test]
        public void Read_ValidText_ReturnsItsValues()
        {
            var profile = LatencyProfileJson.Read(Good, "profile.json");

            Assert.That(Values(profile), Is.EqualTo(new object[]
            {
                Lengths.Ms(40.2), Lengths.Ms(1.1), "HoloLens 2", 60.0, new DateTime(2026, 11, 20, 13, 0, 0, DateTimeKind.Utc),
                CalibrationMethod.VisibleLight, 300, RenderTimeSourceKind.DisplayGpuTime, Lengths.Ms(15), RenderTimeSourceKind.DisplayGpuTime, Lengths.Ms(15),
            }));
        }

        [Test]
        public void Read_ConditionsAndHeadMotion_RoundTrip(
            [Values] ReprojectionMode reprojection, [Values(null, true, false)] bool? rewrites)
        {
            var conditions = new DisplayConditions(
                "HoloLens 2", 60, "Direct3D11", "NativeGraphicsJobs", "UniversalRenderPipelineAsset", rewrites, "PrioritizeInputPolling",
                reprojection);
            var written = new LatencyProfile(
                40, 1, conditions, new DateTime(2026, 11, 20, 0, 0, 0, DateTimeKind.Utc), CalibrationMethod.VisibleLight, 300,
                headMotion: new HeadMotionLatency(-1.5, 0.4));

            var read = LatencyProfileJson.Read(LatencyProfileJson.Write(written), "profile.json");

            Assert.That(read.Conditions, Is.EqualTo(conditions));
            Assert.That(read.HeadMotion.Latency, Is.EqualTo(Lengths.Ms(-1.5)));
            Assert.That(read.HeadMotion.Uncertainty, Is.EqualTo(Lengths.Ms(0.4)));
        }

        [Test]
        public void Read_ProfileOfAnOlderVersion_HasDeviceAndRateOnly()
        {
            var profile = LatencyProfileJson.Read(Good, "profile.json");

            Assert.That(profile.Conditions, Is.EqualTo(new DisplayConditions("HoloLens 2", 60)));
            Assert.That(profile.HeadMotion, Is.Null);
        }

        [TestCase(@"""reprojection"": ""sideways""", "profile.json: reprojection: 'sideways' is not allowed; use one of unknown, none, ")]
        [TestCase(@"""rewrite_before_render"": ""maybe""", "profile.json: rewrite_before_render: 'maybe' is not allowed; use on or off")]
        [TestCase(@"""rewrite_before_render"": true", "profile.json: rewrite_before_render is neither a string nor a number; it must be a string")]
        [TestCase(@"""head_latency_ms"": 700", "profile.json: head_latency_ms: 700 ms is out of range; allowed: -500 to 500 ms")]
        [TestCase(@"""head_latency_ms"": 7", "profile.json: head_latency_uncertainty_ms is missing")]
        public void Read_InvalidCondition_IsRefused(string field, string message)
        {
            Assert.That(FaultOf(Good.Replace("}", ", " + field + "}")), Does.StartWith(message));
        }

        [Test]
        public void Read_NoRenderTimes_HasNoRange()
        {
            var text = Good.Replace(@"""limit_render_ms"": 15.0, ""valid_to_render_ms"": 15.0, ""render_source"": ""display_gpu_time""",
                @"""limit_render_ms"": null, ""render_source"": null");

            Assert.That(LatencyProfileJson.Read(text, "profile.json").Range, Is.Null);
        }

        [Test]
        public void Read_UnknownFields_AreIgnored()
        {
            var text = Good.Replace("{", @"{""by"": {""name"": ""x"", ""tools"": [1, {""a"": 2}]}, ""note"": null, ");

            Assert.That(LatencyProfileJson.Read(text, "profile.json").Measurements, Is.EqualTo(300));
        }

        [TestCase(@"""version"": 1", @"""version"": 2, ""lengths"": {}", "profile.json: the latency profile has version 2; this release of Nowpose reads versions up to 1; "
            + "update Nowpose or calibrate again", TestName = "Read_NewerVersion_NamesTheRemedy")]
        [TestCase(@"""version"": 1", @"""version"": 0", "profile.json: version: 0 is not supported; allowed: 1; calibrate again")]
        [TestCase(@"""version"": 1,", "", "profile.json: version is missing; calibrate again")]
        [TestCase("nowpose-latency-profile", "other", "profile.json: it is not a latency profile: its format is 'other', not 'nowpose-latency-profile'; "
            + "choose a file that calibrate has written")]
        [TestCase("40.2", "NaN", "profile.json: visu_ms: NaN ms is out of range; allowed: 0 to 500 ms")]
        [TestCase("40.2", "700", "profile.json: visu_ms: 700 ms is out of range; allowed: 0 to 500 ms")]
        [TestCase("40.2", @"""40.2""", "profile.json: visu_ms is '40.2'; it must be a number from 0 to 500 ms; calibrate again")]
        [TestCase("40.2", "null", "profile.json: visu_ms is missing; calibrate again")]
        [TestCase("40.2", "[40.2]", "profile.json: visu_ms is neither a string nor a number; it must be a number from 0 to 500 ms; calibrate again")]
        [TestCase(@"""limit_render_ms"": 15.0", @"""limit_render_ms"": 0", "profile.json: limit_render_ms: 0 ms is out of range; allowed: 0.1 to 1000 ms")]
        [TestCase(@"""display_gpu_time""", @"""gpu""", "profile.json: render_source: 'gpu' is unknown; allowed: display_gpu_time, engine_gpu_time, "
            + "gpu_completion, camera_cpu")]
        [TestCase(@"""display_gpu_time""", "null", "profile.json: render time limit: state the source of the render times from which it was determined")]
        [TestCase(@"""vlc""", @"""guess""", "profile.json: method: 'guess' is unknown; allowed: vlc, sine, nudge, manual")]
        [TestCase("2026-11-20T13:00:00Z", "yesterday", "profile.json: measured: 'yesterday' is not a date; write it as 2026-11-20T13:00:00Z")]
        [TestCase(@"""measurements"": 300", @"""measurements"": 2.5", "profile.json: measurements is 2.5; it must be a whole number; calibrate again")]
        [TestCase(@"""display_hz"": 60", @"""display_hz"": 60, ""display_hz"": 90", "profile.json: display_hz occurs twice; remove one")]
        public void Read_InvalidValue_ThrowsWithTheReason(string part, string instead, string message)
        {
            Assert.That(Good, Does.Contain(part), "the text contains the part to replace");

            Assert.That(FaultOf(Good.Replace(part, instead)), Is.EqualTo(message));
        }

        [Test]
        public void Read_RequiredFieldMissing_IsRefused()
        {
            foreach (var field in new[] { "visu_ms", "visu_spread_ms", "device", "display_hz", "measured", "method", "measurements" })
                Assert.That(
                    FaultOf(Good.Replace("\"" + field + "\"", "\"other\"")),
                    Is.EqualTo("profile.json: " + field + " is missing; calibrate again"));
        }

        [Test]
        public void Read_TruncatedAnywhere_IsRefusedWithAOneLineMessage()
        {
            for (var length = 0; length < Good.Length; length++)
                Assert.That(FaultOf(Good.Substring(0, length)), Does.StartWith("profile.json: ").And.Not.Contains("\n"), length + " characters");
        }

        [TestCase("")]
        [TestCase("[]")]
        [TestCase("null")]
        [TestCase("visu_ms = 40")]
        [TestCase("{\"visu_ms\": 1e999999}")]
        [TestCase("\0\0\0\0\0\0\0\0")]
        public void Read_InvalidContent_IsRefusedWithAOneLineMessage(string text)
        {
            Assert.That(FaultOf(text), Does.StartWith("profile.json: ").And.Not.Contains("\n"));
        }

        [Test]
        public void Read_RandomlyDamaged_ThrowsOnlyInputExceptions()
        {
            var random = new Random(5);
            var refused = 0;
            for (var i = 0; i < 2000; i++)
            {
                var text = Good.ToCharArray();
                for (var spoiled = 0; spoiled < 3; spoiled++) text[random.Next(text.Length)] = (char)random.Next(1, 128);
                try
                {
                    LatencyProfileJson.Read(new string(text), "profile.json");
                }
                catch (InputException)
                {
                    refused++;
                }
            }

            Assert.That(refused, Is.GreaterThan(1000), "seed 5");
        }
    }
}
