using System;

namespace Nowpose.Prediction.Samples
{
    /// <summary>Regression line through the stamps of a periodic source: t_k against the sample number, with a forgetting factor.</summary>
    /// <remarks>
    /// A controller samples periodically, but stamps with a varying delay, so the line is more accurate than a
    /// single stamp. Sample numbers are derived from the stamps, so lost samples do not affect the line. Recursive least squares: each stamp corrects
    /// the line by its residual, so the cost per sample does not depend on the number of stamps. The line restarts after a long pause, and if several
    /// stamps in a row show that the sample numbers are wrong; <see cref="StampCorrection"/> restarts it if the period has changed.
    /// </remarks>
    sealed class StampLine
    {
        /// <summary>
        /// Forgetting factor per stamp, after the sum of the weights has reached <see cref="MaxSum"/>. The error at the newest stamp equals the error
        /// of a line through 320 stamps, because 4 σ² / 320 = 1.25 (1 − 0.99) σ².
        /// </summary>
        const double ForgettingFactor = 0.99, MaxSum = 1 / (1 - ForgettingFactor);

        /// <summary>
        /// Minimum number of stamps from which the interval is estimated. At the maximum scatter (<see cref="MaxScatterRatio"/>), its standard error
        /// is then 4 %, so the last of these stamps is rarely mistaken for its neighbour.
        /// </summary>
        const int MinStamps = 8;

        /// <summary>Maximum pause in intervals. After a longer pause, the line is discarded, because the source may have restarted.</summary>
        const double MaxPause = 40;

        /// <summary>
        /// Maximum number of samples that may be lost between the first stamps: a third of twelve samples, more than a usable network loses.
        /// </summary>
        const int MaxLostAtStart = 4;

        /// <summary>Ratio of scatter below which a shorter interval is preferred: shorter intervals always fit slightly better.</summary>
        const double MaxRatioOfShorter = 0.6;

        /// <summary>Maximum scatter of periodic stamps, relative to the interval, at which the sample numbers are certain: random stamps scatter by 0.29.</summary>
        const double MaxScatterRatio = 0.25;

        /// <summary>Number of fits to the first stamps: the first line may assign wrong numbers, which the next fits correct.</summary>
        const int Refinements = 3;

        /// <summary>
        /// Unit of controllers' cycles, in s: usually whole milliseconds. Without rounding to it, the errors with wrong stamps are 0.5 % larger.
        /// </summary>
        const double CycleUnit = 1e-3;

        /// <summary>
        /// Maximum distance of the interval from a multiple of the cycle unit, in standard errors, at which it is rounded to this multiple: 95 % of
        /// normally distributed errors are smaller.
        /// </summary>
        const double MaxStandardErrors = 2;

        /// <summary>
        /// Variance of the slope before the second stamp, relative to the variance of a stamp. A smaller value would bias the first lines towards the
        /// interval that is tried, and a larger one would lose digits.
        /// </summary>
        const double UnknownSlope = 1e6;

        readonly double[] _first = new double[MinStamps];
        int _count;
        int _misfits;

        double _newestStamp;

        // Sum of the weights of the stamps, and weighted sum of their squared residuals.
        double _sum, _squares;

        // The line at the newest stamp's number, relative to this stamp so that an early epoch does not reduce the precision, and its slope. Their
        // variances and covariance are relative to the variance of a stamp.
        double _offset, _slope, _offsetVariance, _covariance, _slopeVariance;

        public bool IsKnown { get; private set; }

        /// <summary>T_s in s; valid if <see cref="IsKnown"/>.</summary>
        public double Interval { get; private set; }

        /// <summary>Standard deviation of the stamps about the line, in s; valid if <see cref="IsKnown"/>.</summary>
        public double Deviation { get; private set; }

        /// <summary>Whether the stamps scatter so much that a stamp can be mistaken for its neighbour.</summary>
        public bool IsTooScattered => Deviation > MaxScatterRatio * Interval;

        /// <summary>Time of the line at the newest stamp's number, in s; valid if <see cref="IsKnown"/>.</summary>
        public double NewestOnLine { get; private set; }

