using System;
using NUnit.Framework;
using Nowpose.Kinematics;

namespace Nowpose.Tests.Core.Kinematics
{
    public class UnitQuaternionTests
    {
        [TestCase(0, 0, 0)]
        [TestCase(1e-12, 0, -2e-12)]
        [TestCase(3e-4, -2e-4, 5e-4)]
        [TestCase(1.1e-3, 0, 0)]
        [TestCase(0.3, -0.4, 1.2)]
        [TestCase(-1.5, 1.2, 0.4)]
        [TestCase(0, 3.14, 0)]
        [TestCase(0, 0, -3.1415926)]
        public void ExpAndLog_OfAVector_AgreeWithRodriguesFormulaAndAreInverse(double vx, double vy, double vz)
        {
            var vector = new Vector3D(vx, vy, vz);
            var angle = vector.Length;
            var (x, y, z) = angle == 0 ? (1.0, 0.0, 0.0) : (vx / angle, vy / angle, vz / angle);
            double s = Math.Sin(angle), v = 1 - Math.Cos(angle);

            var rotation = UnitQuaternion.Exp(vector);

            // Rodrigues: R = I + sin a K + (1 - cos a) K².
            var expected = new[]
            {
                1 - v * (y * y + z * z), v * x * y - s * z, v * x * z + s * y, 1,
                v * x * y + s * z, 1 - v * (x * x + z * z), v * y * z - s * x, 2,
                v * x * z - s * y, v * y * z + s * x, 1 - v * (x * x + y * y), 3,
                0, 0, 0, 1
            };
            Assert.That(rotation.At(1, 2, 3).ToRowMajor16(), Is.EqualTo(expected).Within(2e-15));
            Assert.That((rotation.Log() - vector).Length, Is.LessThan(2e-15));
        }

        // The textbook formula: (sin((1 - s) a) q0 + sin(s a) q1) / sin a, where cos a = q0 · q1 > 0.
        [TestCase(0)]
        [TestCase(0.25)]
        [TestCase(1)]
        [TestCase(1.7)]
        public void Slerp_TwoRotations_AgreesWithTheSineFormula(double share)
        {
            var from = Normalised(0.1, -0.5, 0.3, 0.8);
            var to = Normalised(0.4, -0.2, 0.6, 0.5);
            var angle = Math.Acos(from.X * to.X + from.Y * to.Y + from.Z * to.Z + from.W * to.W);
            double a = Math.Sin((1 - share) * angle) / Math.Sin(angle), b = Math.Sin(share * angle) / Math.Sin(angle);

            var between = UnitQuaternion.Slerp(from, to, share);

            Assert.That(between.X, Is.EqualTo(a * from.X + b * to.X).Within(1e-15));
            Assert.That(between.Y, Is.EqualTo(a * from.Y + b * to.Y).Within(1e-15));
            Assert.That(between.Z, Is.EqualTo(a * from.Z + b * to.Z).Within(1e-15));
            Assert.That(between.W, Is.EqualTo(a * from.W + b * to.W).Within(1e-15));
        }

        [Test]
        public void AngleBetween_OppositeSigns_IsZero()
        {
            var rotation = Normalised(0.1, -0.5, 0.3, 0.8);
            var opposite = Normalised(-0.1, 0.5, -0.3, -0.8);

            Assert.That(UnitQuaternion.AngleBetween(rotation, opposite), Is.LessThan(1e-15));
            Assert.That((opposite.Log() - rotation.Log()).Length, Is.LessThan(1e-15));
        }

        [Test]
        public void AngleBetween_RotationByAKnownAngle_ReturnsTheAngle()
        {
            var rotation = Normalised(0.1, -0.5, 0.3, 0.8);

            var turned = rotation * UnitQuaternion.Exp(new Vector3D(0.3, -0.6, 0.6));

            Assert.That(UnitQuaternion.AngleBetween(rotation, turned), Is.EqualTo(0.9).Within(1e-15));
        }

        [TestCase(0.9991, true)]
        [TestCase(1.0009, true)]
        [TestCase(0.9989, false)]
        [TestCase(1.0011, false)]
        [TestCase(0, false)]
        [TestCase(double.NaN, false)]
        [TestCase(double.PositiveInfinity, false)]
        public void TryNormalise_Length_IsAcceptedWithinTheTolerance(double length, bool isAccepted)
        {
            Assert.That(UnitQuaternion.TryNormalise(0.6 * length, 0, -0.8 * length, 0, out var rotation), Is.EqualTo(isAccepted));
            Assert.That(UnitQuaternion.LengthOf(rotation.X, rotation.Y, rotation.Z, rotation.W), Is.EqualTo(1).Within(1e-15));
        }

        static UnitQuaternion Normalised(double x, double y, double z, double w)
        {
            var length = UnitQuaternion.LengthOf(x, y, z, w);
            Assert.That(UnitQuaternion.TryNormalise(x / length, y / length, z / length, w / length, out var rotation), Is.True);
            return rotation;
        }
    }
}
