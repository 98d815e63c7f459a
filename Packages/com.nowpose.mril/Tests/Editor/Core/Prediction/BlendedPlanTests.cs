using System;
using Nowpose.Prediction;
using Nowpose.Prediction.Planning;
using NUnit.Framework;
using static Nowpose.Tests.Core.Prediction.BlendedSectionTests;

namespace Nowpose.Tests.Core.Prediction
{
    public class BlendedPlanTests
    {
        // The plan is offset from the predicted position. The test reads the displayed position at very short intervals. Its speed must not exceed
        // the speed of the motion plus that of the blend.
        [TestCase(1.2, 0.02, TestName = "Follow_PlanInTheFuture_StartsAndEndsWithoutAJump")]
        [TestCase(1.05, 0.02, TestName = "Follow_PlanAlreadyStarted_StartsAndEndsWithoutAJump")]
        public void Follow_Plan_StartsAndEndsWithoutAJump(double start, double beside)
        {
            const double step = 1e-4;
            var (blended, _) = Moving(1);
            var path = new JointPath(new[] { 0.0, 0.25 }, new[] { start + beside, start + beside + 0.25 }, new[] { 1.0, 1 });
            var last = blended.Show(1.1);
            blended.Follow(path, start);
            var (kinds, max) = (0, 0.0);
            for (var (i, k) = (0, 1); i * step < 0.6; i++)
            {
                var time = 1.1 + i * step;
                for (; 1 + k * Interval + 0.1 <= time; k++) blended.Add(1 + k * Interval, 1 + k * Interval);
                var shown = blended.Show(time);
                max = Math.Max(max, Math.Abs(shown.Position - last.Position));
                if (shown.Kind != last.Kind) kinds++;
                last = shown;
            }

            Assert.That(kinds, Is.EqualTo(2), "the kind changes to planned and back");
            Assert.That(max, Is.LessThan(1.05 * (1 + beside / TimeConstant) * step));
            Assert.That(last.Position, Is.EqualTo(1.1 + 0.6 - step).Within(1e-3));
        }

        [Test]
        public void Follow_PlanLongAfterTheNewestSample_DoesNotJump()
        {
            var (blended, _) = Moving(1);
            blended.Add(1 + Interval, 1 + Interval);
            var shown = blended.Show(1.33);

            blended.Follow(new JointPath(new[] { 0.0, 0.5 }, new[] { 1.25, 1.75 }, new[] { 1.0, 1 }), 1.2);

            Assert.That(blended.Show(1.33).Position, Is.EqualTo(shown.Position).Within(1e-12));
        }

        [Test]
        public void DropPlan_WhileFollowingThePlan_DoesNotJump()
        {
            var (blended, bare) = Moving(1);
            blended.Follow(new JointPath(new[] { 0.0, 1 }, new[] { 1.07, 2.07 }, new[] { 1.0, 1 }), 1.05);
            var shown = blended.Show(1.12);
            Assert.That(shown.Kind, Is.EqualTo(PredictionKind.Planned));

            blended.DropPlan();

            Assert.That(blended.Show(1.12).Position, Is.EqualTo(shown.Position).Within(1e-12));
            Assert.That(blended.Show(1.12).Kind, Is.EqualTo(PredictionKind.Predicted));
            Assert.That(blended.Show(1.2).Position, Is.EqualTo(bare.At(1.2).Position).Within(1e-4));
        }
    }
}
