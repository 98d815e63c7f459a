using Nowpose.Kinematics;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Kinematics
{
    public class JointLimitsTests
    {
        [TestCase(-2, -1)]
        [TestCase(0.5, 0.5)]
        [TestCase(7, 3)]
        public void Clamp_Position_ReturnsTheNearestAllowedPosition(double position, double expected)
        {
            Assert.That(new JointLimits(-1, 3, 1, 1).Clamp(position), Is.EqualTo(expected));
        }

        [Test]
        public void Contains_Bounds_ReturnsTrue()
        {
            var limits = new JointLimits(-1, 3, 1, 1);

            Assert.That(limits.Contains(-1) && limits.Contains(3), Is.True);
            Assert.That(limits.Contains(-1.0001) || limits.Contains(3.0001), Is.False);
        }

        [Test]
        public void None_AnyPosition_IsAllowed()
        {
            Assert.That(JointLimits.None.Clamp(-1e300), Is.EqualTo(-1e300));
            Assert.That(JointLimits.None.Contains(1e300), Is.True);
        }
    }
}
