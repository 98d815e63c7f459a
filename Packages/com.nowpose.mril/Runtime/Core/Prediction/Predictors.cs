using System;
using System.Collections.Generic;
using System.Globalization;
using Nowpose.Messages;
using Nowpose.Prediction.Candidates;
using Nowpose.Prediction.Forecasting;
using Nowpose.Prediction.Mixing;
using Nowpose.Prediction.Samples;
using Nowpose.Prediction.State;

namespace Nowpose.Prediction
{
    /// <summary>Creates predictors by the names in settings and on command lines.</summary>
    public static class Predictors
    {
        /// <summary>Default predictor, which has the smallest error on unseen motions.</summary>
        public const string Default = "adaptive";

        /// <summary>
        /// Number of samples kept for predictors other than polynomials. <see cref="CalibratedProcess"/> needs the most: at 50 Hz, the samples of one
        /// horizon of up to 0.38 s and five before them. At higher rates, it calibrates with a shorter horizon.
        /// </summary>
        const int Kept = 24;

        /// <summary>
        /// Maximum ratio of a candidate's mean square error to the mixture's mean square error at which the candidate replaces the mixture. The
        /// limit for templates is smaller, because the error of a false repetition is large: with 0.36, the error for a robot with ten different
        /// moves was 5 % larger, and with 0.3 instead of its square at a standstill, that for four moves in random order 6 %.
        /// </summary>
        const double TemplateGate = 0.3;

        /// <summary>
        /// The same for moves with the profile of a drive, and for moves that brake as they have accelerated. A joint's braking is also used before it has been
        /// tested: the newest samples already show such a move. With 0.9 for objects, the mean errors of turns and carried objects are 1 % smaller, but some
        /// errors of rotations are up to 1.5 times those of the best fixed predictor.
        /// </summary>
        const double MoveGate = 0.9, ObjectBrakingGate = 0.5;

        /// <summary>
        /// The same for the mean of samples that only scatter, which also applies before it has been tested: with noise, the mixture cannot be better than
        /// the mean, unless a slow motion is hidden in the noise.
        /// </summary>
        const double MeanGate = 1;

        /// <summary>
        /// Prior weights of the Gaussian process and the quadratic through three samples; the line has the remainder. On first moves of real machines, a
        /// Gaussian process alone overshoots more. Without the quadratic, first turns of objects have 1.2 % larger errors; with 0.4 and 0.4, noisy trackers
        /// have up to 4 % larger errors.
        /// </summary>
        const double ProcessPrior = 0.55, QuadraticPrior = 0.15;

        /// <summary>
        /// Prior weight of <see cref="ReportedForecaster"/> for samples with velocity and acceleration. With exact values, the error of their Taylor
        /// series was 0.12 times that of hold, and that of the Gaussian process 0.14 times (T_s 50, L 100 ms).
        /// </summary>
        const double ReportedPrior = 0.7;

        /// <summary>
        /// Minimum interval between two comparisons of a joint with its history, in s: each sample at sampling intervals of 50 ms. The comparison of
        /// an object takes three times as long; with 0.035 s, the errors of simulated motions are 0.6 % smaller, and processing a sample at an
        /// interval of 50 ms takes up to a quarter more time.
        /// </summary>
        const double JointMatchInterval = 0.035, ObjectMatchInterval = 0.07;

        /// <summary>
        /// Minimum length of a jump, in m, and maximum acceleration of an object, in m/s². With 10 m/s², the errors of vehicles that start at once are
        /// 5 % larger.
        /// </summary>
        const double MinJump = 0.03, MaxAcceleration = 40;

        /// <summary>The same for the rotation, in rad and rad/s². With half or twice these values, the errors of objects change by less than 0.1 %.</summary>
        const double MinTurn = 0.1, MaxAngularAcceleration = 100;

        /// <summary>The newest sample, the reference for comparisons.</summary>
        internal const string Hold = "hold";

        const string HistoryMark = "-h";

        static readonly string[] Degrees = { Hold, "linear", "quadratic", "cubic" };

        /// <summary>
        /// All names: the polynomials in the order of their degree, then the polynomials with longer histories, then the predictors that learn.
        /// </summary>
        public static IReadOnlyList<string> Names { get; } = Array.AsReadOnly(new[]
        {
            Hold, "linear", "quadratic", "cubic", "quadratic-h3", "quadratic-h4", "gp", Default
        });

        /// <summary>Creates a predictor for one joint.</summary>
        /// <param name="name">One of <see cref="Names"/>, or a polynomial with another history, for example linear-h4.</param>
        /// <param name="limits">Bounds of time and position.</param>
        /// <param name="blend">
        /// Time constant of the blend between two sections, in s. It is reduced if samples arrive in
        /// quick succession. 0 means no blending: the joint jumps. Hold is never blended.
        /// </param>
        /// <exception cref="InputException">The name is unknown.</exception>
        public static JointPredictor Create(string name, PredictionLimits limits, double blend = 0) => Create(name, limits, blend, forecasters: null);

