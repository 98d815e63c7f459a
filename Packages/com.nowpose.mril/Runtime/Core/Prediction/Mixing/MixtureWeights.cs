using System;

namespace Nowpose.Prediction.Mixing
{
    /// <summary>
    /// Weights of a mixture of forecasts that minimise the recent error; they are not negative, and their sum is one. Stacking
    /// (Wolpert 1992, Breiman 1996) with exponential forgetting.
    /// </summary>
    /// <remarks>
    /// Minimises ½ wᵀGw + ½ λ|w − prior|², where G averages the products of the forecasts' errors.
    /// </remarks>
    sealed class MixtureWeights
    {
        /// <summary>
        /// λ relative to the minimum mean square among the forecasts. With 0.2, the errors are 0.3 % (recordings) and 0.9 % (simulated) larger; with 0.05,
        /// those of recordings are 0.4 % larger.
        /// </summary>
        const double Regularisation = 0.1;

        /// <summary>
        /// Minimum root mean square of the errors for λ, in m or rad: smaller errors are invisible, and weights that were learned only from rounding
        /// would be unsuitable for the next motion. Without the minimum, vehicles that drive on a line and then turn had up to 2.4 times the error of a
        /// quadratic, with it 1.6 times. With 1e-6 or 1e-4, the errors on recordings are the same.
        /// </summary>
        const double MinError = 1e-5;

        /// <summary>
        /// Maximum number of steps per solve, each of which moves weight from one forecast to another. Few are sufficient, because each solve
        /// starts from the previous weights: ten change the errors on recordings by 0.02 %.
        /// </summary>
        const int Steps = 5;

        /// <summary>
        /// A solve ends at a step that reduces the mean square by less than this fraction of the best forecast's mean square. Such a gain has no
        /// visible effect, and the next solve continues from there.
        /// </summary>
        const double MinGain = 1e-4;

        /// <summary>
        /// Maximum difference of two gradients that count as equal, relative to the mean square of the best forecast. Each step makes two gradients equal,
        /// and several forecasts may be the same line. Rounding must not decide between them, because a replay would then differ from its session.
        /// </summary>
        const double SameRatio = 1e-8;

        readonly int _count;

        // The matrix G, row by row.
        readonly double[] _products;

        /// <param name="count">Number of forecasts; the first two are hold and the line.</param>
        public MixtureWeights(int count) => (_count, _products, Values) = (count, new double[count * count], new double[count]);

        /// <summary>The weights, one per forecast; valid from the first solve on.</summary>
        public double[] Values { get; }

        /// <summary>
        /// Sum of the weights of all errors so far: 0 at first, and after several time constants of the forgetting factor 1 for a joint, and 0.53 for
        /// an object, the mean of the shares of the errors.
        /// </summary>
        public double Evidence { get; private set; }

        /// <summary>Adds the errors of all forecasts for one sample.</summary>
        /// <param name="errors">Array that contains the errors from index <paramref name="first"/> on.</param>
        /// <param name="forgettingFactor">Forgetting factor of one error, 0 to 1.</param>
        /// <param name="share">Weight of the errors, 0 to 1.</param>
        public void Learn(double[] errors, int first, double forgettingFactor, double share)
        {
            var (products, gain) = (_products, share * (1 - forgettingFactor));
            for (int i = 0, row = 0; i < _count; i++, row += _count)
            {
                var error = gain * errors[first + i];
                // The matrix is symmetric.
                for (int j = 0, mirrored = i; j <= i; j++, mirrored += _count)
                    products[mirrored] = products[row + j] = forgettingFactor * products[row + j] + error * errors[first + j];
            }
            Evidence = forgettingFactor * Evidence + gain;
        }

        /// <summary>Solves for the weights. Without evidence, they are the prior.</summary>
        /// <param name="prior">Weights towards which the solution is regularised.</param>
        /// <param name="priorEvidence">
        /// Evidence as which the prior counts: at this <see cref="Evidence"/>, λ is twice its final value. Without it, the errors of the first samples
        /// alone would determine the weights.
        /// </param>
        /// <param name="square">
        /// Mean square of the displacement within one horizon at the present speed, per component, in m² or rad². If it is n times the mean square error
        /// of hold, the motion is faster than those that the weights have learned from, and their evidence counts one n-th. Otherwise, weights that were
        /// learned from noise at rest would hold an object that starts to move.
        /// </param>
        public void Solve(double[] prior, double priorEvidence, double square)
        {
            if (Evidence == 0)
            {
                Array.Copy(prior, Values, _count);
                return;
            }
            var min = double.PositiveInfinity;
            for (var i = 0; i < _products.Length; i += _count + 1)
                if (_products[i] < min) min = _products[i];
            var visible = MinError * MinError * Evidence;
            // n · min / Evidence, where n is square / (G₀₀ / Evidence). If a forecast was exact, as hold is after jumps without noise, it keeps its
            // weight.
            var fast = square * min / Math.Max(_products[0], visible);
            min = Math.Max(min, visible);
            var lambda = Regularisation * (min + priorEvidence * Math.Max(min / Evidence, fast));
            Span<double> gradient = stackalloc double[_count];
            for (int i = 0, at = 0; i < gradient.Length; i++)
            {
                gradient[i] = lambda * (Values[i] - prior[i]);
                for (var j = 0; j < _count; j++) gradient[i] += _products[at++] * Values[j];
            }
            for (var step = 0; step < Steps; step++)
                if (!(MoveBestPair(gradient, prior, lambda, SameRatio * min) > MinGain * min)) return;
        }

        public void Reset()
        {
            Array.Clear(_products, 0, _products.Length);
            Evidence = 0;
        }

        // Moves weight from the forecast with the largest gradient to the one with the smallest. Returns the reduction of the cost.
        double MoveBestPair(Span<double> gradient, double[] prior, double lambda, double same)
        {
            var (products, values) = (_products, Values);
            int to = 0, from = -1;
            double least = gradient[0], largest = double.NegativeInfinity;
            for (var i = 0; i < gradient.Length; i++)
            {
                var slope = gradient[i];
                if (IsTested(i, prior, same) && (slope < least - same || (slope <= least + same && values[i] < values[to])))
                    (to, least) = (i, Math.Min(slope, least));
                if (values[i] > 0 && (slope > largest + same || (slope >= largest - same && values[i] > values[from])))
                    (from, largest) = (i, Math.Max(slope, largest));
            }
            var difference = largest - least;
            if (from < 0 || !(difference > 0)) return 0;
            int toRow = to * _count, fromRow = from * _count;
            // The sum of the products is not negative, except for rounding.
            var curvature = Math.Max(products[toRow + to] + products[fromRow + from] - 2 * products[toRow + from], 0) + 2 * lambda;
            var move = Math.Min(difference / curvature, values[from]);
            values[to] += move;
            values[from] -= move;
            for (var i = 0; i < gradient.Length; i++) gradient[i] += move * (products[toRow + i] - products[fromRow + i]);
            gradient[to] += lambda * move;
            gradient[from] -= lambda * move;
            return move * (difference - 0.5 * move * curvature);
        }

        // The line replaces a forecast that has too few samples. While this was so for all errors, they show nothing about the forecast.
        bool IsTested(int forecast, double[] prior, double same) => forecast <= ForecasterSet.Line || prior[forecast] > 0
            || Math.Abs(_products[forecast * (_count + 1)] - _products[ForecasterSet.Line * (_count + 1)]) > same;
    }
}
