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

        /// <summary>Times that differ by less are the same, s: no joint moves far in a microsecond.</summary>
        const double SameTime = 1e-6;

        readonly double _perSecond;
        readonly double _noise;
        readonly double[] _times;
        readonly double[] _weights;
        readonly double[] _matrix;
        readonly double[] _map;
        bool _hasMap;

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
            _map = new double[ForecastGrid.Points * samples];
        }

        public int Samples { get; }

        /// <summary>Fills a table of <see cref="ForecastGrid"/> from the newest <see cref="Samples"/>; there must be so many.</summary>
        public void Forecast(SampleHistory history, double[] table, int start)
        {
            if (AreTimesAsBefore(history))
            {
                // The forecast is linear in the positions; of a periodic source the map is always the same.
                if (!_hasMap) FillMap();
                _hasMap = true;
                Apply(history, table, start);
                return;
            }
            _hasMap = false;
            Condition(history);
            for (var i = 0; i < ForecastGrid.Points; i++)
            {
                var x = i * ForecastGrid.Step;
                var sum = 0.0;
                for (var j = 0; j < Samples; j++) sum += (Kernel(x - _times[j]) + LevelVariance) * _weights[j];
                table[start + i] = sum;
            }
        }

        /// <summary>Forgets the times it has seen.</summary>
        public void Reset() => Array.Clear(_times, 0, Samples);

        bool AreTimesAsBefore(SampleHistory history)
        {
            var areSame = true;
            for (var i = 1; i < Samples; i++)
                areSame &= Math.Abs(history[i].Time - history[0].Time - _times[i]) < SameTime;
            return areSame;
        }

        // One column for each sample: the forecast from a position of 1 there and 0 elsewhere.
        void FillMap()
        {
            for (var sample = 1; sample < Samples; sample++)
            {
                FillMatrix();
                for (var i = 0; i < Samples; i++) _weights[i] = i == sample ? 1 : 0;
                Cholesky.Solve(_matrix, _weights, Samples);
                for (var i = 0; i < ForecastGrid.Points; i++)
                {
                    var sum = 0.0;
                    for (var j = 0; j < Samples; j++) sum += (Kernel(i * ForecastGrid.Step - _times[j]) + LevelVariance) * _weights[j];
                    _map[i * Samples + sample] = sum;
                }
            }
        }

        void Apply(SampleHistory history, double[] table, int start)
        {
            for (var j = 1; j < Samples; j++) _weights[j] = history[j].Position - history[0].Position;
            for (var i = 0; i < ForecastGrid.Points; i++)
            {
                var sum = 0.0;
                for (var j = 1; j < Samples; j++) sum += _map[i * Samples + j] * _weights[j];
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
            FillMatrix();
            Cholesky.Solve(_matrix, _weights, Samples);
        }

        void FillMatrix()
        {
            for (var i = 0; i < Samples; i++)
                for (var j = 0; j <= i; j++)
                    _matrix[i * Samples + j] = Kernel(_times[i] - _times[j]) + LevelVariance + (i == j ? _noise : 0);
        }

        double Kernel(double distance)
        {
            var r = Math.Abs(distance) * _perSecond;
            return (1 + r + 0.4 * r * r + r * r * r / 15) * Math.Exp(-r);
        }
    }
}
