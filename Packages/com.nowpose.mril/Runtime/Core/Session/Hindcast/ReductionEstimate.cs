using System;

namespace Nowpose.Session.Hindcast
{
    /// <summary>Estimates the fraction by which the compensation reduces the error of the hold, and the uncertainty of this fraction.</summary>
    /// <remarks>
    /// The errors of neighbouring frames are similar, so frames are not independent. Batches of about one second are nearly independent.
    /// The jackknife omits one batch at a time and evaluates the change of the reduction. It is suitable for a ratio of sums, to which
    /// batches at rest contribute nothing.
    /// </remarks>
    static class ReductionEstimate
    {
        /// <summary>Minimum RMS of the hold's error, 0.1 mm or 0.1 mrad. A smaller error occurs only at rest and cannot be reduced.</summary>
        const double MinHoldRms = 1e-4;

        const int MinBatches = 4;

        public static double? Of(in ErrorSums sums) =>
            sums.Count > 0 && sums.Held >= MinHoldRms * MinHoldRms * sums.Count ? Reduction(sums.Displayed, sums.Held) : (double?)null;

        /// <summary>Returns the half-width of the 95 % confidence interval; null when too few batches contain motion.</summary>
        public static double? UncertaintyOf(in ErrorSums total, ReadOnlySpan<ErrorSums> batches)
        {
            if (Of(total) == null) return null;
            var (count, sum, squares) = (0, 0.0, 0.0);
            foreach (ref readonly var batch in batches)
            {
                if (batch.Held < MinHoldRms * MinHoldRms * batch.Count || batch.Count == 0) continue;
                if (!(total.Held - batch.Held > 0)) return null;
                var without = Reduction(Math.Max(total.Displayed - batch.Displayed, 0), total.Held - batch.Held);
                count++;
                sum += without;
                squares += without * without;
            }
            if (count < MinBatches) return null;
            var variance = Math.Max(squares - sum * sum / count, 0) * (count - 1) / count;
            return Student95(count - 1) * Math.Sqrt(variance);
        }

        static double Reduction(double displayed, double held) => 1 - Math.Sqrt(displayed / held);

        /// <summary>
        /// Returns the 97.5 % quantile of Student's distribution. MathNet's function would search for it iteratively on the frame loop's thread.
        /// </summary>
        /// <remarks>
        /// Uses the series in 1/ν of Abramowitz &amp; Stegun 26.7.5 up to 1/ν⁴: 0.12 % too small at ν = 3, and more accurate for larger ν.
        /// </remarks>
        /// <param name="freedom">Degrees of freedom ν, 3 or more.</param>
        internal static double Student95(int freedom)
        {
            var inverse = 1.0 / freedom;
            return 1.95996 + inverse * (2.37227 + inverse * (2.82250 + inverse * (2.55585 + inverse * 1.58954)));
        }
    }
}
