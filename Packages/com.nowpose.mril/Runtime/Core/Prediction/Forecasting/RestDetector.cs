using System;
using Nowpose.Prediction.Samples;

namespace Nowpose.Prediction.Forecasting
{
    /// <summary>Detects rest with and without noise. At rest, the mixture has separate weights, and candidates have separate errors.</summary>
    /// <remarks>
    /// The detector answers three questions:
    /// 1. Does the joint stand still (<see cref="Standstill"/>)? Two samples differ by at most a thousandth of the recent maximum. This works only
    /// for sources without noise, but needs only one sample; candidates, which predict the start of a motion, use it.
    /// 2. Is it at rest (<see cref="IsAtRest"/>)? Rest begins when the range of the newest four samples is within a small multiple of the
    /// noise, and ends at a larger distance from the position where it began. The mixture uses it.
    /// 3. Are the samples at rest only noise (<see cref="IsOnlyNoise"/>), or does the joint move slowly? If they are only noise, the mixture holds
    /// the position. The noise is the low decile of the ranges over time, from a quantile tracker. A joint that never rests raises it to the slowest
    /// tenth of its motion; samples that all move in one direction therefore begin a rest only if they are much slower than the fastest samples of
    /// the last seconds, as at the end of a motion.
    /// </remarks>
    sealed class RestDetector
    {
        /// <summary>
        /// Number of samples in a range: fewer samples of a motion can be within the noise by chance. With 3 or 6, the errors change by at
        /// most 0.7 %.
        /// </summary>
        const int Window = 4;

        /// <summary>
        /// Quantile of the ranges that counts as noise: a machine is assumed to rest for at least a tenth of the time. With 0.05 or 0.2, the errors
        /// change by at most 0.5 %.
        /// </summary>
        const double Quantile = 0.1;

        /// <summary>
        /// Rate of change of the quantile tracker, in units of the logarithm per second. With 1.5 or 6, the errors change by at most 0.3 %.
        /// </summary>
        const double TrackerRate = 3;

        /// <summary>
        /// Maximum range of the newest samples at which rest begins, and maximum distance from the rest position at which rest continues, as
        /// multiples of the noise. The hysteresis prevents frequent changes. With a range of 2 or 5, or a distance of 3 or 6, the errors change by at
        /// most 0.3 %.
        /// </summary>
        const double MaxRangeRatio = 3, MaxDistanceRatio = 4;

        /// <summary>
        /// Maximum displacement per sample of a motion in one direction at which rest begins, relative to the recent maximum. With 0, the error of
        /// coasting axes was 2.6 times as large; with 0.05 or 0.2, the errors change by at most 0.1 %.
        /// </summary>
        const double MaxCreepRatio = 0.1;

        /// <summary>
        /// Minimum ratio of progress to path length of a motion; below it, the motion per sample is less than a third of the noise. With 0.2 or 0.5,
        /// the errors change by less than 0.1 %.
        /// </summary>
        const double MinProgress = 0.35;

        /// <summary>Minimum ratio of second to first differences: √3 for white noise, near 0 for a smooth reversal.</summary>
        const double MinRoughness = 1.3;

        /// <summary>Minimum range, relative to the maximum so far: without it, the tracker would not recover from the logarithm of zero.</summary>
        const double MinRangeRatio = 1e-6;

        /// <summary>
        /// Number of samples used to distinguish noise from a slow motion. With 8 or 20, the errors change by less than 0.1 %.
        /// </summary>
        const int NoiseWindow = 12;

        Standstill _standstill;
        double _maxRange;

        // Logarithm of the noise; the noise is 0 until the joint has moved.
        double _logarithm = double.NegativeInfinity;

        // Position where the rest began.
        double _anchor;

        /// <summary>Whether the joint is at rest: its positions only scatter, or it moves very slowly compared with its recent motion.</summary>
        public bool IsAtRest { get; private set; }

        /// <summary>Whether the joint is at rest and the differences of its samples are only noise.</summary>
        public bool IsOnlyNoise { get; private set; }

        /// <summary>Whether the joint stands still, and since how many samples.</summary>
        public ref readonly Standstill Standstill => ref _standstill;

        /// <param name="history">History that contains the newest sample.</param>
        /// <param name="interval">Interval before the newest sample, in s.</param>
        public void Add(SampleHistory<JointSample> history, double interval)
        {
            if (history.Count < 2) return;
            _standstill.Add(Math.Abs(history[0].Position - history[1].Position));
            var range = RangeOf(history, out var mean, out var isOneWay);
            UpdateNoise(range, interval);
            UpdateRest(history, range, mean, isOneWay);
            IsOnlyNoise = IsAtRest && IsNoise(history);
        }

        public void Reset()
        {
            _maxRange = _anchor = 0;
            _logarithm = double.NegativeInfinity;
            IsAtRest = IsOnlyNoise = false;
            _standstill = default;
        }

        static double RangeOf(SampleHistory<JointSample> history, out double mean, out bool isOneWay)
        {
            var count = Math.Min(Window, history.Count);
            double min = double.PositiveInfinity, max = double.NegativeInfinity, sum = 0;
            bool rises = true, falls = true;
            for (var i = 0; i < count; i++)
            {
                var position = history[i].Position;
                if (position < min) min = position;
                if (position > max) max = position;
                sum += position;
                if (i == 0) continue;
                rises &= history[i - 1].Position > position;
                falls &= history[i - 1].Position < position;
            }
            mean = sum / count;
            isOneWay = rises || falls;
            return max - min;
        }

        void UpdateNoise(double range, double interval)
        {
            _maxRange = Math.Max(_maxRange, range);
            if (_maxRange == 0) return;
            var logarithm = Math.Log(Math.Max(range, MinRangeRatio * _maxRange));
            if (double.IsNegativeInfinity(_logarithm)) _logarithm = logarithm;
            // After a pause of several seconds, a step in proportion to the whole pause would take minutes to undo.
            var seconds = Math.Min(interval, SampleTiming.MaxInterval);
            _logarithm += TrackerRate * seconds * (logarithm > _logarithm ? Quantile : Quantile - 1);
        }

        void UpdateRest(SampleHistory<JointSample> history, double range, double mean, bool isOneWay)
        {
            var (newest, noise) = (history[0].Position, Math.Exp(_logarithm));
            if (IsAtRest && Math.Abs(newest - _anchor) > MaxDistanceRatio * noise) IsAtRest = false;
            var isMoving = isOneWay && range > MaxCreepRatio * (Window - 1) * _standstill.MaxDisplacement;
            if (!IsAtRest && !isMoving && history.Count >= Window && range <= MaxRangeRatio * noise) (IsAtRest, _anchor) = (true, mean);
        }

        // White noise makes no progress, and its second differences are √3 times its first; a smooth motion that reverses also makes no
        // progress, but has small second differences.
        static bool IsNoise(SampleHistory<JointSample> history)
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
    }
}
