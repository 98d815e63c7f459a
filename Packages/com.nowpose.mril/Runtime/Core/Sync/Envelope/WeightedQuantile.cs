using System;

namespace Nowpose.Sync.Envelope
{
    /// <summary>Computes quantiles of weighted values. Sorts an internal copy once for all quantiles. Allocates nothing after construction.</summary>
    sealed class WeightedQuantile
    {
        readonly double[] _values;
        readonly double[] _weights;
        int _count;

        public WeightedQuantile(int most)
        {
            _values = new double[most];
            _weights = new double[most];
        }

        /// <summary>Replaces the values and their weights.</summary>
        /// <param name="count">At least 1.</param>
        public void Fill(double[] values, double[] weights, int count)
        {
            Array.Copy(values, _values, count);
            Array.Copy(weights, _weights, count);
            Array.Sort(_values, _weights, 0, count);
            _count = count;
        }

        /// <summary>Returns the smallest value that, together with all smaller values, has at least the given share of the total weight.</summary>
        /// <param name="share">0 to 1.</param>
        public double FromBelow(double share) => From(0, 1, share);

        /// <summary>Returns the largest value that, together with all larger values, has at least the given share of the total weight.</summary>
        /// <param name="share">0 to 1.</param>
        public double FromAbove(double share) => From(_count - 1, -1, share);

        double From(int first, int step, double share)
        {
            double wanted = 0, sum = 0;
            for (var i = 0; i < _count; i++) wanted += share * _weights[first + i * step];
            var at = first;
            for (var i = 1; i < _count && (sum += _weights[at]) < wanted; i++) at += step;
            return _values[at];
        }
    }
}
