using System;

namespace Nowpose.Prediction.Mixing
{
    /// <summary>
    /// Weights of a mixture of forecasts, none negative and together one, that would have erred least lately: stacking
    /// (Wolpert 1992, Breiman 1996) with exponential forgetting.
    /// </summary>
    /// <remarks>
    /// Minimises wᵀGw + λ|w − prior|² where G averages the products of the forecasts' errors. Allocates nothing once made.
    /// </remarks>
    sealed class MixtureWeights
    {
        /// <summary>Pairwise steps per solve; each starts from the weights before, so that few are enough.</summary>
        const int Steps = 10;

        /// <summary>Number of samples whose evidence weighs as much as the prior.</summary>
        const double PriorSamples = 5;

        /// <summary>Weights and evidence below are zero, and squares below nothing.</summary>
        const double Positive = 1e-9, Tiny = 1e-18;

        readonly int _count;
        readonly double _regularisation;
        readonly double[] _products;
        readonly double[] _gradient;

        /// <param name="regularisation">λ as a share of the least mean square among the forecasts.</param>
        /// <param name="prior">The weights while nothing is known; as many as there are forecasts.</param>
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

        /// <summary>Mean square of one forecast's error; 0 while nothing is known.</summary>
        public double MeanSquare(int forecast) => _products[forecast * (_count + 1)] / Math.Max(Evidence, Positive);

        /// <summary>Takes in one moment's errors of all forecasts.</summary>
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
        /// <param name="prior">Weights to stay near.</param>
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

        // Weight goes from the forecast whose share costs most to the one whose share costs least.
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
