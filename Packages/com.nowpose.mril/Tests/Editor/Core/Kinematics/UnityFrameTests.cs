using System;
using Nowpose.Kinematics;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Kinematics
{
    public class UnityFrameTests
    {
        const double Tolerance = 1e-12;
        static readonly double HalfRoot = Math.Sqrt(0.5);

        [TestCase(1, 0, 0, 0, 0, 1, TestName = "ToUnity_Forward_IsZ")]
        [TestCase(0, 1, 0, -1, 0, 0, TestName = "ToUnity_Left_IsMinusX")]
        [TestCase(0, 0, 1, 0, 1, 0, TestName = "ToUnity_Up_IsY")]
        public void ToUnity_Axis_IsTheExpectedAxis(double x, double y, double z, double unityX, double unityY, double unityZ)
        {
            var pose = UnityFrame.ToUnity(RigidTransform.FromXyzRpy(x, y, z, 0, 0, 0));

            Assert.That(Numbers(pose), Is.EqualTo(new[] { unityX, unityY, unityZ, 0, 0, 0, 1 }));
        }

        // In Unity, a positive rotation is clockwise when seen from the tip of the axis. A left turn (+yaw about the up axis) is therefore
        // negative about Unity's y axis.
        [TestCase(0, 0, Math.PI / 2, 0, -1, 0, TestName = "ToUnity_YawLeft_IsMinusY")]
        [TestCase(0, Math.PI / 2, 0, 1, 0, 0, TestName = "ToUnity_PitchDown_IsPlusX")]
        [TestCase(Math.PI / 2, 0, 0, 0, 0, -1, TestName = "ToUnity_RollRight_IsMinusZ")]
        public void ToUnity_QuarterTurn_IsTheExpectedRotation(double roll, double pitch, double yaw, double x, double y, double z)
        {
            var pose = UnityFrame.ToUnity(RigidTransform.FromXyzRpy(0, 0, 0, roll, pitch, yaw));

            Assert.That(Numbers(pose), Is.EqualTo(new[] { 0, 0, 0, x * HalfRoot, y * HalfRoot, z * HalfRoot, HalfRoot }).Within(Tolerance));
        }

        [Test]
        public void ToUnity_Product_EqualsTheProductInUnity()
        {
            var random = new Random(11);
            for (var i = 0; i < 200; i++)
            {
                var (a, b) = (RandomPose(random), RandomPose(random));

                var expected = Product(UnityFrame.ToUnity(a), UnityFrame.ToUnity(b));

                Assert.That(Numbers(UnityFrame.ToUnity(a * b)), Is.EqualTo(expected).Within(Tolerance));
            }
        }

        [Test]
        public void FromUnity_ResultOfToUnity_ReturnsTheOriginalPose()
        {
            var random = new Random(12);
            for (var i = 0; i < 200; i++)
            {
                var pose = RandomPose(random);
                Assert.That(
                    UnityFrame.FromUnity(UnityFrame.ToUnity(pose)).ToRowMajor16(), Is.EqualTo(pose.ToRowMajor16()).Within(Tolerance));
            }
        }

        // The real part of the quaternion of a half turn is zero. Each of the other three components must then serve as the divisor.
        [TestCase(Math.PI, 0, 0)]
        [TestCase(0, Math.PI, 0)]
        [TestCase(0, 0, Math.PI)]
        [TestCase(3.1, 0.01, 0.02)]
        public void FromUnity_HalfTurnConvertedByToUnity_ReturnsTheOriginalPose(double roll, double pitch, double yaw)
        {
            var pose = RigidTransform.FromXyzRpy(1, 2, 3, roll, pitch, yaw);

            Assert.That(
                UnityFrame.FromUnity(UnityFrame.ToUnity(pose)).ToRowMajor16(), Is.EqualTo(pose.ToRowMajor16()).Within(Tolerance));
        }

        [Test]
        public void AxisConversion_RevoluteAndPrismaticJoint_MoveInUnityAsInTheUrdf()
        {
            var random = new Random(13);
            for (var i = 0; i < 50; i++)
            {
                var axis = UnitVector(random);
                var q = Any(random, Math.PI);
                var model = UrdfFiles.Read(UrdfFiles.Links("a", "b", "c")
                    + UrdfFiles.Joint("turn", "a", "b", "continuous", Axis(axis)) + UrdfFiles.Joint("slide", "a", "c", "prismatic", Axis(axis)));
                var poses = new RigidTransform[3];
                new ForwardKinematics(model).Compute(new[] { q, q }, poses);

                var (direction, about) = (UnityFrame.DirectionToUnity(axis), UnityFrame.TurningAxisToUnity(axis));

                var (s, c) = (Math.Sin(q / 2), Math.Cos(q / 2));
                var expected = Numbers(UnityFrame.ToUnity(poses[model.IndexOfLink("b")]));
                Assert.That(new[] { 0, 0, 0, s * about.X, s * about.Y, s * about.Z, c }, Is.EqualTo(expected).Within(Tolerance), "the rotation is the same");
                expected = Numbers(UnityFrame.ToUnity(poses[model.IndexOfLink("c")]));
                Assert.That(
                    new[] { q * direction.X, q * direction.Y, q * direction.Z, 0, 0, 0, 1 }, Is.EqualTo(expected).Within(Tolerance), "slid");
            }
        }

        static (double X, double Y, double Z) UnitVector(Random random)
        {
            var (x, y, z) = (Any(random, 1), Any(random, 1), Any(random, 1));
            var length = Math.Sqrt(x * x + y * y + z * z);
            return (x / length, y / length, z / length);
        }

        static string Axis((double X, double Y, double Z) axis) =>
            FormattableString.Invariant($"<axis xyz='{axis.X:R} {axis.Y:R} {axis.Z:R}'/><limit lower='-9' upper='9' velocity='1' effort='1'/>");

        static RigidTransform RandomPose(Random random) => RigidTransform.FromXyzRpy(
            Any(random, 2), Any(random, 2), Any(random, 2), Any(random, Math.PI), Any(random, Math.PI), Any(random, Math.PI));

        static double Any(Random random, double max) => (2 * random.NextDouble() - 1) * max;

        static double[] Numbers(UnityPose p) => new[] { p.X, p.Y, p.Z, p.RotationX, p.RotationY, p.RotationZ, p.RotationW };

        // Returns the product as Unity computes it: position = a.position + a.rotation * b.position, rotation = a.rotation * b.rotation.
        static double[] Product(UnityPose a, UnityPose b)
        {
            var turned = Multiply(Multiply(Rotation(a), new[] { b.X, b.Y, b.Z, 0 }), Conjugate(Rotation(a)));
            var r = Multiply(Rotation(a), Rotation(b));
            var sign = r[3] < 0 ? -1 : 1;
            return new[] { a.X + turned[0], a.Y + turned[1], a.Z + turned[2], sign * r[0], sign * r[1], sign * r[2], sign * r[3] };
        }

        static double[] Rotation(UnityPose p) => new[] { p.RotationX, p.RotationY, p.RotationZ, p.RotationW };

        static double[] Conjugate(double[] q) => new[] { -q[0], -q[1], -q[2], q[3] };

        static double[] Multiply(double[] a, double[] b) => new[]
        {
            a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1],
            a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
            a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3],
            a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2],
        };
    }
}
