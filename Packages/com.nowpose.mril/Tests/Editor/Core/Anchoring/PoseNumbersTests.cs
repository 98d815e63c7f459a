using System;
using Nowpose.Anchoring;
using Nowpose.Kinematics;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Anchoring
{
    public class PoseNumbersTests
    {
        [Test]
        public void RotationVector_AnyRotation_HasItsAxisAndAngle()
        {
            foreach (var angle in new[] { 0, 1e-10, 1e-6, 0.3, 2, Math.PI - 1e-6, Math.PI - 1e-10, Math.PI })
                foreach (var (x, y, z) in new[] { (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0), (0.6, -0.8, 0.0), (0.48, 0.6, -0.64) })
                {
                    var turn = PoseNumbers.Turn(angle * x, angle * y, angle * z);

                    var vector = turn.RotationVector();

                    Assert.That(PoseNumbers.Length(vector.X, vector.Y, vector.Z), Is.EqualTo(angle).Within(1e-9));
                    var back = PoseNumbers.Turn(vector.X, vector.Y, vector.Z);
                    Assert.That(back.AngleTo(turn), Is.LessThan(1e-8), angle + " rad about " + (x, y, z));
                }
        }

        [Test]
        public void Between_PosesHalfATurnApart_StaysOnTheAxis()
        {
            var half = PoseNumbers.Between(RigidTransform.Identity, RigidTransform.FromXyzRpy(0, 0, 0, 0, 0, Math.PI), 0.5);

            Assert.That(Math.Abs(half.R22), Is.EqualTo(1).Within(1e-9), "the z axis stays upright");
        }
    }
}
