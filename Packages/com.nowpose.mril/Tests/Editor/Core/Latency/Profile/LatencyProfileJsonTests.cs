using System;
using Nowpose.Latency;
using Nowpose.Latency.Conditions;
using Nowpose.Latency.Profile;
using Nowpose.Messages;
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
                    500 * random.NextDouble(), 20 * random.NextDouble(),
                    "Gerät \"" + (char)random.Next(' ', 0x2fff) + "\" \\ 2", 1 + 119 * random.NextDouble(),
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

        static readonly string[][] InvalidConditions =
        {
            new[] { @"""reprojection"": ""sideways""", ConditionMessages.NotAMode("reprojection", "sideways", "unknown, none, ") },
            new[] { @"""rewrite_before_render"": ""maybe""", ConditionMessages.NotASwitch("rewrite_before_render", "maybe", "on", "off") },
            new[] { @"""rewrite_before_render"": true", ProfileMessages.NotAText("rewrite_before_render", ProfileMessages.OtherKind) },
            new[] { @"""head_latency_ms"": 700", SettingMessages.OutOfRange("head_latency_ms", 700, " ms", -500, 500) },
            new[] { @"""head_latency_ms"": 7", ProfileMessages.Missing("head_latency_uncertainty_ms") },
        };

        [TestCaseSource(nameof(InvalidConditions))]
        public void Read_InvalidCondition_IsRefused(string field, string message)
        {
            Assert.That(FaultOf(Good.Replace("}", ", " + field + "}")), Does.StartWith("profile.json: " + message));
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

        static readonly string[][] InvalidValues =
        {
            new[] { @"""version"": 1", @"""version"": 2, ""lengths"": {}", ProfileMessages.NewerVersion(2, 1) },
            new[] { @"""version"": 1", @"""version"": 0", ProfileMessages.Version(0, 1) },
            new[] { @"""version"": 1,", "", ProfileMessages.Missing("version") },
            new[] { "nowpose-latency-profile", "other", ProfileMessages.OtherFormat("other", "nowpose-latency-profile") },
            new[] { "40.2", "NaN", SettingMessages.OutOfRange("visu_ms", double.NaN, " ms", 0, 500) },
            new[] { "40.2", "700", SettingMessages.OutOfRange("visu_ms", 700, " ms", 0, 500) },
            new[] { "40.2", @"""40.2""", ProfileMessages.NotANumber("visu_ms", "'40.2'", 0, 500, " ms") },
            new[] { "40.2", "null", ProfileMessages.Missing("visu_ms") },
            new[] { "40.2", "[40.2]", ProfileMessages.NotANumber("visu_ms", ProfileMessages.OtherKind, 0, 500, " ms") },
            new[] { @"""limit_render_ms"": 15.0", @"""limit_render_ms"": 0", SettingMessages.OutOfRange("limit_render_ms", 0, " ms", 0.1, 1000) },
            new[]
            {
                @"""display_gpu_time""", @"""gpu""",
                ProfileMessages.UnknownSource("gpu", "display_gpu_time, engine_gpu_time, gpu_completion, camera_cpu"),
            },
            new[] { @"""display_gpu_time""", "null", ProfileMessages.LimitWithoutSource },
            new[] { @"""vlc""", @"""guess""", ProfileMessages.UnknownMethod("guess", "vlc, sine, nudge, manual") },
            new[] { "2026-11-20T13:00:00Z", "yesterday", ProfileMessages.NotADate("measured", "yesterday") },
            new[] { @"""measurements"": 300", @"""measurements"": 2.5", ProfileMessages.NotWhole("measurements", 2.5) },
            new[] { @"""display_hz"": 60", @"""display_hz"": 60, ""display_hz"": 90", ProfileMessages.Twice("display_hz") },
            new[] { @"""display_hz"": 60", @"""display_hz"": 1e-12", SettingMessages.OutOfRange("display rate", 1e-12, " Hz", 1, 1000) },
        };

        [TestCaseSource(nameof(InvalidValues))]
        public void Read_InvalidValue_ThrowsWithTheReason(string part, string instead, string message)
        {
            Assert.That(Good, Does.Contain(part), "the text contains the part to replace");

            Assert.That(FaultOf(Good.Replace(part, instead)), Is.EqualTo("profile.json: " + message));
        }

        [Test]
        public void Read_RequiredFieldMissing_IsRefused()
        {
            foreach (var field in new[] { "visu_ms", "visu_spread_ms", "device", "display_hz", "measured", "method", "measurements" })
                Assert.That(
                    FaultOf(Good.Replace("\"" + field + "\"", "\"other\"")),
                    Is.EqualTo("profile.json: " + ProfileMessages.Missing(field)));
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
