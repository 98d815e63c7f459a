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
        const int MinSamples = 4;

        /// <summary>
        /// Limits for samples that scatter. MaxProgress: maximum ratio of progress to path length. MinRoughness: minimum ratio of second to first
        /// differences. With 0.5 and 1.15, the errors on recordings are 0.6 % larger.
        /// </summary>
        const double MaxProgress = 0.35, MinRoughness = 1.3;

        /// <summary>The same while the window is not full, so that the first samples of noise do not look like a motion.</summary>
        const double MaxFirstProgress = 0.7, MinFirstRoughness = 1;

        /// <summary>
        /// Minimum distance of the first sample of a motion from the mean of the scattering samples, and from the last of them, relative to
        /// their mean first difference, in the window or on average. Noise in one component exceeds this limit once in 10 000 samples, noise in two or
        /// three components not once in four million. With the window's mean alone, which is small by chance at times, it was once in 250 samples in
        /// one component. The direction of a shorter last step would depend mainly on the noise.
        /// </summary>
        const double MinStartRatio = 4;

        /// <summary>Weight of a new window in <see cref="Noise"/>. With half or twice this value, no error changes by 0.1 %.</summary>
        const double Smoothing = 1 / 16.0;

        readonly int _components;
        readonly double[] _mean;
        int _sinceScatter;
        double _meanStep;

        /// <param name="components">Number of components of a position.</param>
        public ScatterDetector(int components) => (_components, _mean) = (components, new double[components]);

        /// <summary>Whether the newest samples only scatter; false for samples that do not differ.</summary>
        public bool Scatters { get; private set; }

        /// <summary>Whether a motion starts: the newest sample has left the position about which the previous samples scattered.</summary>
        public bool HasLeft { get; private set; }

        /// <summary>
        /// Mean distance between consecutive samples that only scatter; 0 after a motion, a gap or a jump, and for samples that do not differ.
        /// </summary>
        public double Noise { get; private set; }

        /// <summary>Examines the samples after one has been added that is newer than all previous samples.</summary>
        /// <param name="samples">Positions, relative to any place, newest first; the components of a position are adjacent.</param>
        /// <param name="count">Number of newest samples without a gap or a jump.</param>
        public void Add(double[] samples, int count)
        {
            count = Math.Min(count, Window);
            if (count == 1) Noise = 0;
            HasLeft = Scatters && count > 1 && DistanceFromScatter(samples, count) > MinStartRatio * Math.Max(_meanStep, Noise);
            Scatters = count >= MinSamples && IsScatter(samples, count);
            _sinceScatter = Scatters ? 0 : Math.Min(_sinceScatter + 1, Window);
            if (_sinceScatter >= Window) Noise = 0;
            else if (Scatters) Noise += (_meanStep - Noise) * (Noise > 0 ? Smoothing : 1);
        }

        public void Reset()
        {
            Scatters = HasLeft = false;
            Noise = 0;
        }

        // Distance of the newest sample from the mean of the others, or from the last of them if that is smaller.
        double DistanceFromScatter(double[] samples, int count)
        {
            Array.Clear(_mean, 0, _components);
            for (var i = _components; i < count * _components; i++) _mean[i % _components] += samples[i] / (count - 1);
            return Math.Min(Vectors.Distance(samples, 0, _mean, 0, _components), Vectors.Distance(samples, 0, samples, _components, _components));
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
            _meanStep = path / (count - 1);
            var progress = Vectors.Distance(samples, 0, samples, (count - 1) * _components, _components);
            var (maxProgress, minRoughness) = count < Window ? (MaxFirstProgress, MinFirstRoughness) : (MaxProgress, MinRoughness);
            return progress < maxProgress * path && bends / (count - 2) > minRoughness * _meanStep;
        }
    }
}
