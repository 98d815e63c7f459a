using System;

namespace Nowpose.Prediction.State
{
    /// <summary>Detects samples that only scatter about a position, such as the samples of a noisy tracker or encoder at rest.</summary>
    /// <remarks>
    /// For white noise, the mean second difference is √3 times the mean first difference, and the samples make no progress; a smooth motion has small
    /// second differences, even at a reversal.
    /// </remarks>
    sealed class ScatterDetector
    {
        /// <summary>Number of newest samples that are examined.</summary>
        public const int Window = 12;

        /// <summary>Minimum number of samples for a decision.</summary>
        public const int MinSamples = 4;

        /// <summary>
        /// Limits for samples that scatter: maximum ratio of progress to path length, and minimum ratio of second to first differences. With 0.5 and 1.15,
        /// the errors of a linear axis are up to 20 % larger.
        /// </summary>
        const double MaxProgress = 0.35, MinRoughness = 1.3;

        /// <summary>
        /// Weight of a new window in <see cref="Noise"/>: the noise in a single window is small by chance at times.
        /// </summary>
        const double Smoothing = 1 / 16.0;

        readonly int _components;
        readonly double[] _mean;

        /// <param name="components">Number of components of a position.</param>
        public ScatterDetector(int components) => (_components, _mean) = (components, new double[components]);

        /// <summary>Whether the newest samples only scatter; false for samples that do not differ.</summary>
        public bool Scatters { get; private set; }

        /// <summary>Mean distance between consecutive samples that only scattered; 0 before them, and after a gap or a jump.</summary>
        public double Noise { get; private set; }

        /// <summary>Mean of the newest samples, relative to the newest one; valid while they only scatter.</summary>
        public ReadOnlySpan<double> Mean => _mean;

        /// <summary>Examines the samples after one has been added that is newer than all previous samples.</summary>
        /// <param name="samples">Positions, relative to any place, newest first; the components of a position are adjacent.</param>
        /// <param name="count">Number of newest samples without a gap or a jump.</param>
        public void Add(double[] samples, int count)
        {
            count = Math.Min(count, Window);
            if (count == 1) Noise = 0;
            Scatters = count >= MinSamples && IsScatter(samples, count);
            if (Scatters) ComputeMean(samples, count);
        }

        public void Reset()
        {
            Scatters = false;
            Noise = 0;
        }

        // Computes the mean, relative to the newest sample.
        void ComputeMean(double[] samples, int count)
        {
            Array.Clear(_mean, 0, _components);
            for (int i = 0, c = 0; i < count * _components; i++, c = (c + 1) % _components) _mean[c] += (samples[i] - samples[c]) / count;
        }

        bool IsScatter(double[] samples, int count)
        {
            double path = 0, bends = 0;
            for (int i = 0, end = (count - 1) * _components; i < end; i += _components)
            {
                var (squares, bend) = (0.0, 0.0);
                for (var at = i; at < i + _components; at++)
                {
                    var step = samples[at] - samples[at + _components];
                    squares += step * step;
                    if (i + _components == end) continue;
                    var difference = step - samples[at + _components] + samples[at + 2 * _components];
                    bend += difference * difference;
                }
                path += Math.Sqrt(squares);
                bends += Math.Sqrt(bend);
            }
            var (meanStep, progress) = (path / (count - 1), Vectors.Distance(samples, 0, samples, (count - 1) * _components, _components));
            if (!(progress < MaxProgress * path && bends / (count - 2) > MinRoughness * meanStep)) return false;
            Noise += (meanStep - Noise) * (Noise > 0 ? Smoothing : 1);
            return true;
        }
    }
}
