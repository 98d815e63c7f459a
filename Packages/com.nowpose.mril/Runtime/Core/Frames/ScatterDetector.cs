using System;

namespace Nowpose.Frames
{
    /// <summary>Detects samples that only scatter about a position, such as the samples of a noisy tracker whose object is at rest.</summary>
    /// <remarks>
    /// Uses the rule of <see cref="Prediction.Forecasting.RestDetector.IsOnlyNoise"/>, with lengths of vectors: for white noise, the mean
    /// second difference is √3 times the mean first difference, and the samples make no progress; a smooth motion has small second
    /// differences. Three components give more evidence than one, so a shorter window is sufficient. Allocates nothing after construction.
    /// </remarks>
    sealed class ScatterDetector
    {
        /// <summary>Window: number of newest samples that are examined. MinSamples: minimum number for a decision.</summary>
        const int Window = 8, MinSamples = 4;

        /// <summary>
        /// Limits for samples that scatter. MaxProgress: maximum ratio of progress to path length. MinRoughness: minimum ratio of second to first
        /// differences.
        /// </summary>
        const double MaxProgress = 0.7, MinRoughness = 1.0;

        /// <summary>
        /// Minimum distance of the first sample of a motion from the mean of the scattering samples, and from the last of them, relative to
        /// their mean first difference, in the window or on average. Noise in one component exceeds this limit once in 10 000 samples, noise in two or
        /// three components not once in four million. With the window's mean alone, which is small by chance at times, it was once in 250 samples in
        /// one component. The direction of a shorter last step would depend mainly on the noise.
        /// </summary>
        const double MinStartRatio = 4;

        /// <summary>Weight of a new window in <see cref="Noise"/>.</summary>
        const double Smoothing = 1 / 16.0;

        readonly Vector3D[] _newestFirst = new Vector3D[Window];
        int _count;
        int _sinceScatter;
        double _meanStep;

        /// <summary>Whether the newest samples only scatter; false for samples that do not differ.</summary>
        public bool Scatters { get; private set; }

        /// <summary>Whether a motion starts: the newest sample has left the position about which the previous samples scattered.</summary>
        public bool HasLeft { get; private set; }

        /// <summary>Mean distance between consecutive samples that only scatter; 0 after a motion, and for samples that do not differ.</summary>
        public double Noise { get; private set; }

        /// <summary>Adds a sample that is newer than all previous samples.</summary>
        public void Add(in Vector3D position)
        {
            var distance = Math.Min((position - Mean()).Length, (position - _newestFirst[0]).Length);
            HasLeft = Scatters && distance > MinStartRatio * Math.Max(_meanStep, Noise);
            for (var i = Window - 1; i > 0; i--) _newestFirst[i] = _newestFirst[i - 1];
            _newestFirst[0] = position;
            _count = Math.Min(_count + 1, Window);
            Scatters = _count >= MinSamples && IsScatter();
            _sinceScatter = Scatters ? 0 : _sinceScatter + 1;
            if (_sinceScatter >= Window) Noise = 0;
            else if (Scatters) Noise += (_meanStep - Noise) * (Noise > 0 ? Smoothing : 1);
        }

        public void Clear()
        {
            _count = 0;
            Scatters = HasLeft = false;
            Noise = 0;
        }

        Vector3D Mean()
        {
            var sum = default(Vector3D);
            for (var i = 0; i < _count; i++) sum += _newestFirst[i];
            return sum * (1.0 / _count);
        }

        bool IsScatter()
        {
            double path = 0, bends = 0;
            for (var i = 0; i + 1 < _count; i++)
            {
                var step = _newestFirst[i] - _newestFirst[i + 1];
                path += step.Length;
                if (i + 2 < _count) bends += (step - (_newestFirst[i + 1] - _newestFirst[i + 2])).Length;
            }
            _meanStep = path / (_count - 1);
            var progress = (_newestFirst[0] - _newestFirst[_count - 1]).Length;
            return progress < MaxProgress * path && bends / (_count - 2) > MinRoughness * _meanStep;
        }
    }
}
