using System;
using System.Collections.Generic;

namespace Nowpose.Latency.Sweep
{
    /// <summary>Mean of the middle four fifths of some numbers, and how far they scatter; a tenth at either end may be anything.</summary>
    /// <remarks>Not a median: of times that come in whole frames it would be one or the other, however the two mix.</remarks>
    readonly struct TrimmedMean
    {
        const double Cut = 0.1;

        public readonly double Mean;

        /// <summary>Standard error of <see cref="Mean"/>, for numbers that are independent of each other.</summary>
        public readonly double Error;

        /// <param name="numbers">One or more, in any order.</param>
        public TrimmedMean(IReadOnlyList<double> numbers, int start, int count)
        {
            var sorted = new double[count];
            for (var i = 0; i < count; i++) sorted[i] = numbers[start + i];
            Array.Sort(sorted);
            var cut = (int)(Cut * count);
            double sum = 0, sumOfSquares = 0;
            for (var i = cut; i < count - cut; i++) sum += sorted[i];
            Mean = sum / (count - 2 * cut);
            foreach (var number in sorted)
            {
                var deviation = Math.Min(Math.Max(number, sorted[cut]), sorted[count - 1 - cut]) - Mean;
                sumOfSquares += deviation * deviation;
            }
            Error = Math.Sqrt(sumOfSquares) / ((1 - 2 * Cut) * count);
        }
    }
}
