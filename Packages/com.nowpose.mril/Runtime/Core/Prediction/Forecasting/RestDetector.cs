using System;
using Nowpose.Prediction.Samples;

namespace Nowpose.Prediction.Forecasting
{
    /// <summary>Tells rest, noise included, from motion: at rest another mixture of forecasts is right.</summary>
    /// <remarks>
    /// The range of the newest four samples has a low decile over time, which is what noise alone makes; a few times that
    /// is rest, and leaving an anchor by more than that ends it.
    /// </remarks>
    sealed class RestDetector
    {
        /// <summary>Samples whose range is compared: fewer are within the noise by chance.</summary>
        const int Window = 4;

        /// <summary>
        /// The quantile of the ranges that counts as noise: every machine is assumed to rest at least this share of the time.
        /// </summary>
        const double Quantile = 0.1;

        /// <summary>Step of the logarithm of the range per the second value, s, to which longer intervals are limited.</summary>
        const double Learning = 0.3, MaxLearningInterval = 0.1;

        /// <summary>
        /// Rest begins with a range below, and ends that far from the anchor, in ranges of noise: apart, so that it does not flicker.
        /// </summary>
        const double EntersBelow = 3, LeavesAbove = 4;

        /// <summary>The anchor is a mean of ten samples: it follows what creeps.</summary>
        const double AnchorShare = 0.1;

        /// <summary>With less progress than this a motion is slower than a third of the noise per sample.</summary>
        const double MinProgress = 0.35;

        /// <summary>Second differences over first ones: √3 of white noise, hardly any of a smooth turn.</summary>
        const double MinRoughness = 1.3;

        /// <summary>A range of zero counts as this share of the greatest ever, or the logarithm would never come back.</summary>
        const double MinShare = 1e-6, Tiny = 1e-300;

        /// <summary>Samples that tell noise from a slow motion.</summary>
        const int NoiseWindow = 12;

        /// <summary>A displacement below this share of the recent maximum counts as standing still.</summary>
        const double StillShare = 1e-3;

        /// <summary>Forgetting factor of the maximum displacement per sample: 1/e after 500 samples.</summary>
        const double StillForgetting = 0.998;

        double _maxRange;
        double _logarithm;
        double _anchor;
        bool _hasNoise;

        public bool IsAtRest { get; private set; }

        /// <summary>Whether the samples at rest scatter to and fro: then what they do is noise, and nothing follows from it.</summary>
        public bool IsOnlyNoise { get; private set; }

        /// <summary>Displacement between two samples up to which the joint stands still, in the samples' unit.</summary>
        public double StillDistance { get; private set; }

        /// <summary>Number of newest samples in a row at the same position as the one before.</summary>
        public int StillSamples { get; private set; }

        /// <param name="history">With the newest sample in it.</param>
        /// <param name="interval">Before the newest sample, s.</param>
        public void Add(SampleHistory history, double interval)
        {
            var count = Math.Min(Window, history.Count);
            double least = double.PositiveInfinity, greatest = double.NegativeInfinity, sum = 0;
            for (var i = 0; i < count; i++)
            {
                var position = history[i].Position;
                least = Math.Min(least, position);
                greatest = Math.Max(greatest, position);
                sum += position;
            }
            var range = greatest - least;
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
            StillDistance = 0;
            StillSamples = 0;
        }

        void Compare(double displacement)
        {
            StillDistance = Math.Max(StillForgetting * StillDistance, StillShare * displacement);
            StillSamples = displacement <= StillDistance ? StillSamples + 1 : 0;
        }

        // White noise goes nowhere, and its second differences are √3 times its first; a smooth motion that turns does the
        // one but not the other.
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
            // As long as nothing has ever moved, nothing is known of the noise.
            _hasNoise = _maxRange > 0;
            var share = logarithm > _logarithm ? Quantile : Quantile - 1;
            _logarithm += Learning * Math.Min(interval, MaxLearningInterval) / MaxLearningInterval * share;
        }
    }
}
