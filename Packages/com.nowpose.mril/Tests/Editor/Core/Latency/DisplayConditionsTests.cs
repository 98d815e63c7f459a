using System.Linq;
using Nowpose.Latency;
using Nowpose.Latency.Conditions;
using Nowpose.Messages;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Latency
{
    public class DisplayConditionsTests
    {
        static DisplayConditions Calibrated(
            string device = "HoloLens 2", double? displayHz = 60, string api = "Direct3D11", string jobs = "MultiThreaded",
            string pipeline = "built-in", bool? rewrites = true, string optimization = "PrioritizeRendering",
            ReprojectionMode reprojection = ReprojectionMode.Depth) =>
            new DisplayConditions(device, displayHz, api, jobs, pipeline, rewrites, optimization, reprojection);

        [Test]
        public void MismatchesWith_SameConditions_IsEmpty()
        {
            Assert.That(Calibrated().MismatchesWith(Calibrated(device: "hololens 2", displayHz: 59.94)), Is.Empty);
        }

        [Test]
        public void MismatchesWith_EachConditionChanged_NamesFieldBothValuesAndRemedy()
        {
            var actual = Calibrated(
                "Quest 3", 72, "Vulkan", "NativeGraphicsJobs", "UniversalRenderPipelineAsset", false, "PrioritizeInputPolling",
                ReprojectionMode.OrientationOnly);

            var mismatches = Calibrated().MismatchesWith(actual);

            Assert.That(mismatches.Select(each => each.Field), Is.EqualTo(new[]
            {
                "device", "display_hz", "graphics_api", "graphics_jobs", "render_pipeline", "rewrite_before_render", "latency_optimization",
                "reprojection",
            }));
            Assert.That(mismatches.Select(each => each.Calibrated + " > " + each.Actual), Is.EqualTo(new[]
            {
                "HoloLens 2 > Quest 3", "60 > 72", "Direct3D11 > Vulkan", "MultiThreaded > NativeGraphicsJobs",
                "built-in > UniversalRenderPipelineAsset", "on > off", "PrioritizeRendering > PrioritizeInputPolling", "depth > orientation_only",
            }));
            foreach (var mismatch in mismatches)
                Assert.That(mismatch.Words, Does.Contain(mismatch.Calibrated).And.Contain(mismatch.Actual).And.Contain("; calibrate "));
            Assert.That(mismatches[2].Words, Is.EqualTo(
                ConditionMessages.Other("graphics API", "Direct3D11", "Vulkan", "Project Settings, Player")));
        }

        // The L_visu of another device or refresh rate does not apply to this device. The other conditions change L_visu by a few ms.
        [Test]
        public void IsRefusal_Mismatches_IsTrueOnlyForDeviceAndRate()
        {
            var mismatches = Calibrated().MismatchesWith(Calibrated("Quest 3", 72, "Vulkan", reprojection: ReprojectionMode.None));

            Assert.That(mismatches.Select(each => each.IsRefusal), Is.EqualTo(new[] { true, true, false, false }));
        }

        [Test]
        public void MismatchesWith_UnknownOnOneSide_IsEmpty()
        {
            Assert.That(Calibrated().MismatchesWith(DisplayConditions.Unknown), Is.Empty);
            Assert.That(DisplayConditions.Unknown.MismatchesWith(Calibrated()), Is.Empty);
            Assert.That(new DisplayConditions("", double.NaN, "").MismatchesWith(Calibrated()), Is.Empty);
        }

        [Test]
        public void Or_UnknownCondition_UsesTheOtherValue()
        {
            var both = new DisplayConditions(graphicsApi: "Vulkan", rewritesBeforeRender: false).Or(Calibrated());

            Assert.That(both, Is.EqualTo(Calibrated(api: "Vulkan", rewrites: false)));
            Assert.That(DisplayConditions.Unknown.Or(Calibrated()), Is.EqualTo(Calibrated()));
        }

        [Test]
        public void Constructor_TextWithLineBreakOrTooLong_ThrowsWithItsField()
        {
            Assert.That(() => Calibrated(api: "Direct3D\n11"),
                Throws.TypeOf<InputException>().With.Message.EqualTo(ConditionMessages.NotOneLine("graphics_api", "the value", 128)));
            Assert.That(() => Calibrated(pipeline: new string('x', 129)),
                Throws.TypeOf<InputException>().With.Message.StartsWith("render_pipeline: "));
        }
    }
}
