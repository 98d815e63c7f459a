using System;

namespace Nowpose.Prediction.Samples
{
    /// <summary>Regression line through the stamps of a periodic source: t_k against the sample number, with a forgetting factor.</summary>
    /// <remarks>
    /// A controller samples periodically, but stamps with a varying delay, so the line is more accurate than a
    /// single stamp. Sample numbers are derived from the stamps, so lost samples do not affect the line. Stores the sums of a weighted regression
    /// about the newest stamp instead of the stamps, so the cost per sample does not depend on their number.
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

        readonly double[] _first = new double[MinStamps];
        int _count;
        int _misfits;
        double _newestStamp;

        // Weighted sums over the stamps. Sample numbers and times are relative to the newest stamp, so that neither an early epoch nor a run of
        // several weeks reduces the precision.
        double _sum, _sumN, _sumT, _sumNn, _sumNt, _sumTt;

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
        public double Nearest(double stamp) => NewestOnLine + Math.Round((stamp - NewestOnLine) / Interval) * Interval;

        /// <summary>Adds the time stamp of the next sample.</summary>
        public void Add(double stamp)
        {
            if (IsKnown && Math.Abs(stamp - NewestOnLine) > MaxPause * Interval) Reset();
            if (IsKnown)
            {
                Append(stamp, Math.Max(1, Math.Round((stamp - NewestOnLine) / Interval)));
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
            IsKnown = interval > 0;
            Interval = interval;
            NewestOnLine = _first[0];
            for (var i = 0; i < Refinements && IsKnown; i++)
            {
                _sum = 0;
                double before = 0, origin = NewestOnLine;
                foreach (var stamp in _first)
                {
                    var number = Math.Round((stamp - origin) / Interval);
                    Append(stamp, number - before);
                    before = number;
                }
                Fit();
            }
        }

        // Moves the origin of the sums to the new stamp, which then contributes only its weight.
        void Append(double stamp, double steps)
        {
            if (_sum == 0) (_sumN, _sumT, _sumNn, _sumNt, _sumTt, _newestStamp) = (0, 0, 0, 0, 0, stamp);
            var time = stamp - _newestStamp;
            _sumNn += steps * (steps * _sum - 2 * _sumN);
            _sumNt += steps * time * _sum - time * _sumN - steps * _sumT;
            _sumTt += time * (time * _sum - 2 * _sumT);
            _sumN -= steps * _sum;
            _sumT -= time * _sum;
            _newestStamp = stamp;
            if (_sum >= MaxSum) Forget();
            _sum++;
        }

        void Forget()
        {
            _sum *= ForgettingFactor;
            _sumN *= ForgettingFactor;
            _sumT *= ForgettingFactor;
            _sumNn *= ForgettingFactor;
            _sumNt *= ForgettingFactor;
            _sumTt *= ForgettingFactor;
        }

        void Fit()
        {
            var meanN = _sumN / _sum;
            var meanT = _sumT / _sum;
            var spread = _sumNn - _sumN * meanN;
            var slope = (_sumNt - _sumN * meanT) / spread;
            if (!(spread > 0) || !(slope > 0))
            {
                Reset();
                return;
            }
            Deviation = Math.Sqrt(Math.Max(0, (_sumTt - _sumT * meanT - slope * (_sumNt - _sumN * meanT)) / _sum));
            Interval = LikelyInterval(slope, Deviation / Math.Sqrt(spread));
            NewestOnLine = _newestStamp + meanT - Interval * meanN;
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
