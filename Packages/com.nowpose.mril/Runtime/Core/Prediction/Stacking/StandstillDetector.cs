using System;

namespace Nowpose.Prediction.Stacking
{
    /// <summary>Tells rest, noise included, from motion: at rest another mixture of forecasts is right.</summary>
    /// <remarks>
    /// The range of the newest four samples has a low decile over time, which is what noise alone makes; a few times that
    /// is rest, and leaving an anchor by more than that ends it.
    /// </remarks>
    sealed class StandstillDetector
    {
        const int Window = 4;
        const double Quantile = 0.1;

        /// <summary>Step of the logarithm of the range per tenth of a second.</summary>
        const double Learning = 0.3;

        const double LongestLearning = 0.1;
        const double EntersBelow = 3;
        const double LeavesAbove = 4;
        const double AnchorShare = 0.1;

        /// <summary>With less progress than this a motion is slower than a third of the noise per sample.</summary>
        const double LeastProgress = 0.35;

        const double LeastRoughness = 1.3;

        /// <summary>A range of zero counts as this share of the greatest ever, or the logarithm would never come back.</summary>
        const double LeastShare = 1e-6;

        const double Tiny = 1e-300;

        double _greatestRange;
        double _logarithm;
        double _anchor;
        bool _knowsNoise;

        public bool IsAtRest { get; private set; }

        /// <summary>Whether the samples at rest scatter to and fro: then what they do is noise, and nothing follows from it.</summary>
        public bool IsOnlyNoise { get; private set; }

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
            _greatestRange = Math.Max(_greatestRange, range);
            if (history.Count < 2) return;

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
            _greatestRange = _logarithm = _anchor = 0;
            _knowsNoise = IsAtRest = IsOnlyNoise = false;
        }

        // White noise goes nowhere, and its second differences are √3 times its first; a smooth motion that turns does the
        // one but not the other.
        static bool IsNoise(SampleHistory history)
        {
            double ways = 0, bends = 0;
            for (var i = 1; i < history.Count; i++)
            {
                var way = history[i - 1].Position - history[i].Position;
                ways += Math.Abs(way);
                if (i + 1 < history.Count) bends += Math.Abs(way - history[i].Position + history[i + 1].Position);
            }
            var progress = Math.Abs(history[0].Position - history[history.Count - 1].Position);
            return progress < LeastProgress * ways && bends > LeastRoughness * ways;
        }

        void Learn(double range, double interval)
        {
            var logarithm = Math.Log(Math.Max(range, LeastShare * _greatestRange + Tiny));
            if (!_knowsNoise) _logarithm = logarithm;
            // As long as nothing has ever moved, nothing is known of the noise.
            _knowsNoise = _greatestRange > 0;
            var share = logarithm > _logarithm ? Quantile : Quantile - 1;
            _logarithm += Learning * Math.Min(interval, LongestLearning) / LongestLearning * share;
        }
    }
}