        /// <summary>Returns the time of the line at the number nearest to a stamp.</summary>
        public double Nearest(double stamp) => NewestOnLine + Steps(NewestOnLine, stamp) * Interval;

        /// <summary>Adds the time stamp of the next sample.</summary>
        public void Add(double stamp)
        {
            if (IsKnown && Math.Abs(stamp - NewestOnLine) > MaxPause * Interval) Reset();
            if (IsKnown)
            {
                Append(stamp, Math.Max(1, Steps(NewestOnLine, stamp)));
                Fit();
            }
            else
            {
                _first[_count++] = stamp;
                if (_count == MinStamps) EstimateInterval();
            }
            if (!IsKnown) return;
            // Wrong sample numbers would affect the line until their weight has decayed, so it restarts after as many misfits as a new line needs.
            _misfits = IsTooScattered ? _misfits + 1 : 0;
            if (_misfits == MinStamps) Reset();
        }

        public void Reset()
        {
            _count = _misfits = 0;
            IsKnown = false;
        }

        // The number of samples lost among the first is unknown, so the longest interval that fits the stamps is used.
        void EstimateInterval()
        {
            var span = _first[MinStamps - 1] - _first[0];
            var best = 0;
            var minRatio = double.PositiveInfinity;
            for (var lost = 0; lost <= MaxLostAtStart && minRatio > MaxScatterRatio; lost++)
            {
                FitWithInterval(span / (MinStamps - 1 + lost));
                if (!IsKnown || Deviation >= MaxRatioOfShorter * minRatio * Interval) continue;
                minRatio = Deviation / Interval;
                best = lost;
            }
            FitWithInterval(span / (MinStamps - 1 + best));
            if (!IsKnown) Reset();
        }

        void FitWithInterval(double interval)
        {
            (IsKnown, Interval, NewestOnLine) = (interval > 0, interval, _first[0]);
            for (var i = 0; i < Refinements && IsKnown; i++)
            {
                var origin = NewestOnLine;
                (_newestStamp, _sum, _squares, _offset, _slope) = (_first[0], 1, 0, 0, Interval);
                (_offsetVariance, _covariance, _slopeVariance) = (1, 0, UnknownSlope);
                for (var k = 1; k < MinStamps; k++) Append(_first[k], Steps(origin, _first[k]) - Steps(origin, _first[k - 1]));
                Fit();
            }
        }

        // Number of intervals from one time to another.
        double Steps(double from, double to) => Math.Round((to - from) / Interval);

        // Continues the line by a number of intervals, and corrects it and its slope by the residual of the stamp there.
        void Append(double stamp, double steps)
        {
            var factor = _sum < MaxSum ? 1 : ForgettingFactor;
            _offset += steps * _slope - (stamp - _newestStamp);
            _newestStamp = stamp;
            _offsetVariance = (_offsetVariance + steps * (2 * _covariance + steps * _slopeVariance)) / factor;
            _covariance = (_covariance + steps * _slopeVariance) / factor;
            var gain = 1 / (1 + _offsetVariance);
            (_sum, _squares) = (factor * _sum + 1, factor * _squares + gain * _offset * _offset);
            _slope -= gain * _covariance * _offset;
            _slopeVariance = _slopeVariance / factor - gain * _covariance * _covariance;
            (_offset, _offsetVariance, _covariance) = (gain * _offset, gain * _offsetVariance, gain * _covariance);
        }

        void Fit()
        {
            if (!(_slope > 0)) Reset();
            Deviation = Math.Sqrt(_squares / _sum);
            Interval = LikelyInterval(_slope, Deviation * Math.Sqrt(_slopeVariance));
            // Of the lines with this interval, the most likely one.
            NewestOnLine = _newestStamp + _offset + _covariance / _slopeVariance * (Interval - _slope);
        }

        // Rounds the slope if it is close to a multiple of the cycle unit. The slope of a short line is uncertain, and a wrong slope has the largest
        // effect at the newest sample number.
        static double LikelyInterval(double slope, double standardError)
        {
            var whole = Math.Round(slope / CycleUnit) * CycleUnit;
            return whole > 0 && Math.Abs(slope - whole) <= MaxStandardErrors * standardError ? whole : slope;
        }
    }
}
