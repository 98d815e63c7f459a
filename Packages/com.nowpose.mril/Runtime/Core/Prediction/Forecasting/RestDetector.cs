using System;
using Nowpose.Prediction.Samples;

namespace Nowpose.Prediction.Forecasting
{
    /// <summary>Distinguishes rest, including noise, from motion, because the weights of the mixture differ at rest.</summary>
    /// <remarks>
    /// The low decile over time of the range of the newest four samples is an estimate of the noise. A range below a small multiple
    /// of it means rest; a larger distance from an anchor ends it.
    /// </remarks>
    sealed class RestDetector
    {
        /// <summary>Number of samples in a range: the range of fewer samples is within the noise by chance.</summary>
        const int Window = 4;

        /// <summary>
        /// Quantile of the ranges that counts as noise: every machine is assumed to rest for at least this share of the time.
        /// </summary>
        const double Quantile = 0.1;

        /// <summary>Step of the logarithm of the range per the second value, in s; longer intervals are limited to it.</summary>
        const double Learning = 0.3, MaxLearningInterval = 0.1;

        /// <summary>
        /// Rest begins with a range below the first value and ends at a distance from the anchor above the second, both as multiples of the
        /// noise. The hysteresis prevents flickering.
        /// </summary>
        const double EntersBelow = 3, LeavesAbove = 4;

        /// <summary>Weight of a sample in the anchor, a mean of about ten samples that follows creeping motion.</summary>
        const double AnchorShare = 0.1;

        /// <summary>Minimum ratio of progress to path length of a motion; below it, the motion per sample is under a third of the noise.</summary>
        const double MinProgress = 0.35;

        /// <summary>Minimum ratio of second to first differences: √3 for white noise, near 0 for a smooth reversal.</summary>
        const double MinRoughness = 1.3;

        /// <summary>Minimum range as a share of the maximum range so far, because the mean would never recover from the logarithm of zero.</summary>
        const double MinShare = 1e-6, Tiny = 1e-300;

        /// <summary>Number of samples used to distinguish noise from a slow motion.</summary>
        const int NoiseWindow = 12;

        /// <summary>Standstill threshold: displacement as a share of the recent maximum.</summary>
        const double StillShare = 1e-3;

        /// <summary>Forgetting factor of the maximum displacement per sample: 1/e after 500 samples.</summary>
        const double StillForgetting = 0.998;

        double _maxRange;
        double _logarithm;
        double _anchor;
        bool _hasNoise;

        public bool IsAtRest { get; private set; }

        /// <summary>Whether the samples at rest fluctuate around a position, so that their differences are only noise.</summary>
        public bool IsOnlyNoise { get; private set; }

        /// <summary>Maximum displacement between two samples of a joint that stands still, in the samples' unit.</summary>
        public double StillDistance => StillShare * MaxDisplacement;

        /// <summary>Recent maximum displacement between two samples, in the samples' unit.</summary>
        public double MaxDisplacement { get; private set; }

        /// <summary>Number of consecutive newest samples at the same position as the one before.</summary>
        public int StillSamples { get; private set; }

        /// <param name="history">History that contains the newest sample.</param>
        /// <param name="interval">Interval before the newest sample, in s.</param>
        public void Add(SampleHistory history, double interval)
        {
            var count = Math.Min(Window, history.Count);
            double min = double.PositiveInfinity, max = double.NegativeInfinity, sum = 0;
            for (var i = 0; i < count; i++)
            {
                var position = history[i].Position;
                if (position < min) min = position;
                if (position > max) max = position;
                sum += position;
            }
            var range = max - min;
            _maxRange = Math.Max(_maxRange, range);
            if (history.Count < 2) return;

            Compare(Math.Abs(history[0].Position - history[1].Position));
            Learn(range, interval);
            var noise = Math.Exp(_logarithm);
            var newest = history[0].Position;
            if (IsAtRest && Math.Abs(newest - _anchor) > LeavesAbove * noise) IsAtRest = false;
            if (!IsAtRest && history.Count >= Window && range <= EntersBelow * noise)
            {
                IsAtRest = true;
                _anchor = sum / count;
            }
            if (IsAtRest) _anchor += AnchorShare * (newest - _anchor);
            IsOnlyNoise = IsAtRest && IsNoise(history);
        }

        public void Reset()
        {
            _maxRange = _logarithm = _anchor = 0;
            _hasNoise = IsAtRest = IsOnlyNoise = false;
            MaxDisplacement = 0;
            StillSamples = 0;
        }

        void Compare(double displacement)
        {
            MaxDisplacement = Math.Max(StillForgetting * MaxDisplacement, displacement);
            StillSamples = displacement <= StillDistance ? StillSamples + 1 : 0;
        }

        // White noise makes no progress, and its second differences are √3 times its first; a smooth motion that reverses also makes no
        // progress, but has small second differences.
        static bool IsNoise(SampleHistory history)
        {
            double displacements = 0, bends = 0;
            var count = Math.Min(NoiseWindow, history.Count);
            for (var i = 1; i < count; i++)
            {
                var displacement = history[i - 1].Position - history[i].Position;
                displacements += Math.Abs(displacement);
                if (i + 1 < count) bends += Math.Abs(displacement - history[i].Position + history[i + 1].Position);
            }
            var progress = Math.Abs(history[0].Position - history[count - 1].Position);
            return progress < MinProgress * displacements && bends > MinRoughness * displacements;
        }

        void Learn(double range, double interval)
        {
            var logarithm = Math.Log(Math.Max(range, MinShare * _maxRange + Tiny));
            if (!_hasNoise) _logarithm = logarithm;
            // The noise is unknown until the joint has moved.
            _hasNoise = _maxRange > 0;
            var share = logarithm > _logarithm ? Quantile : Quantile - 1;
            _logarithm += Learning * Math.Min(interval, MaxLearningInterval) / MaxLearningInterval * share;
        }
    }
}