        /// <inheritdoc cref="Create(string, PredictionLimits, double)"/>
        /// <param name="forecasters">
        /// <see cref="ForecastersOfJoints"/>, which this predictor shares with those of the robot's other joints. Null to create forecasters for this joint
        /// only.
        /// </param>
        internal static JointPredictor Create(string name, PredictionLimits limits, double blend, ForecasterSet forecasters) => new JointPredictor(
            name == Default ? Joint(limits, PredictionParts.Joint, forecasters ?? ForecastersOfJoints()) : Named<JointSample>(name, 1, limits),
            limits, BlendOf(name, blend));

        /// <summary>Creates the default predictor from its parts; prediction.md lists the benefit of each part.</summary>
        /// <param name="more">Additional forecasters of the mixture, for experiments.</param>
        internal static JointPredictor Adaptive(PredictionLimits limits, PredictionParts parts, params Forecaster[] more) =>
            new JointPredictor(Joint(limits, parts, Forecasters(1, parts, more)), limits, blend: 0);

        /// <summary>Creates a joint's predictor with one forecaster, for experiments.</summary>
        /// <param name="kept">Number of samples to keep.</param>
        internal static JointPredictor Of(Forecaster forecaster, int kept, PredictionLimits limits, PredictionParts parts = PredictionParts.None) =>
            new JointPredictor(Pipeline<JointSample>(kept, limits, parts, new[] { forecaster }), limits, blend: 0);

        /// <summary>Creates the pipeline of an object: its position and its angles, with three components each.</summary>
        /// <param name="forecasters">
        /// <see cref="ForecastersOfObjects"/>, which this object shares with the other objects of the cell. Null to create forecasters for this object only.
        /// </param>
        /// <param name="parts">Parts of the default predictor.</param>
        /// <inheritdoc cref="Create(string, PredictionLimits, double)"/>
        internal static PredictionPipeline<TSample> OfAnObject<TSample>(string name, PredictionLimits limits, ForecasterSet forecasters, PredictionParts parts)
            where TSample : struct, ISample<TSample>
        {
            if (name != Default) return Named<TSample>(name, 2, limits);
            forecasters ??= ForecastersOfObjects(parts);
            Mixture Motion() => MixtureOf(3, limits, parts, forecasters, ObjectMatchInterval, new CandidateGate(ObjectBrakingGate));
            return Pipeline<TSample>(Kept, limits, parts, new Forecaster[] { Motion(), Motion() }, new PositionCheck[]
            {
                new ObjectPositionCheck(3, MinJump, MaxAcceleration), new ObjectPositionCheck(3, MinTurn, MaxAngularAcceleration)
            });
        }

        /// <summary>Returns the time constant of the blend for a predictor: none for hold, the reference for comparisons.</summary>
        internal static double BlendOf(string name, double blend) => name == Hold ? 0 : blend;

        /// <summary>Creates the forecasters that the predictors of one robot's joints share.</summary>
        internal static ForecasterSet ForecastersOfJoints() => Forecasters(1, PredictionParts.Joint);

        /// <summary>Creates the forecasters that the objects of one cell share.</summary>
        internal static ForecasterSet ForecastersOfObjects(PredictionParts parts = PredictionParts.Object) => Forecasters(3, parts);

        static PredictionPipeline<JointSample> Joint(PredictionLimits limits, PredictionParts parts, ForecasterSet forecasters)
        {
            var mixture = MixtureOf(1, limits, parts, forecasters, JointMatchInterval, new CandidateGate(MoveGate, trustsUntested: true));
            return Pipeline<JointSample>(Kept, limits, parts, new Forecaster[] { mixture }, new PositionCheck[] { new JointPositionCheck() });
        }

        static PredictionPipeline<TSample> Pipeline<TSample>(
            int kept, PredictionLimits limits, PredictionParts parts, Forecaster[] forecasters, PositionCheck[] checks = null)
            where TSample : struct, ISample<TSample>
        {
            var stamps = Has(parts, PredictionParts.StampCorrection) ? new StampCorrection(default(TSample).Components) : null;
            var buffer = new SampleBuffer<TSample>(kept, limits, stamps, Has(parts, PredictionParts.Thinning));
            return new PredictionPipeline<TSample>(
                buffer, forecasters, Has(parts, PredictionParts.Jumps) ? checks : null, limits, Has(parts, PredictionParts.Interpolation));
        }

