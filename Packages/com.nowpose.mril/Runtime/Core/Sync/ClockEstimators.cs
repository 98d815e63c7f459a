using System;
using System.Collections.Generic;
using Nowpose.Sync.Envelope;

namespace Nowpose.Sync
{
    /// <summary>The clock estimators by the names that settings and command lines use.</summary>
    static class ClockEstimators
    {
        /// <summary>What is used where nothing is asked for: <see cref="EnvelopeClockEstimator"/>.</summary>
        public const string Default = "default";

        /// <summary>The paper's: <see cref="RansacClockEstimator"/>.</summary>
        public const string Ransac = "ransac";

        public static IReadOnlyList<string> Names { get; } = Array.AsReadOnly(new[] { Default, Ransac });

        /// <summary>A fresh estimator.</summary>
        /// <param name="name">One of <see cref="Names"/>.</param>
        /// <param name="ransac">Constants of the paper's, ignored by others; null for the paper's own.</param>
        /// <exception cref="InputException">There is no estimator of that name.</exception>
        public static IClockEstimator Create(string name, RansacSettings ransac = null)
        {
            switch (name)
            {
                case Default: return new EnvelopeClockEstimator();
                case Ransac: return new RansacClockEstimator(ransac ?? RansacSettings.Paper);
                default: throw new InputException("clock estimator '" + name + "' is unknown; there are " + string.Join(", ", Names));
            }
        }
    }
}
