using System;
using System.Collections.Generic;

namespace Nowpose.Latency.Sweep
{
    /// <summary>Mean of the middle 80 % of a set of numbers, with its standard error; the lowest and the highest 10 % may be outliers.</summary>
    /// <remarks>
    /// A median is unsuitable: if the times are multiples of the frame time, it jumps between the multiples and does not show how often
    /// each occurs.
    /// </remarks>
    readonly struct TrimmedMean
    {
        const double Cut = 0.1;

        public readonly double Mean;

        /// <summary>Standard error of <see cref="Mean"/>, for independent numbers.</summary>
        public readonly double Error;

        /// <param name="numbers">List that contains the numbers, in any order.</param>
        /// <param name="start">Index of the first number to use.</param>
        /// <param name="count">Number of values to use, 1 or more.</param>
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
