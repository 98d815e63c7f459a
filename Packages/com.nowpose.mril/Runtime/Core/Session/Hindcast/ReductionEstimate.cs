using System;

namespace Nowpose.Session.Hindcast
{
    /// <summary>How much of the hold's error is removed, and how sure that is.</summary>
    /// <remarks>
    /// Errors of neighbouring frames are alike, so frames are no independent trials. Batches of about a second nearly are: the
    /// jackknife leaves out one after the other and looks how far the reduction moves. It fits a quotient of sums, to which
    /// batches at rest contribute nothing.
    /// </remarks>
    static class ReductionEstimate
    {
        /// <summary>Less than a tenth of a millimetre, or of a milliradian, the hold errs only at rest: of nothing nothing can be removed.</summary>
        const double LeastHoldRms = 1e-4;

        const int FewestBatches = 4;

        public static double? Of(in ErrorSums sums) =>
            sums.Count > 0 && sums.Held >= LeastHoldRms * LeastHoldRms * sums.Count ? Reduction(sums.Displayed, sums.Held) : (double?)null;

        /// <summary>Half-width of the 95 % confidence interval; null when motion lies in too few batches.</summary>
        public static double? UncertaintyOf(in ErrorSums total, ReadOnlySpan<ErrorSums> batches)
        {
            if (Of(total) == null) return null;
            var (count, sum, squares) = (0, 0.0, 0.0);
            foreach (ref readonly var batch in batches)
            {
                if (batch.Held < LeastHoldRms * LeastHoldRms * batch.Count || batch.Count == 0) continue;
                if (!(total.Held - batch.Held > 0)) return null;
                var without = Reduction(Math.Max(total.Displayed - batch.Displayed, 0), total.Held - batch.Held);
                count++;
                sum += without;
                squares += without * without;
            }
            if (count < FewestBatches) return null;
            var variance = Math.Max(squares - sum * sum / count, 0) * (count - 1) / count;
            return Student95(count - 1) * Math.Sqrt(variance);
        }

        static double Reduction(double displayed, double held) => 1 - Math.Sqrt(displayed / held);

        // The quantile of Student's distribution by its first terms in 1/ν (Abramowitz & Stegun 26.7.5): 1 % off at three.
        static double Student95(int freedom) => 1.960 + 2.372 / freedom + 2.823 / ((double)freedom * freedom);
    }
}
