using System;
using System.Collections.Generic;
using System.Globalization;
using Nowpose.Prediction.Forecasting;
using Nowpose.Prediction.Mixing;
using Nowpose.Prediction.Repetition;

namespace Nowpose.Prediction
{
    /// <summary>The predictors by the names that settings and command lines use.</summary>
    public static class Predictors
    {
        /// <summary>Default predictor: minimum error on unseen motions.</summary>
        public const string Default = "adaptive";

        /// <summary>Samples kept where more than a polynomial looks at them: what is laid over the history of a repeating motion.</summary>
        const int Kept = 24;

        /// <summary>
        /// Shares of the mixture's mean square below which a candidate replaces it: a false repetition is far off (with .36 a robot of
        /// ten different moves erred 5 % more), a profile only a little.
        /// </summary>
        const double TemplateGate = 0.3, ProfileGate = 0.8;

        /// <summary>Share of the line in the prior: on first moves of real machines a process alone overshoots more.</summary>
        const double ShareOfLine = 0.4;

        /// <summary>Share in the prior of the forecast from reported velocity and acceleration, where they are reported.</summary>
        const double ShareOfReported = 0.7;

        const string HistoryMark = "-h";

        static readonly string[] Degrees = { "hold", "linear", "quadratic", "cubic" };

        /// <summary>All names: the polynomials in the order of their degree, then what learns from the motion.</summary>
        public static IReadOnlyList<string> Names { get; } = Array.AsReadOnly(new[]
        {
            "hold", "linear", "quadratic", "cubic", "quadratic-h3", "quadratic-h4", "gp", "adaptive"
        });

        /// <summary>A fresh predictor for one joint.</summary>
        /// <param name="name">One of <see cref="Names"/>, or a degree with another history h: linear-h4.</param>
        /// <param name="limits">Bounds of time and position.</param>
        /// <param name="blend">
        /// Within which the difference between two sections falls to 1/e when one replaces the other, s; less where samples come in
        /// quick succession. 0: the joint jumps.
        /// </param>
        /// <exception cref="InputException">The name is unknown.</exception>
        public static JointPredictor Create(string name, PredictionLimits limits, double blend = 0)
        {
            if (name == "adaptive") return Adaptive(limits, PredictionParts.All, blend);
            if (name == "gp") return new JointPredictor(new CalibratedProcess(), Kept, PredictionParts.Samples, limits, blend);
            if (!TryReadPolynomial(name, out var degree, out var history))
                throw new InputException("predictor '" + name + "' is unknown; there are " + string.Join(", ", Names)
                    + ", and linear, quadratic and cubic with -h and a history, as linear-h4");
            return new JointPredictor(new PolynomialForecaster(degree, history), history + 1, PredictionParts.None, limits, blend);
        }

        /// <summary>Creates the mixture and its candidates; prediction.md lists the worth of each part.</summary>
        /// <param name="more">Further forecasters of the mixture, to be tried.</param>
        internal static JointPredictor Adaptive(PredictionLimits limits, PredictionParts parts, double blend = 0, params Forecaster[] more)
        {
            bool Has(PredictionParts part) => (parts & part) != 0;
            var shareOfLine = Has(PredictionParts.Process) ? ShareOfLine : 1;
            var forecasters = new List<MixedForecaster> { new MixedForecaster(new PolynomialForecaster(1, 1), shareOfLine) };
            if (Has(PredictionParts.Quadratic)) forecasters.Add(new MixedForecaster(new PolynomialForecaster(2, 4)));
            if (Has(PredictionParts.Cubic)) forecasters.Add(new MixedForecaster(new PolynomialForecaster(3, 3)));
            if (Has(PredictionParts.Process))
                forecasters.Add(new MixedForecaster(new GaussianProcess(stopsAtReversal: true), 1 - ShareOfLine, 1 - ShareOfReported));
            if (Has(PredictionParts.Reported)) forecasters.Add(new MixedForecaster(new ParabolaForecaster(usesReported: true), 0, ShareOfReported));
            foreach (var forecaster in more) forecasters.Add(new MixedForecaster(forecaster));
            var candidates = new List<CandidateGate>();
            if (Has(PredictionParts.Repetition)) candidates.Add(new CandidateGate(new TemplateForecaster(limits), TemplateGate));
            if (Has(PredictionParts.Profiles) && ProfileForecaster.HasLimits(limits))
                candidates.Add(new CandidateGate(new ProfileForecaster(limits), ProfileGate));
            return new JointPredictor(new Mixer(limits, parts, forecasters.ToArray(), candidates.ToArray()), Kept, parts, limits, blend);
        }

        // Degree and history that go together; histories go up to what a predictor takes.
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
