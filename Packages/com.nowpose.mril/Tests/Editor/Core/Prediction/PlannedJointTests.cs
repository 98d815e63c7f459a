using System;
using System.Collections.Generic;
using Nowpose.Prediction;
using Nowpose.Prediction.Planning;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Prediction
{
    public class PlannedJointTests
    {
        const double Interval = 0.05;
        static readonly PredictionLimits Limits = new PredictionLimits(lower: -10, upper: 10);

        // Moves from 0 to 1 within one second from t = 5 on, at rest at both ends.
        static readonly JointPath Move = new JointPath(new[] { 0.0, 1 }, new[] { 0.0, 1 }, new[] { 0.0, 0 });

        static double Planned(double t)
        {
            var x = Math.Min(Math.Max(t - 5, 0), 1);
            return x * x * (3 - 2 * x);
        }

        // Plays samples 50 ms apart and one frame every 10 ms.
        static List<(double At, JointPrediction Shown)> Play(DisplayedJoint joint, double from, double to, Func<double, double> truth) =>
            joint.Play(k => new JointSample(k * Interval, truth(k * Interval)), from, to, 0.01);

        static DisplayedJoint New(PredictionLimits limits = null) => new DisplayedJoint(Predictors.Create("quadratic", limits ?? Limits));

        [Test]
        public void At_WithinThePlan_FollowsThePlan()
        {
            var joint = New();
            Play(joint, 4, 4.9, Planned);
            joint.Follow(Move, 5);

            foreach (var (at, shown) in Play(joint, 4.9, 6, Planned))
            {
                Assert.That(shown.Kind == PredictionKind.Planned, Is.EqualTo(at >= 5 - 1e-9), "at " + at);
                Assert.That(shown.Position, Is.EqualTo(Planned(at)).Within(1e-3), "at " + at);
            }
        }

        [TestCase(0.03, 0)]
        [TestCase(0.15, 0.004)]
        [TestCase(-0.02, -0.004)]
        public void At_JointLagsAndDeviatesFromThePlan_IsCorrected(double lag, double offset)
        {
            var joint = New();
            double Truth(double t) => Planned(t - lag) + offset;
            Play(joint, 4, 4.9, Truth);
            joint.Follow(Move, 5);
            // The delay is estimated during the first move. The second move, which leads back, is corrected from its start on.
            Play(joint, 4.9, 7, Truth);
            joint.Follow(new JointPath(new[] { 0.0, 1 }, new[] { 1.0, 0 }, new[] { 0.0, 0 }), 7.1);
            double Back(double t) => 1 - Planned(t - 2.1 - lag) + offset;

            foreach (var (at, shown) in Play(joint, 7, 8, Back))
                if (at > 7.12 + Math.Max(lag, 0))
                {
                    Assert.That(shown.Kind, Is.EqualTo(PredictionKind.Planned), "at " + at);
                    Assert.That(shown.Position, Is.EqualTo(Back(at)).Within(0.01), "at " + at);
                }
        }

        [Test]
        public void At_PlanEndsAtRest_HoldsItsEnd()
        {
            var joint = New();
            Play(joint, 4, 4.9, Planned);
            joint.Follow(Move, 5);
            Play(joint, 4.9, 6, Planned);

            var after = Play(joint, 6, 7, Planned);

            Assert.That(after.TrueForAll(s => Math.Abs(s.Shown.Position - 1) < 2e-3), "the end of the plan");
            Assert.That(after[5].Shown.Kind, Is.EqualTo(PredictionKind.Planned), "the samples are from the time of the move");
            Assert.That(after[40].Shown.Kind, Is.EqualTo(PredictionKind.Predicted), "samples after the end of the plan have arrived");
        }

        [Test]
        public void At_PlanEndsInMotion_PredictsAfterwards()
        {
            var joint = New();
            Play(joint, 4, 5, t => t);
            joint.Follow(new JointPath(new[] { 0.0, 1 }, new[] { 5.0, 6 }, new[] { 1.0, 1 }), 5);
            Play(joint, 5, 6, t => t);

            foreach (var (at, shown) in Play(joint, 6, 6.5, t => t))
            {
                if (at > 6.01) Assert.That(shown.Kind, Is.EqualTo(PredictionKind.Predicted), "at " + at);
                Assert.That(shown.Position, Is.EqualTo(at).Within(1e-3));
            }
        }

        [Test]
        public void At_JointStopsDuringThePlan_LeavesThePlanWithinTwoSamples()
        {
            var joint = New();
            double Truth(double t) => Planned(Math.Min(t, 5.5));
            Play(joint, 4, 4.9, Truth);
            joint.Follow(Move, 5);

            foreach (var (at, shown) in Play(joint, 4.9, 6.5, Truth))
                if (at > 5.7) Assert.That(shown.Kind, Is.Not.EqualTo(PredictionKind.Planned), "at " + at);
        }

        [Test]
        public void At_PreviousPlanNotFollowed_NewPlanRequiresFiveAgreeingSamples()
        {
            var joint = New();
            double Truth(double t) => Planned(Math.Min(t, 5.5)) + 0.5 * Planned(t - 2);
            Play(joint, 4, 4.9, Truth);
            joint.Follow(Move, 5);
            Play(joint, 4.9, 7, Truth);

            joint.Follow(new JointPath(new[] { 0.0, 1 }, new[] { 0.5, 1 }, new[] { 0.0, 0 }), 7);
            var shown = Play(joint, 7, 8, Truth);

            Assert.That(shown[10].Shown.Kind, Is.EqualTo(PredictionKind.Predicted));
            Assert.That(shown[60].Shown.Kind, Is.EqualTo(PredictionKind.Planned), "five samples agree");
        }

        [Test]
        public void Follow_LaterPlan_CompletesThePreviousPlan()
        {
            var joint = New();
            Play(joint, 4, 4.9, Planned);
            joint.Follow(Move, 5);
            Play(joint, 4.9, 5.4, Planned);
            joint.Follow(new JointPath(new[] { 0.0, 1 }, new[] { 1.0, 0 }, new[] { 0.0, 0 }), 6);
            double Truth(double t) => t < 6 ? Planned(t) : 1 - Planned(t - 1);

            foreach (var (at, shown) in Play(joint, 5.4, 7, Truth))
            {
                Assert.That(shown.Kind, Is.EqualTo(PredictionKind.Planned), "at " + at);
                Assert.That(shown.Position, Is.EqualTo(Truth(at)).Within(2e-3), "at " + at);
            }
        }

        [Test]
        public void Follow_FirstSetPointInTheFuture_StartsAtTheJointsPosition()
        {
            var joint = New();
            double Truth(double t) => t < 5 ? 0.4 : 0.4 + Math.Min(t - 5, 1) * 0.6;
            Play(joint, 4, 4.9, Truth);
            joint.Follow(new JointPath(new[] { 1.0 }, new[] { 1.0 }), 5);

            foreach (var (at, shown) in Play(joint, 4.9, 6, Truth))
                Assert.That(shown.Position, Is.EqualTo(Truth(at)).Within(2e-3), "at " + at);
        }

        // The joint follows a plan of constant velocity with a delay. The next plan continues it, and its first set-point is later than its start.
        [TestCase(0.08, 0)]
        [TestCase(0.15, 0.02)]
        public void Follow_JointLagsAndFirstSetPointIsInTheFuture_ContinuesTheMotion(double lag, double offset)
        {
            var joint = New();
            double Truth(double t) => Math.Min(Math.Max(t - lag - 5, 0), 4) + offset;
            Play(joint, 4, 4.9, Truth);
            joint.Follow(new JointPath(new[] { 0.0, 2 }, new[] { 0.0, 2 }), 5);
            Play(joint, 4.9, 6.9, Truth);
            joint.Follow(new JointPath(new[] { 0.5, 2 }, new[] { 2.5, 4 }), 7);

            foreach (var (at, shown) in Play(joint, 6.9, 8, Truth))
                Assert.That(shown.Position, Is.EqualTo(Truth(at)).Within(3e-3), "at " + at);
        }

        // A headset that connects during a move may receive the plan before the first sample.
        [TestCase(4.8)]
        [TestCase(5.4)]
        public void Follow_BeforeTheFirstSample_FollowsFromThisSampleOn(double connected)
        {
            var (joint, first) = (New(), (int)(connected / Interval));
            double Truth(double t) => 0.1 + 0.4 * Math.Min(Math.Max(t - 5, 0), 1) + 0.4 * Math.Min(Math.Max(t - 6, 0), 1);
            joint.Follow(new JointPath(new[] { 1.0, 2 }, new[] { 0.5, 0.9 }), 5);

            var shown = joint.Play(k => new JointSample((first + k) * Interval, Truth((first + k) * Interval)), connected + 0.11, 7, 0.01);

            foreach (var (at, joints) in shown)
            {
                Assert.That(joints.Kind == PredictionKind.Planned, Is.EqualTo(at >= 5 - 1e-9), "at " + at);
                Assert.That(joints.Position, Is.EqualTo(Truth(at)).Within(2e-3), "at " + at);
            }
        }

        [Test]
        public void Follow_NothingIsDisplayed_UsesEachPlanFromItsStartOn()
        {
            var predictor = Predictors.Create("quadratic", Limits);
            for (var k = 0; k <= 30; k++)
            {
                predictor.Add(k * Interval, k * Interval);
                if (k % 10 == 0) predictor.Follow(new JointPath(new[] { 0.0, 1 }, new[] { k / 10, k / 10 + 1.0 }), k / 10);
            }

            Assert.That(predictor.At(1.55).Kind, Is.EqualTo(PredictionKind.Planned), "the plan that started at 1 s");
            Assert.That(predictor.At(1.55).Position, Is.EqualTo(1.55).Within(1e-3));
        }

        [Test]
        public void At_TimeBeforeThePlan_IsPredictedEvenAfterAReadWithinThePlan()
        {
            var joint = New();
            Play(joint, 4, 5, Planned);
            joint.Follow(Move, 5);
            joint.Show(5.02);

            Assert.That(joint.Show(4.99).Kind, Is.EqualTo(PredictionKind.Predicted));
            Assert.That(joint.Show(4.99).Position, Is.EqualTo(0).Within(1e-3), "the start of the plan");
        }

        [Test]
        public void At_PlanBeyondTheJointsLimit_IsClamped()
        {
            var joint = New(new PredictionLimits(lower: 0, upper: 0.6));
            Play(joint, 4, 5, Planned);
            joint.Follow(Move, 5);

            foreach (var (_, shown) in Play(joint, 5, 6, Planned)) Assert.That(shown.Position, Is.InRange(0, 0.6));
        }

        [Test]
        public void DropPlanAndReset_WhileFollowingAPlan_EndThePlan()
        {
            var joint = New();
            Play(joint, 4, 5, Planned);
            joint.Follow(Move, 5);
            Play(joint, 5, 5.3, Planned);

            joint.DropPlan();
            Assert.That(joint.Show(5.31).Kind, Is.EqualTo(PredictionKind.Predicted));

            joint.Follow(Move, 5);
            joint.Predictor.Reset();
            Assert.That(joint.Show(5.32).Kind, Is.EqualTo(PredictionKind.None));
        }
    }
}
