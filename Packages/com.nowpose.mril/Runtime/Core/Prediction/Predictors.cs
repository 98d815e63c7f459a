using System;
using System.Collections.Generic;
using Nowpose.Prediction.Gating;
using Nowpose.Prediction.Profiles;
using Nowpose.Prediction.Repetition;
using Nowpose.Prediction.Stacking;
using Nowpose.Prediction.Stamps;

namespace Nowpose.Prediction
{
    /// <summary>The predictors by the names that settings and command lines use.</summary>
    public static class Predictors
    {
        /// <summary>What is used where nothing is asked for: what errs least on motion nobody has seen before.</summary>
        public const string Default = "adaptive";

        // A repetition that is none is far off, a profile only a little; beside, both know the start of no move beforehand.
        const double TemplateGate = 0.3;
        const double ProfileGate = 0.8;

        /// <summary>All names: the polynomials in the order of their degree, then what learns from the motion.</summary>
        public static IReadOnlyList<string> Names { get; } = Array.AsReadOnly(new[]
        {
            "hold", "linear", "quadratic", "cubic", "quadratic-h3", "quadratic-h4", "adaptive"
        });

        /// <summary>A fresh predictor for one joint.</summary>
        /// <param name="name">One of <see cref="Names"/>, or a degree with another history h: linear-h4.</param>
        /// <param name="limits">Bounds of time and position.</param>
        /// <exception cref="InputException">There is no predictor of that name.</exception>
        public static IJointPredictor Create(string name, PredictionLimits limits) =>
            limits.IsEndless ? new UnwrappedPredictor(Plain(name, limits)) : Plain(name, limits);

        static IJointPredictor Plain(string name, PredictionLimits limits)
        {
            switch (name)
            {
                case "hold": return new HoldPredictor(limits);
                case "linear": return new PolynomialPredictor(1, 1, limits);
                case "quadratic": return new PolynomialPredictor(2, 2, limits);
                case "cubic": return new PolynomialPredictor(3, 3, limits);
                case "quadratic-h3": return new PolynomialPredictor(2, 3, limits);
                case "quadratic-h4": return new PolynomialPredictor(2, 4, limits);
                case "adaptive": return Adaptive(limits);
                default:
                    if (PolynomialName.TryRead(name, out var degree, out var history)) return new PolynomialPredictor(degree, history, limits);
                    throw new InputException("predictor '" + name + "' is unknown; there are " + string.Join(", ", Names)
                        + ", and linear, quadratic and cubic with -h and a history, as linear-h4");
            }
        }

        // Stamps are put right first; between samples the joint is where they say; ahead of them a cycle that repeats
        // speaks while it does, then a profile where the drive's limits are known, else what the mixture has learned.
        static DejitteredPredictor Adaptive(PredictionLimits limits)
        {
            IJointPredictor ahead = new StackedPredictor(limits);
            if (ProfilePredictor.HasLimits(limits)) ahead = new GatedPredictor(new ProfilePredictor(limits), ahead, ProfileGate);
            ahead = new GatedPredictor(new TemplatePredictor(limits), ahead, TemplateGate);
            return new DejitteredPredictor(new ThinnedPredictor(new InterpolatingPredictor(ahead, limits)));
        }
    }
}
