using System;

namespace Nowpose.Sync.Envelope
{
    /// <summary>Computes quantiles of weighted values. Sorts an internal copy, so that a computation allocates nothing.</summary>
    sealed class WeightedQuantile
    {
        readonly double[] _values;
        readonly double[] _weights;

        public WeightedQuantile(int most)
        {
            _values = new double[most];
            _weights = new double[most];
        }

        /// <summary>Returns the smallest value that, together with all smaller values, has at least the given share of the total weight.</summary>
        /// <param name="share">0 to 1.</param>
        /// <param name="count">At least 1.</param>
        public double Of(double[] values, double[] weights, int count, double share)
        {
            Array.Copy(values, _values, count);
            Array.Copy(weights, _weights, count);
            Array.Sort(_values, _weights, 0, count);
            double wanted = 0, sum = 0;
            for (var i = 0; i < count; i++) wanted += share * _weights[i];
            for (var i = 0; i < count; i++)
            {
                sum += _weights[i];
                if (sum >= wanted) return _values[i];
            }
            return _values[count - 1];
        }
    }
}
