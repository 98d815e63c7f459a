using System;

namespace Nowpose.Prediction.Samples
{
    /// <summary>Corrects the stamps of a periodic source to its sampling times.</summary>
    /// <remarks>
    /// At 1 m/s, a stamp error of 5 ms causes a position error of 5 mm, which a quadratic forecast with a horizon of 100 ms amplifies to 40 mm.
    /// Stamps are not changed if their standard deviation from the line is at most 0.3 ms, if they have no period, or if they fit the positions
    /// better than the line does.
    /// </remarks>
    sealed class StampCorrection
    {
        /// <summary>Minimum standard deviation of stamps to correct, in s; a smaller deviation is harmless.</summary>
        const double MinDeviation = 0.3e-3;

        /// <summary>
        /// Maximum standard deviation of the stamps of a source without occasional delays, in s: rounding to whole milliseconds causes 0.3 ms.
        /// </summary>
        const double CleanDeviation = 1e-3;

        /// <summary>
        /// Number of consecutive stamps off the line on the same side after which the line restarts. Scatter rarely causes three such stamps, so
        /// the period has probably changed.
        /// </summary>
        const int InARow = 3;

        /// <summary>
        /// Distance from the line, in standard deviations, beyond which a stamp counts as off the line. Uniform scatter stays within √3, but the line of the
        /// first stamps is inaccurate: with 2, the errors with wrong stamps are 1.7 % larger.
        /// </summary>
        const double Deviations = 3;

        readonly StampLine _line = new StampLine();
        readonly SmoothnessTest _smoothness;

        // Number of consecutive newest stamps that are off the line on the same side; negative if they are early.
        int _offLine;

        public StampCorrection(int components) => _smoothness = new SmoothnessTest(components);

        /// <summary>Returns the corrected time of a sample.</summary>
        public double Correct<TSample>(in TSample sample, bool isNewest) where TSample : struct, ISample<TSample>
        {
            var stamp = sample.Time;
            if (isNewest) UpdateLine(stamp);
            if (!_line.IsKnown) return stamp;
            var onLine = isNewest ? _line.NewestOnLine : _line.Nearest(stamp);
            if (isNewest) _smoothness.Add(sample, onLine);
            var isScattered = _line.Deviation > MinDeviation && !_line.IsTooScattered;
            return isScattered && !IsPeriodChange(stamp - onLine) && _smoothness.PrefersLine ? onLine : stamp;
        }

        public void Reset()
        {
            _line.Reset();
            _smoothness.Reset();
            _offLine = 0;
        }

        // Returns whether the distance from the line comes from another period, not from scatter.
        bool IsPeriodChange(double off)
        {
            if (Math.Abs(off) <= Deviations * _line.Deviation) return false;
            // A delay can make a stamp late by any time, but not early. Delays are unlikely for a source with clean stamps, and for two stamps in a
            // row.
            var (isEarly, isOfCleanSource, isInARow) = (off < 0, _line.Deviation < CleanDeviation, Math.Abs(_offLine) > 1);
            return isEarly || isOfCleanSource || isInARow;
        }

        void UpdateLine(double stamp)
        {
            _line.Add(stamp);
            if (!_line.IsKnown) return;
            var off = stamp - _line.NewestOnLine;
            var side = Math.Abs(off) > Math.Max(MinDeviation, Deviations * _line.Deviation) ? Math.Sign(off) : 0;
            _offLine = side == 0 ? 0 : side == Math.Sign(_offLine) ? _offLine + side : side;
            if (Math.Abs(_offLine) < InARow) return;
            _offLine = 0;
            _line.Reset();
            _line.Add(stamp);
        }
    }
}
