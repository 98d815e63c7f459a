using System;

namespace Nowpose.Prediction.Forecasting
{
    /// <summary>Forecasts a position as the weighted sum of the newest samples' positions.</summary>
    sealed class LinearForecaster : Forecaster
    {
        readonly PositionWeights _weights;
        readonly bool _stopsAtReversal;
        readonly double[] _weightsAtTime;

        // The samples of the last solve. The first of them is _age samples older than the newest one.
        MotionState _motion;
        int _age;

        /// <param name="weights">Weights, which other motions with the same sample times may share.</param>
        /// <param name="stopsAtReversal">
        /// Whether tables keep the forecast constant after a reversal, because drives stop far more often than they reverse.
        /// </param>
        public LinearForecaster(PositionWeights weights, bool stopsAtReversal = false)
        {
            (_weights, _stopsAtReversal) = (weights, stopsAtReversal);
            _weightsAtTime = new double[weights.Samples];
        }

        public override int Samples => _weights.Samples;

        public override bool Solve(MotionState motion) => Solve(motion, Math.Min(motion.Count, Samples));

        /// <summary>Solves as if an earlier sample were the newest. The results are relative to this sample until the next solve.</summary>
        /// <inheritdoc cref="PositionWeights.Update"/>
        public bool Solve(MotionState motion, int count, int age = 0)
        {
            (_motion, _age) = (motion, age);
            return count >= _weights.MinSamples && _weights.Update(motion.Times, count, age);
        }

        /// <remarks>Valid until the weights are updated for another motion.</remarks>
        /// <inheritdoc/>
        public override double At(double ahead, int component)
        {
            _weights.At(ahead, _weightsAtTime, 0);
            return Sum(_weightsAtTime, 0, component);
        }

        /// <inheritdoc/>
        public override void Fill(double[] table, int start, int points, int components)
        {
            var weights = _weights.Table;
            for (int point = 0, at = 0, i = start; point < points; point++, at += Samples)
                for (var c = 0; c < components; c++) table[i++] = Sum(weights, at, c);
            if (_stopsAtReversal) Stop(table, start, points, components);
        }

        double Sum(double[] weights, int at, int component)
        {
            var (positions, components, sum) = (_motion.Displacements, _motion.Components, 0.0);
            var i = _age * components + component;
            var newest = positions[i];
            for (var j = 1; j < _weights.Count; j++) sum += weights[at + j] * (positions[i += components] - newest);
            return sum;
        }

        void Stop(double[] table, int start, int points, int components)
        {
            var velocity = _motion.Velocity;
            var hasStopped = false;
            for (int point = 1, i = start + components; point < points; point++, i += components)
            {
                var progress = 0.0;
                for (var c = 0; c < components; c++) progress += (table[i + c] - table[i + c - components]) * velocity[c];
                hasStopped |= progress <= 0;
                if (hasStopped) Array.Copy(table, i - components, table, i, components);
            }
        }
    }
}
