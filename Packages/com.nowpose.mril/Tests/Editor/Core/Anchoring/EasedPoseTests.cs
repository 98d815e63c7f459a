using System;
using Nowpose.Anchoring;
using Nowpose.Anchoring.Tracking;
using Nowpose.Kinematics;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Anchoring
{
    public class EasedPoseTests
    {
        static readonly RigidTransform Target = RigidTransform.FromXyzRpy(0.02, 0, 0, 0, 0, 0);

        static EasedPose Following(double easeSeconds)
        {
            var eased = new EasedPose(ClockTicks.Span(easeSeconds));
            eased.Jump(RigidTransform.Identity);
            eased.Follow(RigidTransform.Identity, HeadsetTime.FromSeconds(1));
            return eased;
        }

        [Test]
        public void Follow_FramesAt60Hz_ApproachesTheTargetWithoutAJump()
        {
            var eased = Following(0.8);
            var before = 0.0;

            for (var frame = 1; frame <= 48; frame++)
            {
                eased.Follow(Target, HeadsetTime.FromSeconds(1 + frame / 60.0));
                Assert.That(eased.Pose.Value.X - before, Is.InRange(0, 0.002), "frame " + frame);
                before = eased.Pose.Value.X;
            }

            Assert.That(before, Is.GreaterThan(0.97 * 0.02));
        }

        [Test]
        public void Follow_AfterAPause_ContinuesFromTheLastPose([Values(0.3, 2, 600)] double seconds)
        {
            var eased = Following(0.8);

            eased.Follow(Target, HeadsetTime.FromSeconds(1 + seconds));

            Assert.That(eased.Pose.Value.X, Is.InRange(0.002, 0.006));
        }

        [Test]
        public void Follow_ZeroEasingTime_JumpsToTheTarget()
        {
            var eased = Following(0);

            eased.Follow(Target, HeadsetTime.FromSeconds(1.01));

            Assert.That(eased.Pose.Value.X, Is.EqualTo(0.02).Within(1e-9));
        }
    }
}