        static Mixture MixtureOf(int components, PredictionLimits limits, PredictionParts parts, ForecasterSet forecasters,
            double matchInterval, CandidateGate braking)
        {
            var history = Has(parts, PredictionParts.Repetition | PredictionParts.Braking) ? new MotionHistory(components) : null;
            var candidates = new List<Candidate>();
            if (Has(parts, PredictionParts.Scatter))
                candidates.Add(new Candidate(new MeanForecaster(components), new CandidateGate(MeanGate, trustsUntested: true)));
            if (Has(parts, PredictionParts.Repetition))
                candidates.Add(new Candidate(new TemplateForecaster(history, matchInterval), new CandidateGate(TemplateGate)));
            if (Has(parts, PredictionParts.Braking)) candidates.Add(new Candidate(new BrakingForecaster(history), braking));
            if (Has(parts, PredictionParts.Profiles) && ProfileForecaster.HasLimits(limits))
                candidates.Add(new Candidate(new ProfileForecaster(limits), new CandidateGate(MoveGate)));
            return new Mixture(components, limits, forecasters, candidates.ToArray(),
                Has(parts, PredictionParts.ChangePoints) ? new ChangePointDetector() : null,
                Has(parts, PredictionParts.DistanceLimit) ? new DistanceLimit() : null, Has(parts, PredictionParts.Persistence));
        }

        // The fits with a history longer than their degree reduce noise. Of the others, the cubic does not stop at a reversal: with such a stop, the
        // errors on swings are up to 1.7 times as large.
        static ForecasterSet Forecasters(int components, PredictionParts parts, params Forecaster[] more)
        {
            var forecasters = new List<(Forecaster, double, double)>();
            Add(PredictionParts.Process, new GaussianProcess(stopsAtReversal: true), ProcessPrior, 1 - ReportedPrior);
            var quadratic = new PolynomialForecaster(2, 2, stopsAtReversal: true);
            // Reported velocities replace this quadratic, so that they are switched off with it.
            var withReported = Has(parts, PredictionParts.Reported) ? new ReportedForecaster(quadratic) : (Forecaster)quadratic;
            Add(PredictionParts.Quadratic, withReported, QuadraticPrior, ReportedPrior);
            Add(PredictionParts.Cubic, new PolynomialForecaster(3, 3));
            Add(PredictionParts.QuadraticOfFive, new PolynomialForecaster(2, 4));
            Add(PredictionParts.CubicOfSix, new PolynomialForecaster(3, 5));
            Add(PredictionParts.QuadraticOfTen, new PolynomialForecaster(2, 9));
            Add(PredictionParts.LineOfTen, new PolynomialForecaster(1, 9));
            foreach (var forecaster in more) forecasters.Add((forecaster, 0, 0));
            return new ForecasterSet(components, forecasters.ToArray());

            void Add(PredictionParts part, Forecaster forecaster, double prior = 0, double priorWhenReported = 0)
            {
                if (Has(parts, part)) forecasters.Add((forecaster, prior, priorWhenReported));
            }
        }

        // Creates a predictor other than the default one. Hold is a polynomial of degree 0, which has no solution: the newest position remains.
        static PredictionPipeline<TSample> Named<TSample>(string name, int motions, PredictionLimits limits) where TSample : struct, ISample<TSample>
        {
            var (components, forecasters) = (default(TSample).Components / motions, new Forecaster[motions]);
            var (isProcess, degree, history) = (name == "gp", 0, Kept - 1);
            if (!isProcess && !TryReadPolynomial(name, out degree, out history))
                throw new InputException(PredictionMessages.UnknownPredictor(name, string.Join(", ", Names)));
            for (var i = 0; i < motions; i++)
                forecasters[i] = isProcess ? new CalibratedProcess(components) : (Forecaster)new PolynomialForecaster(degree, history);
            // The maximum speed, from which the blend follows, needs three samples. Hold is never blended.
            var kept = history == 0 ? 1 : Math.Max(history + 1, 3);
            return Pipeline<TSample>(kept, limits, isProcess ? PredictionParts.Preparation : PredictionParts.None, forecasters);
        }

        static bool Has(PredictionParts parts, PredictionParts part) => (parts & part) != 0;

        // Accepts valid pairs of degree and history; a history is at most the maximum of a forecaster.
        static bool TryReadPolynomial(string name, out int degree, out int history)
        {
            var mark = name?.IndexOf(HistoryMark, StringComparison.Ordinal) ?? -1;
            degree = history = Array.IndexOf(Degrees, mark < 0 ? name : name.Substring(0, mark));
            if (mark < 0) return degree >= 0;
            return degree > 0
                && int.TryParse(name.AsSpan(mark + HistoryMark.Length), NumberStyles.None, CultureInfo.InvariantCulture, out history)
                && history >= degree && history <= PolynomialForecaster.MaxHistory;
        }
    }
}
