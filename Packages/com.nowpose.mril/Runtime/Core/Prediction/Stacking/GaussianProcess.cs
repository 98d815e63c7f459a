using System;

namespace Nowpose.Prediction.Stacking
{
    /// <summary>
    /// Forecasts by a Gaussian process with a Matérn-7/2 kernel of unit variance plus a constant: motion whose third
    /// derivative is continuous, about a level nobody knows.
    /// </summary>
    /// <remarks>
    /// k(d) = (1 + r + 2r²/5 + r³/15) e⁻ʳ with r = √7 |d| / l (Rasmussen &amp; Williams 2006, section 4.2.1). Uneven intervals
    /// are as good as even ones. Allocates nothing once made.
    /// </remarks>
    sealed class GaussianProcess
    {
        /// <summary>Variance of the level, 100 times that of the motion about it.</summary>
        const double LevelVariance = 100;

        readonly double _perSecond;
        readonly double _noise;
        readonly double[] _times;
        readonly double[] _weights;
        readonly double[] _matrix;

        /// <param name="lengthScale">l in s: how long the motion remembers its course.</param>
        /// <param name="noise">Variance of the samples' noise over that of the motion.</param>
        /// <param name="samples">How many of the newest samples it looks at.</param>
        public GaussianProcess(double lengthScale, double noise, int samples)
        {
            _perSecond = Math.Sqrt(7) / lengthScale;
            _noise = noise;
            Samples = samples;
            _times = new double[samples];
            _weights = new double[samples];
            _matrix = new double[samples * samples];
        }

        public int Samples { get; }

        /// <summary>Fills a table of <see cref="ForecastGrid"/> from the newest <see cref="Samples"/>; there must be so many.</summary>
        public void Forecast(SampleHistory history, double[] table, int start)
        {
            Condition(history);
            for (var i = 0; i < ForecastGrid.Points; i++)
            {
                var x = i * ForecastGrid.Step;
                var sum = 0.0;
                for (var j = 0; j < Samples; j++) sum += (Kernel(x - _times[j]) + LevelVariance) * _weights[j];
                table[start + i] = sum;
            }
        }

        void Condition(SampleHistory history)
        {
            ref readonly var newest = ref history[0];
            for (var i = 0; i < Samples; i++)
            {
                _times[i] = history[i].Time - newest.Time;
                _weights[i] = history[i].Position - newest.Position;
            }
            for (var i = 0; i < Samples; i++)
                for (var j = 0; j <= i; j++)
                    _matrix[i * Samples + j] = Kernel(_times[i] - _times[j]) + LevelVariance + (i == j ? _noise : 0);
            Cholesky.Solve(_matrix, _weights, Samples);
        }

        double Kernel(double distance)
        {
            var r = Math.Abs(distance) * _perSecond;
            return (1 + r + 0.4 * r * r + r * r * r / 15) * Math.Exp(-r);
        }
    }
}
