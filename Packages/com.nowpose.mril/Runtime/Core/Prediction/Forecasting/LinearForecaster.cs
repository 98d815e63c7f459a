using System;
using Nowpose.Prediction.Samples;

namespace Nowpose.Prediction.Forecasting
{
    /// <summary>Forecasts a position as the weighted sum of the newest samples' positions.</summary>
    sealed class LinearForecaster : Forecaster
    {
        readonly PositionWeights _weights;
        readonly bool _stopsAtReversal;
        readonly double[] _positions, _weightsAtTime;

        /// <param name="weights">Weights, which other joints with the same sample times may share.</param>
        /// <param name="stopsAtReversal">
        /// Whether tables keep the forecast constant after a reversal, because drives stop far more often than they reverse.
        /// </param>
        public LinearForecaster(PositionWeights weights, bool stopsAtReversal = false)
        {
            (_weights, _stopsAtReversal) = (weights, stopsAtReversal);
            (_positions, _weightsAtTime) = (new double[weights.Samples], new double[weights.Samples]);
        }

        public override int Samples => _positions.Length;

        public override bool Solve(MotionState motion)
        {
            var count = Math.Min(motion.ConnectedSamples, Samples);
            return count >= _weights.MinSamples && Solve(motion.Samples, count);
        }

        /// <summary>Solves as if an earlier sample were the newest. The results are relative to this sample until the next solve.</summary>
        /// <inheritdoc cref="PositionWeights.Update"/>
        public bool Solve(SampleHistory<JointSample> samples, int count, int age = 0)
        {
            if (!_weights.Update(samples, count, age)) return false;
            var newest = samples[age].Position;
            for (var i = 0; i < count; i++) _positions[i] = samples[age + i].Position - newest;
            return true;
        }

        /// <remarks>Valid until the weights are updated for another joint.</remarks>
        /// <inheritdoc/>
        public override double At(double ahead)
        {
            var sum = 0.0;
            _weights.At(ahead, _weightsAtTime, 0);
            for (var i = 0; i < _weights.Count; i++) sum += _weightsAtTime[i] * _positions[i];
            return sum;
        }

        /// <inheritdoc/>
        public override void Fill(double[] table, int start, int points)
        {
            var (weights, positions) = (_weights.Table, _positions);
            for (int i = start, at = 0; i < start + points; i++, at += positions.Length)
            {
                var sum = 0.0;
                // The newest sample's position is zero.
                for (var j = 1; j < _weights.Count; j++) sum += weights[at + j] * positions[j];
                table[i] = sum;
            }
            if (_stopsAtReversal) Stop(table, start, points, Math.Sign(-_positions[1]));
        }

        static void Stop(double[] table, int start, int points, int direction)
        {
            for (var i = start + 1; i < start + points; i++)
            {
                if ((table[i] - table[i - 1]) * direction > 0) continue;
                direction = 0;
                table[i] = table[i - 1];
            }
        }
    }
}
