using Nowpose.Latency;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Latency
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

        [Test]
        public void TryParse_OtherText_ReturnsFalseAndUnknown([Values(null, "", "Depth", "planar")] string name)
        {
            Assert.That(LatencyNames.Reprojection.TryParse(name, out var parsed), Is.False);
            Assert.That(parsed, Is.EqualTo(ReprojectionMode.Unknown));
        }
    }
}
