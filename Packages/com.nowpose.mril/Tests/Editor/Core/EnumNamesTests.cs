using Nowpose.Latency;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Tests.Core
{
    public class EnumNamesTests
    {
        [Test]
        public void TryParse_NameOfAMode_ReturnsTheMode([Values] ReprojectionMode mode)
        {
            var name = LatencyNames.Reprojection.NameOf(mode);

            Assert.That(LatencyNames.Reprojection.TryParse(name, out var parsed), Is.True);
            Assert.That(parsed, Is.EqualTo(mode));
            Assert.That(LatencyNames.Reprojection.All, Does.Contain(name));
        }

        // Files contain these names, so a new name of a member must not change them.
        [Test]
        public void All_NamesInFiles_AreThoseOfEarlierVersions()
        {
            Assert.That(LatencyNames.Reprojection.All, Is.EqualTo("unknown, none, orientation_only, planar_manual, planar_from_depth, depth"));
            Assert.That(LatencyNames.RenderTimeSource.All, Is.EqualTo("display_gpu_time, engine_gpu_time, gpu_completion, camera_cpu"));
            Assert.That(LatencyNames.CalibrationMethod.All, Is.EqualTo("vlc, sine, nudge, manual"));
            Assert.That(LatencyNames.DepthSubmission.All, Is.EqualTo("unknown, active, turned_off, not_supported, no_main_camera, not_requested"));
            Assert.That(string.Join(", ", JointDataStates.Names), Is.EqualTo("live, rest, stale, refused, fault, missing"));
        }

        [Test]
        public void TryParse_OtherText_ReturnsFalseAndUnknown([Values(null, "", "Depth", "planar")] string name)
        {
            Assert.That(LatencyNames.Reprojection.TryParse(name, out var parsed), Is.False);
            Assert.That(parsed, Is.EqualTo(ReprojectionMode.Unknown));
        }
    }
}
