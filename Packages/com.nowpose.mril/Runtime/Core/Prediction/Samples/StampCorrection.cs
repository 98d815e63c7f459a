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

    /// <summary>
    /// Decides whether stamps are wrong or the sampling is irregular, by the smoothness of the positions over the reported stamps and over
    /// the times of the regression line.
    /// </summary>
    /// <remarks>
    /// The stamps of a source that samples irregularly are correct and must not be changed. Each sample is compared with the quadratic through the
    /// previous three samples, once over the reported stamps and once over the times of the line. The logarithm of the ratio of the two errors is a
    /// vote; the mean of the votes decides.
    /// </remarks>
    sealed class SmoothnessTest
    {
        /// <summary>Weight of one vote in the mean: eight maximum votes against the line reject it at first, 25 after many votes for it.</summary>
        /// <remarks>With half or twice this value, the mean errors with wrong stamps change by at most 0.4 %.</remarks>
        const double VoteWeight = 0.03;

        /// <summary>Maximum vote, so that no single sample decides. It is a decimal logarithm, so 1 means a ratio of ten.</summary>
        const double MaxVote = 1;

        /// <summary>
        /// InitialMean: the line is used at first, because most controllers sample periodically. MinMean: mean below which the line is not used; it
        /// is below 0, because with noise the mean fluctuates about 0.
        /// </summary>
        const double InitialMean = 0.2, MinMean = -0.05;

        /// <summary>Number of samples: the newest one and three, which determine a quadratic.</summary>
        const int Kept = 4;

        // The newest samples, newest first: positions, whose components are adjacent, reported stamps, and times on the line.
        readonly double[] _positions, _reported = new double[Kept], _onLine = new double[Kept];
        readonly int _components;
        int _count;
        double _mean;

        public SmoothnessTest(int components)
        {
            (_components, _positions) = (components, new double[Kept * components]);
            Reset();
        }

        /// <summary>Whether the positions are about as smooth over the times of the line as over the reported stamps, or smoother.</summary>
        public bool PrefersLine => _mean >= MinMean;

        /// <param name="onLine">Time of the sample on the line, in s.</param>
        public void Add<TSample>(in TSample sample, double onLine) where TSample : struct, ISample<TSample>
        {
            for (var i = Kept - 1; i > 0; i--) (_reported[i], _onLine[i]) = (_reported[i - 1], _onLine[i - 1]);
            for (var i = _positions.Length - 1; i >= _components; i--) _positions[i] = _positions[i - _components];
            (_reported[0], _onLine[0]) = (sample.Time, onLine);
            for (var c = 0; c < _components; c++) _positions[c] = sample[c];
            _count = Math.Min(_count + 1, Kept);
            if (_count < Kept) return;
            double errorReported = ErrorOf(_reported), errorOnLine = ErrorOf(_onLine);
            if (!(errorReported > 0 && errorOnLine > 0)) return;
            var vote = Math.Log10(errorReported / errorOnLine);
            _mean += VoteWeight * (Math.Min(Math.Max(vote, -MaxVote), MaxVote) - _mean);
        }

        public void Reset() => (_count, _mean) = (0, InitialMean);

        // Distance of sample 0 from the quadratic through samples 1 to 3, in Lagrange form; NaN or infinite if two times coincide.
        double ErrorOf(double[] times)
        {
            var squares = 0.0;
            for (var c = 0; c < _components; c++)
            {
                var error = 0.0;
                for (var i = 1; i < Kept; i++)
                {
                    var term = _positions[i * _components + c] - _positions[c];
                    for (var j = 1; j < Kept; j++)
                        if (j != i) term *= (times[0] - times[j]) / (times[i] - times[j]);
                    error += term;
                }
                squares += error * error;
            }
            return Math.Sqrt(squares);
        }
    }
}
