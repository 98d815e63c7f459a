using System;

namespace Nowpose.Prediction.Mixing
{
    /// <summary>
    /// Weights of a mixture of forecasts that minimise the recent error; none is negative and their sum is one. Stacking
    /// (Wolpert 1992, Breiman 1996) with exponential forgetting.
    /// </summary>
    /// <remarks>
    /// Minimises wᵀGw + λ|w − prior|², where G averages the products of the forecasts' errors. Allocates nothing after construction.
    /// </remarks>
    sealed class MixtureWeights
    {
        /// <summary>Pairwise steps per solve; few are enough, because each solve starts from the previous weights.</summary>
        const int Steps = 10;

        /// <summary>Number of samples whose evidence has the same weight as the prior.</summary>
        const double PriorSamples = 5;

        /// <summary>Thresholds below which weights and evidence, and squares, count as zero.</summary>
        const double Positive = 1e-9, Tiny = 1e-18;

        readonly int _count;
        readonly double _regularisation;
        readonly double[] _products;
        readonly double[] _gradient;

        /// <param name="regularisation">λ as a share of the minimum mean square among the forecasts.</param>
        /// <param name="prior">The weights without evidence, one per forecast.</param>
        public MixtureWeights(double regularisation, double[] prior)
        {
            _count = prior.Length;
            _regularisation = regularisation;
            _products = new double[_count * _count];
            _gradient = new double[_count];
            Values = (double[])prior.Clone();
        }

        /// <summary>The weights, one per forecast.</summary>
        public double[] Values { get; }

        /// <summary>Share of the memory that is filled, 0 to 1.</summary>
        public double Evidence { get; private set; }

        /// <summary>Returns the mean square of one forecast's error; 0 without evidence.</summary>
        public double MeanSquare(int forecast) => _products[forecast * (_count + 1)] / Math.Max(Evidence, Positive);

        /// <summary>Adds the errors of all forecasts at one moment.</summary>
        /// <param name="keeping">Forgetting factor, 0 to 1.</param>
        public void Learn(double[] errors, double keeping)
        {
            var share = 1 - keeping;
            for (var i = 0; i < _count; i++)
                for (var j = 0; j <= i; j++)
                {
                    var value = keeping * _products[i * _count + j] + share * errors[i] * errors[j];
                    _products[i * _count + j] = value;
                    _products[j * _count + i] = value;
                }
            Evidence = keeping * Evidence + share;
        }

        /// <summary>Solves for the weights.</summary>
        /// <param name="prior">Weights towards which the solution is regularised.</param>
        /// <param name="sampleShare">Share of the memory that one sample fills.</param>
        public void Solve(double[] prior, double sampleShare)
        {
            var least = double.PositiveInfinity;
            for (var i = 0; i < _count; i++) least = Math.Min(least, _products[i * (_count + 1)]);
            var pull = _regularisation * (least + Tiny) * (1 + PriorSamples * sampleShare / Math.Max(Evidence, Positive));
            FillGradient(prior, pull);
            for (var step = 0; step < Steps; step++)
                if (!MoveBestPair(pull)) return;
        }

        public void Reset(double[] prior)
        {
            Array.Clear(_products, 0, _products.Length);
            Array.Copy(prior, Values, _count);
            Evidence = 0;
        }

        void FillGradient(double[] prior, double pull)
        {
            for (var i = 0; i < _count; i++)
            {
                var sum = pull * (Values[i] - prior[i]);
                for (var j = 0; j < _count; j++) sum += _products[i * _count + j] * Values[j];
                _gradient[i] = sum;
            }
        }

        // Moves weight from the forecast with the largest gradient to the one with the smallest.
        bool MoveBestPair(double pull)
        {
            int to = 0, from = -1;
            for (var i = 0; i < _count; i++)
            {
                if (_gradient[i] < _gradient[to]) to = i;
                if (Values[i] > Positive && (from < 0 || _gradient[i] > _gradient[from])) from = i;
            }
            if (from < 0 || _gradient[from] <= _gradient[to]) return false;
            var curvature = _products[to * (_count + 1)] + _products[from * (_count + 1)] - 2 * _products[to * _count + from]
                + 2 * pull + Tiny;
            var move = Math.Min((_gradient[from] - _gradient[to]) / Math.Max(curvature, Tiny), Values[from]);
            Values[to] += move;
            Values[from] -= move;
            for (var i = 0; i < _count; i++) _gradient[i] += move * (_products[i * _count + to] - _products[i * _count + from]);
            _gradient[to] += pull * move;
            _gradient[from] -= pull * move;
            return true;
        }
    }
}
