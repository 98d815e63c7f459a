using System;
using Nowpose.Prediction.Forecasting;

namespace Nowpose.Prediction.State
{
    /// <summary>Detects how a motion rests: its samples repeat exactly, or they only scatter about a position.</summary>
    /// <remarks>
    /// <para>Samples repeat (<see cref="IsStill"/>) if the source has no noise. The next sample may be the start of a move, so gates have separate scores for
    /// forecasts from such a rest, and template matching, braking and profiles begin a new move after it.</para>
    /// <para>Samples only scatter (<see cref="Scatters"/>) if an encoder or a tracker has noise. Their mean is then forecast, until a
    /// sample leaves it by a multiple of their <see cref="Noise"/>. For white noise, the mean second difference is √3 times the mean first difference, and the
    /// samples make no progress; a smooth motion has small second differences, even at a reversal.</para>
    /// </remarks>
    sealed class RestDetector
    {
        /// <summary>
        /// Maximum displacement between two samples that repeat, relative to that at the maximum speed: the first samples of a move exceed it. With
        /// 1e-3, the errors of simulated motions are 0.6 % larger.
        /// </summary>
        const double StillRatio = 1e-4;

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
        /// Minimum distance of a sample that leaves the scattering samples from their mean, and from the last of them, relative to <see cref="Noise"/>. With
        /// half or twice this value, the mean errors change by at most 0.2 %.
        /// </summary>
        const double MinLeaveRatio = 4;

        /// <summary>
        /// Weight of a new window in <see cref="Noise"/>. The noise in a single window is small by chance at times.
        /// </summary>
        const double Smoothing = 1 / 16.0;

        readonly int _components;
        readonly double[] _mean;

        public RestDetector(int components) => (_components, _mean) = (components, new double[components]);

        /// <summary>Whether the newest sample repeats the one before it: their distance is at most <see cref="StillDistance"/>.</summary>
        public bool IsStill => StillSamples > 0;

        /// <summary>Number of newest samples that repeat the one before them.</summary>
        public int StillSamples { get; private set; }

        /// <summary>Maximum displacement between two samples that repeat, in the samples' unit.</summary>
        public double StillDistance { get; private set; }

        /// <summary>Whether the newest samples only scatter; false for samples that do not differ.</summary>
        public bool Scatters { get; private set; }

        /// <summary>Mean distance between consecutive samples that only scattered; 0 before them, and after a gap or a jump.</summary>
        public double Noise { get; private set; }

        /// <summary>Mean of the newest samples, relative to the newest one; valid while they only scatter.</summary>
        public ReadOnlySpan<double> Mean => _mean;

        /// <summary>Adds the displacement to a sample that is newer than all previous samples.</summary>
        /// <param name="maxDisplacement">Displacement in the same interval at the maximum speed.</param>
        public void AddDisplacement(double displacement, double maxDisplacement)
        {
            StillDistance = StillRatio * maxDisplacement;
            StillSamples = displacement <= StillDistance ? Math.Min(StillSamples, int.MaxValue - 1) + 1 : 0;
        }

        /// <summary>Examines the noise of the samples after one has been added that is newer than all previous samples.</summary>
        /// <param name="samples">Positions, relative to any place, newest first; the components of a position are adjacent.</param>
        /// <param name="count">Number of newest samples without a gap or a jump.</param>
        public void AddNoise(double[] samples, int count)
        {
            count = Math.Min(count, Window);
            if (count == 1) Noise = 0;
            var hasLeft = Scatters && count > 1 && DistanceFromScatter(samples, count) > MinLeaveRatio * Noise;
            Scatters = count >= MinSamples && !hasLeft && IsScatter(samples, count);
            if (Scatters) ComputeMean(samples, 0, count);
        }

        public void Reset()
        {
            Scatters = false;
            Noise = StillDistance = 0;
            StillSamples = 0;
        }

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
            double path = 0, bends = 0;
            var (n, end) = (_components, (count - 1) * _components);
            for (var i = 0; i < end; i += n) path += Vectors.Distance(samples, i, samples, i + n, n);
            if (!(Vectors.Distance(samples, 0, samples, end, n) < MaxProgress * path)) return false;
            for (var i = 0; i < end - n; i += n)
            {
                var squares = 0.0;
                for (var at = i; at < i + n; at++)
                {
                    var difference = samples[at] - samples[at + n] - samples[at + n] + samples[at + 2 * n];
                    squares += difference * difference;
                }
                bends += Math.Sqrt(squares);
            }
            var meanStep = path / (count - 1);
            if (!(bends / (count - 2) > MinRoughness * meanStep)) return false;
            Noise += (meanStep - Noise) * (Noise > 0 ? Smoothing : 1);
            return true;
        }
    }

    /// <summary>Forecasts the mean of the newest samples while they only scatter.</summary>
    /// <remarks>
    /// The other forecasters would amplify the noise. A slow motion that is hidden in the noise leaves the mean behind, for which the gate rejects it.
    /// </remarks>
    sealed class MeanForecaster : Forecaster
    {
        RestDetector _rest;

        public override bool Solve(MotionState motion)
        {
            _rest = motion.Rest;
            return _rest.Scatters;
        }

        public override double At(double ahead, int component) => _rest.Mean[component];
    }
}
