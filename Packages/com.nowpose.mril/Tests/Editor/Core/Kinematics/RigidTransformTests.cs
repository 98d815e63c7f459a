using System;
using Nowpose.Kinematics;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Kinematics
{
    public class RigidTransformTests
    {
        [Test]
        public void FromXyzRpy_QuarterTurns_RotatesAboutFixedXThenYThenZ()
        {
            var pose = RigidTransform.FromXyzRpy(1, 2, 3, Math.PI / 2, Math.PI / 2, Math.PI / 2);

            // Images of the axes after the turns about x, y and z, computed by hand: x → x → −z → −z; y → z → x → y; z → −y → −y → x.
            Assert.That(pose.ToRowMajor16(), Is.EqualTo(new[]
            {
                0.0, 0, 1, 1,
                0, 1, 0, 2,
                -1, 0, 0, 3,
                0, 0, 0, 1,
            }).Within(1e-15));
        }

        [Test]
        public void FromXyzRpy_ThreeAngles_EqualsYawTimesPitchTimesRoll()
        {
            var product = RigidTransform.FromXyzRpy(0.1, 0.2, 0.3, 0, 0, 2.5)
                * RigidTransform.FromXyzRpy(0, 0, 0, 0, -0.7, 0)
                * RigidTransform.FromXyzRpy(0, 0, 0, 1.1, 0, 0);

            Assert.That(
                RigidTransform.FromXyzRpy(0.1, 0.2, 0.3, 1.1, -0.7, 2.5).ToRowMajor16(),
                Is.EqualTo(product.ToRowMajor16()).Within(1e-15));
        }

        [Test]
        public void Multiply_ThreePoses_IsAssociative()
        {
            var a = RigidTransform.FromXyzRpy(1, -2, 3, 0.1, 0.2, 0.3);
            var b = RigidTransform.FromXyzRpy(-4, 5, 6, -1, 2, -3);
            var c = RigidTransform.FromXyzRpy(7, 8, -9, 3, 1, 2);

            Assert.That(((a * b) * c).ToRowMajor16(), Is.EqualTo((a * (b * c)).ToRowMajor16()).Within(1e-14));
            Assert.That((a * RigidTransform.Identity).ToRowMajor16(), Is.EqualTo(a.ToRowMajor16()));
        }

        [Test]
        public void Inverse_MultipliedByThePose_IsTheIdentity()
        {
            var pose = RigidTransform.FromXyzRpy(0.4, -1.3, 2.2, 0.5, -0.9, 2.6);

            Assert.That((pose * pose.Inverse).ToRowMajor16(), Is.EqualTo(RigidTransform.Identity.ToRowMajor16()).Within(1e-12));
            Assert.That((pose.Inverse * pose).ToRowMajor16(), Is.EqualTo(RigidTransform.Identity.ToRowMajor16()).Within(1e-12));
        }
    }
}
