using Nowpose.Frames;
using Nowpose.Kinematics;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Frames
{
    public class PoseFadeTests
    {
        static RigidTransform At(double x, double yaw = 0) => RigidTransform.FromXyzRpy(x, 0, 0, 0, 0, yaw);

        [TestCase(0.01, 0)]
        [TestCase(0, 0.1)]
        public void At_VisibleDifference_FadesOut(double shift, double turn)
        {
            var fade = new PoseFade(5, At(shift, turn), At(0));

            Assert.That(fade.At(5, At(0)).X, Is.EqualTo(shift).Within(1e-12));
            Assert.That(UnitQuaternion.Of(fade.At(5, At(0))).Log().Length, Is.EqualTo(turn).Within(1e-9));
            var middle = fade.At(5 + PoseFade.Seconds / 2, At(0));
            Assert.That((middle.X, UnitQuaternion.Of(middle).Log().Length), Is.EqualTo((shift / 2, turn / 2)).Using<(double, double)>(
                (a, b) => System.Math.Abs(a.Item1 - b.Item1) + System.Math.Abs(a.Item2 - b.Item2) < 1e-9 ? 0 : 1));
            Assert.That(fade.At(5 + PoseFade.Seconds, At(0)).X, Is.Zero);
        }

        [TestCase(0.4, 1.5, true)] // 1.5 m/s for 0.3 s is 0.45 m
        [TestCase(0.5, 1.5, false)]
        [TestCase(0.4, 0.5, false)]
        [TestCase(1.1, 100, false)]
        public void At_LargeDifference_FadesOutOnlyIfTheSpeedExplainsIt(double shift, double speed, bool isContinuous) =>
            Assert.That(new PoseFade(5, At(shift), At(0), speed).At(5, At(0)).X, Is.EqualTo(isContinuous ? shift : 0).Within(1e-12));

        [TestCase(0.0015, 0.01)] // as small as the corrections by each sample
        [TestCase(0.5, 0)] // moved elsewhere
        public void At_TooSmallOrTooLargeDifference_ReturnsTheNewPoseImmediately(double shift, double turn) =>
            Assert.That(new PoseFade(5, At(shift, turn), At(0)).At(5, At(0)).X, Is.Zero);

        [Test]
        public void At_UnknownTime_IsTheNewPose() => Assert.That(new PoseFade(5, At(0.01), At(0)).At(double.NaN, At(0)).X, Is.Zero);
    }
}
