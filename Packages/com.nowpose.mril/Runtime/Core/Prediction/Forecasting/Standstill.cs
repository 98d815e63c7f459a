using System;

namespace Nowpose.Prediction.Forecasting
{
    /// <summary>Detects a standstill without noise: two samples that differ by at most a thousandth of the recent maximum.</summary>
    struct Standstill
    {
        /// <summary>
        /// Maximum displacement between two samples at a standstill, relative to the recent maximum. With half or twice this value, the errors change
        /// by at most 0.2 %.
        /// </summary>
        const double StillRatio = 1e-3;

        /// <summary>
        /// Forgetting factor of the maximum displacement per sample: 1/e after 500 samples. With 0.995 or 0.999, the errors change by at most 0.1 %.
        /// </summary>
        const double MaxForgettingFactor = 0.998;

        /// <summary>Number of consecutive newest samples at a standstill.</summary>
        public int Samples { get; private set; }

        /// <summary>Recent maximum displacement between two samples, in the samples' unit.</summary>
        public double MaxDisplacement { get; private set; }

        /// <summary>Maximum displacement between two samples at a standstill, in the samples' unit.</summary>
        public double Distance => StillRatio * MaxDisplacement;

        /// <param name="displacement">Distance of the newest sample from the previous one.</param>
        public void Add(double displacement)
        {
            MaxDisplacement = Math.Max(MaxForgettingFactor * MaxDisplacement, displacement);
            Samples = displacement <= Distance ? Samples + 1 : 0;
        }
    }
}
