using System;
using System.Collections.Generic;
using Nowpose.Messages;
using Nowpose.Sync.Envelope;
using Nowpose.Sync.Ransac;

namespace Nowpose.Sync
{
    /// <summary>Creates clock estimators by the names used in settings and on command lines.</summary>
    static class ClockEstimators
    {
        /// <summary>Name of the default estimator, <see cref="DefaultClockEstimator"/>.</summary>
        public const string Default = "default";

        /// <summary>Name of the paper's estimator, <see cref="RansacClockEstimator"/>.</summary>
        public const string Ransac = "ransac";

        public static IReadOnlyList<string> Names { get; } = Array.AsReadOnly(new[] { Default, Ransac });

        /// <summary>Creates an estimator.</summary>
        /// <param name="name">One of <see cref="Names"/>.</param>
        /// <param name="ransac">Constants of the paper's estimator; the default estimator ignores them. Null for the paper's values.</param>
        /// <exception cref="InputException">The name is unknown.</exception>
        public static IClockEstimator Create(string name, RansacSettings ransac = null)
        {
            switch (name)
            {
                case Default: return new DefaultClockEstimator();
                case Ransac: return new RansacClockEstimator(ransac ?? RansacSettings.Paper);
                default: throw new InputException(ClockMessages.UnknownEstimator(name, string.Join(", ", Names)));
            }
        }
    }
}
