using System;
using NUnit.Framework;
using Nowpose.Prediction;
using Nowpose.Prediction.Candidates;
using Nowpose.Prediction.Forecasting;
using Nowpose.Prediction.Mixing;
using Nowpose.Prediction.State;
using static Nowpose.Tests.Core.Prediction.TestPredictors;

namespace Nowpose.Tests.Core.Prediction.Candidates
{
    public class CandidateGateTests
    {
        const double Interval = 0.05;
        const double Ahead = 0.1;

        Oracle _candidate;
        CandidateGate _gate;
        JointPredictor _gated, _mixture;

        bool IsOpen => !double.IsInfinity(_gate.ErrorRatio(isStill: false));

        [SetUp]
        public void CreateGate()
        {
            _candidate = new Oracle();
            _gate = new CandidateGate(0.3);
            _gated = Of(Mixture(new Candidate(_candidate, _gate)));
            _mixture = Of(Mixture());
        }

        [Test]
        public void At_AccurateCandidate_IsUsedAfterAFewScores()
        {
            Feed(0, 5);
            Assert.That(IsOpen, Is.False);

            Feed(5, 30);

            Assert.That(IsOpen);
            var t = 29 * Interval + Ahead;
            Assert.That(_gated.At(t).Position, Is.EqualTo(Truth(t)).Within(1e-9));
        }

        [Test]
        public void At_InaccurateCandidate_IsNeverUsed()
        {
            _candidate.Error = 0.5;
            for (var k = 0; k < 200; k++)
            {
                Feed(k, k + 1);

                Assert.That(_gated.At(k * Interval + Ahead), Is.EqualTo(_mixture.At(k * Interval + Ahead)));
            }
        }

        [Test]
        public void At_CandidateBecomesInaccurate_IsRejectedWithinASecond()
        {
            Feed(0, 100);
            Assert.That(IsOpen);

            _candidate.Error = 0.5;
            Feed(100, 120);

            Assert.That(IsOpen, Is.False);
        }

        [Test]
        public void At_CandidateWithoutSolution_UsesTheMixture()
        {
            Feed(0, 99);
            _candidate.IsSilent = true;
            Feed(99, 100);

            Assert.That(_gated.At(99 * Interval + Ahead), Is.EqualTo(_mixture.At(99 * Interval + Ahead)));
        }

        [Test]
        public void At_Rest_DoesNotOpenTheGate()
        {
            _candidate.Rest = 3;
            for (var k = 0; k < 200; k++) _gated.Add(k * Interval, 3);

            Assert.That(IsOpen, Is.False);
        }

        [Test]
        public void ErrorRatio_TwoAccurateCandidates_IsSmallerForTheBetter()
        {
            var worse = new CandidateGate(0.3);
            for (var i = 0; i < 20; i++)
            {
                _gate.Score(0.1, 1, 1, wasStill: false, time: 0);
                worse.Score(0.2, 1, 1, wasStill: false, time: 0);
            }

            Assert.That(_gate.ErrorRatio(isStill: false), Is.EqualTo(0.01).Within(1e-9));
            Assert.That(worse.ErrorRatio(isStill: false), Is.EqualTo(0.04).Within(1e-9));
            Assert.That(_gate.ErrorRatio(isStill: true), Is.EqualTo(double.PositiveInfinity), "forecasts made at a standstill are recorded separately");
        }

        [Test]
        public void ErrorRatio_GateWithARatioForUntestedCandidates_IsOpenUntilTheScoresAreWorse()
        {
            var gate = new CandidateGate(1, trustsUntested: true);
            Assert.That(gate.ErrorRatio(isStill: false), Is.EqualTo(1));

            for (var i = 0; i < 3; i++) gate.Score(0.2, 0.1, 1, wasStill: false, time: 0);

            Assert.That(gate.ErrorRatio(isStill: false), Is.EqualTo(double.PositiveInfinity));
        }

        // In the first cycle of a motion, no forecast of a start can be correct. Each later cycle has only two scores of a start.
        [Test]
        public void Score_FalseStartsInTheFirstCycle_HaveNoEffectAfterTwoCycles()
        {
            for (var i = 0; i < 40; i++) _gate.Score(0.5, 0.01, 0.5, wasStill: true, time: i * Interval);
            Assert.That(_gate.ErrorRatio(isStill: true), Is.EqualTo(double.PositiveInfinity));

            foreach (var start in new[] { 10.0, 20 })
            {
                _gate.Score(0.001, 0.01, 0.5, wasStill: true, time: start);
                _gate.Score(0.001, 0.02, 0.5, wasStill: true, time: start + Interval);
            }

            Assert.That(_gate.ErrorRatio(isStill: true), Is.LessThan(0.02));
        }

        [Test]
        public void Score_NotFinite_IsIgnored()
        {
            for (var i = 0; i < 20; i++) _gate.Score(0.1, 1, 1, wasStill: false, time: 0);

            _gate.Score(1e200, 1, 1e200, wasStill: false, time: 0);
            _gate.Score(double.NaN, 1, 1, wasStill: false, time: 0);

            Assert.That(_gate.ErrorRatio(isStill: false), Is.EqualTo(0.01).Within(1e-9));
        }

        [Test]
        public void Reset_OpenGate_ClosesIt()
        {
            Feed(0, 100);

            _gated.Reset();

            Assert.That(IsOpen, Is.False);
            Assert.That(_gated.At(0).Kind, Is.EqualTo(PredictionKind.None));
        }

        static double Truth(double t) => Math.Sin(3 * t);

        // Returns a mixture of hold and a straight line.
        static Mixture Mixture(params Candidate[] candidates) => new Mixture(1, PredictionLimits.Unlimited, new ForecasterSet(1), candidates,
            new ChangePointDetector(), new DistanceLimit(), measuresPersistence: false);

        void Feed(int from, int to)
        {
            for (var k = from; k < to; k++)
            {
                _gated.Add(k * Interval, Truth(k * Interval));
                _mixture.Add(k * Interval, Truth(k * Interval));
            }
        }

        // Forecasts the true motion, or the position `Rest` if it is set, plus `Error`.
        sealed class Oracle : Forecaster
        {
            double _newest;
            double _position;

            public double Error { get; set; }
            public bool IsSilent { get; set; }
            public double Rest { get; set; } = double.NaN;
            public override int UsedSamples => 1;

            public override bool Solve(MotionState motion)
            {
                (_newest, _position) = (motion.NewestTime, motion.Newest[0]);
                return !IsSilent;
            }

            public override double At(double ahead, int component) => (double.IsNaN(Rest) ? Truth(_newest + ahead) : Rest) + Error - _position;
        }
    }
}
