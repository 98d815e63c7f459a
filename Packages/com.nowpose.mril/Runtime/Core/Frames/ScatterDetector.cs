using System;

namespace Nowpose.Frames
{
    /// <summary>Detects samples that only scatter about a place, like those of a noisy tracker whose object is at rest.</summary>
    /// <remarks>
    /// For white noise, the mean second difference is √3 times the mean first difference, and the samples make no progress; a smooth motion
    /// has small second differences. The lengths of vectors decide, so three components give more evidence than one. Allocates nothing
    /// after construction.
    /// </remarks>
    sealed class ScatterDetector
    {
        /// <summary>Number of newest samples, and the minimum number for a decision.</summary>
        const int Window = 8, MinSamples = 4;

        /// <summary>Maximum ratio of progress to path length, and minimum ratio of second to first differences, of samples that scatter.</summary>
        const double MaxProgress = 0.7, MinRoughness = 1.0;

        readonly Vector3D[] _newestFirst = new Vector3D[Window];
        int _count;

        /// <summary>Whether the newest samples only scatter; false for samples that do not differ.</summary>
        public bool Scatters { get; private set; }

        /// <summary>Adds a sample newer than all before.</summary>
        public void Add(in Vector3D position)
        {
            for (var i = Window - 1; i > 0; i--) _newestFirst[i] = _newestFirst[i - 1];
            _newestFirst[0] = position;
            _count = Math.Min(_count + 1, Window);
            Scatters = _count >= MinSamples && IsScatter();
        }

        public void Clear()
        {
            _count = 0;
            Scatters = false;
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
            var progress = (_newestFirst[0] - _newestFirst[_count - 1]).Length;
            return progress < MaxProgress * path && bends / (_count - 2) > MinRoughness * path / (_count - 1);
        }
    }
}
