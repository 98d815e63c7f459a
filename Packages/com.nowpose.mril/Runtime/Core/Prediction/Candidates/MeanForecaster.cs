using System;
using Nowpose.Prediction.Forecasting;
using Nowpose.Prediction.State;

namespace Nowpose.Prediction.Candidates
{
    /// <summary>Forecasts the mean of the newest samples while they only scatter.</summary>
    /// <remarks>
    /// The other forecasters would amplify the noise. A slow motion that is hidden in the noise leaves the mean behind, for which the gate rejects
    /// it.
    /// </remarks>
    sealed class MeanForecaster : Forecaster
    {
        readonly ScatterDetector _scatter;

        public MeanForecaster(int components) => _scatter = new ScatterDetector(components);

        public override bool Solve(MotionState motion)
        {
            _scatter.Add(motion.Displacements, motion.Connected);
            return _scatter.Scatters;
        }

        public override double At(double ahead, int component) => _scatter.Mean[component];

        public override void Reset() => _scatter.Reset();
    }

    /// <summary>Detects that samples only scatter about a position, because an encoder or a tracker has noise.</summary>
    /// <remarks>
    /// For white noise, the persistence (<see cref="Vectors.Persistence"/>) is −0.5, and the samples make no progress; a smooth motion has a
    /// persistence near 1, even at a reversal. The rest ends when a sample leaves the mean by a multiple of the <see cref="Noise"/>.
    /// </remarks>
    sealed class ScatterDetector
    {
        /// <summary>Number of newest samples that are examined.</summary>
        public const int Window = 12;

        /// <summary>Minimum number of samples for a decision.</summary>
        public const int MinSamples = 4;

        /// <summary>
        /// Limits for samples that scatter: maximum ratio of progress to path length, and maximum persistence. With a persistence of 0.05 or 0.155, the
        /// errors of simulated motions are 0.2 or 0.6 % larger.
        /// </summary>
        const double MaxProgress = 0.35, MaxPersistence = -0.05;

        /// <summary>
        /// Minimum distance of a sample that leaves the scattering samples from their mean, and from the last of them, relative to
        /// <see cref="Noise"/>. With half or twice this value, the mean errors change by at most 0.2 %.
        /// </summary>
        const double MinLeaveRatio = 4;

        /// <summary>
        /// Weight of a new window in <see cref="Noise"/>. The noise in a single window is small by chance at times.
        /// </summary>
        const double Smoothing = 1 / 16.0;

        readonly int _components;
        readonly double[] _mean;

        public ScatterDetector(int components) => (_components, _mean) = (components, new double[components]);

        /// <summary>Whether the newest samples only scatter; false for samples that do not differ.</summary>
        public bool Scatters { get; private set; }

        /// <summary>Mean distance between consecutive samples that only scattered, in rad or m; 0 before them, and after a gap or a jump.</summary>
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
            var hasLeft = Scatters && count > 1 && DistanceFromScatter(samples, count) > MinLeaveRatio * Noise;
            Scatters = count >= MinSamples && !hasLeft && IsScatter(samples, count);
            if (Scatters) ComputeMean(samples, 0, count);
        }

        public void Reset() => (Scatters, Noise) = (false, 0);

        // Distance of the newest sample from the mean of the others, or from the last of them if that is smaller.
        double DistanceFromScatter(double[] samples, int count)
        {
            ComputeMean(samples, 1, count);
            return Math.Min(Vectors.Length(_mean), Vectors.Distance(samples, 0, samples, _components, _components));
        }

        // Computes the mean, relative to the newest sample, of the samples from this one on.
        void ComputeMean(double[] samples, int first, int count)
        {
            Array.Clear(_mean, 0, _components);
            for (int i = first * _components, c = 0; i < count * _components; i++, c = (c + 1) % _components)
                _mean[c] += (samples[i] - samples[c]) / (count - first);
        }

        bool IsScatter(double[] samples, int count)
        {
            var (path, n, end) = (0.0, _components, (count - 1) * _components);
            for (var i = 0; i < end; i += n) path += Vectors.Distance(samples, i, samples, i + n, n);
            if (!(Vectors.Distance(samples, 0, samples, end, n) < MaxProgress * path)) return false;
            if (!(Vectors.Persistence(samples, count, n) < MaxPersistence)) return false;
            Noise += (path / (count - 1) - Noise) * (Noise > 0 ? Smoothing : 1);
            return true;
        }
    }
}
