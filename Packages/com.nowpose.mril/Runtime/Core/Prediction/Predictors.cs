using System;
using System.Collections.Generic;
using System.Globalization;
using Nowpose.Messages;
using Nowpose.Prediction.Forecasting;
using Nowpose.Prediction.Mixing;
using Nowpose.Prediction.Candidates;

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
        /// moves was 5 % larger. The error of a wrong profile is small.
        /// </summary>
        internal const double TemplateGate = 0.3;
        const double ProfileGate = 0.8;

        /// <summary>
        /// The same for repetitions at a standstill: the start of one of several moves may be correct by chance. With 0.3, the error of a
        /// robot with four moves in random order is 6 % larger.
        /// </summary>
        internal const double StartGate = 0.09;

        /// <summary>
        /// Weight of the line in the prior: on first moves of real machines, a Gaussian process alone overshoots more. On a welding robot, the error
        /// was 1.22 times that of the best fixed predictor without the line, and 1.01 times with it.
        /// </summary>
        internal const double LinePrior = 0.4;

        /// <summary>
        /// Prior weight of <see cref="ParabolaForecaster"/> for samples with velocity and acceleration. With exact values, the error of their Taylor
        /// series was 0.12 times that of hold, and that of the Gaussian process 0.14 times (T_s 50, L 100 ms).
        /// </summary>
        const double ReportedPrior = 0.7;

        /// <summary>Minimum interval between two comparisons with the history, in s: each sample at sampling intervals of 50 ms.</summary>
        const double MatchInterval = 0.035;

        const string HistoryMark = "-h";

        static readonly string[] Degrees = { "hold", "linear", "quadratic", "cubic" };

        /// <summary>
        /// All names: the polynomials in the order of their degree, then the polynomials with longer histories, then the predictors that learn.
        /// </summary>
        public static IReadOnlyList<string> Names { get; } = Array.AsReadOnly(new[]
        {
            "hold", "linear", "quadratic", "cubic", "quadratic-h3", "quadratic-h4", "gp", "adaptive"
        });

        /// <summary>Creates a predictor for one joint.</summary>
        /// <param name="name">One of <see cref="Names"/>, or a polynomial with another history, for example linear-h4.</param>
        /// <param name="limits">Bounds of time and position.</param>
        /// <param name="blend">
        /// Time constant of the blend between two sections, in s. It is reduced if samples arrive in
        /// quick succession. 0 means no blending: the joint jumps.
        /// </param>
        /// <exception cref="InputException">The name is unknown.</exception>
        public static JointPredictor Create(string name, PredictionLimits limits, double blend = 0) =>
            Create(name, limits, blend, new SharedForecasters());

        /// <inheritdoc cref="Create(string, PredictionLimits, double)"/>
        /// <param name="shared">Forecasters that this predictor shares with those of the robot's other joints.</param>
        internal static JointPredictor Create(string name, PredictionLimits limits, double blend, SharedForecasters shared)
        {
            if (name == "adaptive") return Adaptive(limits, PredictionParts.All, shared, blend);
            if (name == "gp") return new JointPredictor(new CalibratedProcess(), Kept, PredictionParts.Samples, limits, blend);
            var weights = Polynomial(name);
            return new JointPredictor(new LinearForecaster(weights), weights.Samples, PredictionParts.None, limits, blend);
        }

        /// <summary>Creates the weights of a polynomial.</summary>
        /// <param name="name">One of <see cref="Names"/>, or a polynomial with another history.</param>
        /// <exception cref="InputException">No polynomial has this name.</exception>
        internal static PolynomialWeights Polynomial(string name)
        {
            if (!TryReadPolynomial(name, out var degree, out var history))
                throw new InputException(PredictionMessages.UnknownPredictor(name, string.Join(", ", Names)));
            return new PolynomialWeights(degree, history);
        }

        /// <summary>Creates the default predictor from its parts; prediction.md lists the benefit of each part.</summary>
        /// <param name="shared">Forecasters that this predictor shares with those of other joints; null to create its own.</param>
        /// <param name="more">Additional forecasters of the mixture, for experiments.</param>
        internal static JointPredictor Adaptive(
            PredictionLimits limits, PredictionParts parts, SharedForecasters shared = null, double blend = 0, params Forecaster[] more)
        {
            shared ??= new SharedForecasters();
            var forecasters = more.Length > 0 ? Mixed(parts, more) : shared.Mixed ??= Mixed(parts, more);
            var candidates = new List<(Forecaster, CandidateGate)>();
            if (Has(parts, PredictionParts.Repetition))
                candidates.Add((new TemplateForecaster(limits.MaximumGap, MatchInterval), new CandidateGate(TemplateGate, StartGate)));
            if (Has(parts, PredictionParts.Profiles) && ProfileForecaster.HasLimits(limits))
                candidates.Add((new ProfileForecaster(limits), new CandidateGate(ProfileGate, ProfileGate)));
            return new JointPredictor(new Mixer(limits, parts, forecasters, candidates.ToArray()), Kept, parts, limits, blend);
        }

        static MixedForecasters Mixed(PredictionParts parts, Forecaster[] more)
        {
            var forecasters = new List<MixedForecaster>();
            if (Has(parts, PredictionParts.Quadratic)) forecasters.Add(new MixedForecaster(new LinearForecaster(new PolynomialWeights(2, 4))));
            if (Has(parts, PredictionParts.Cubic)) forecasters.Add(new MixedForecaster(new LinearForecaster(new PolynomialWeights(3, 3))));
            if (Has(parts, PredictionParts.Process))
                forecasters.Add(new MixedForecaster(
                    new LinearForecaster(new GaussianProcess(), stopsAtReversal: true), 1 - LinePrior, 1 - ReportedPrior));
            if (Has(parts, PredictionParts.Reported)) forecasters.Add(new MixedForecaster(new ParabolaForecaster(), 0, ReportedPrior));
            foreach (var forecaster in more) forecasters.Add(new MixedForecaster(forecaster));
            return new MixedForecasters(forecasters.ToArray(), Has(parts, PredictionParts.ChangePoints));
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
                && history >= degree && history <= PolynomialWeights.MaxHistory;
        }
    }
}
