using System;

namespace Nowpose.Prediction.Samples
{
    /// <summary>The line through the stamps of a periodic source: sample number against t_k, with a forgetting factor.</summary>
    /// <remarks>
    /// A controller samples on a clock's beat, but stamps when it gets round to it. The line knows the beat better than any
    /// single stamp. Numbers come from the stamps themselves, so that lost samples leave no trace. Sums of a weighted
    /// regression about the newest stamp take the place of the stamps: a sample costs the same however many count.
    /// </remarks>
    sealed class StampLine
    {
        /// <summary>Stamps after which an older one has faded to 1/e: the line errs as one through the newest 125.</summary>
        const int Memory = 100;

        /// <summary>Minimum number of stamps from which the interval is estimated.</summary>
        const int MinStamps = 8;

        /// <summary>Maximum pause in intervals. A longer one ends the beat: the source may have restarted.</summary>
        const double MaxPause = 40;

        /// <summary>Maximum number of samples lost between the first stamps.</summary>
        const int MaxLostAtStart = 4;

        /// <summary>Shorter intervals suit any stamps better; this much is more than chance.</summary>
        const double Better = 0.6;

        /// <summary>Maximum scatter, as a share of the interval, at which the count is certain.</summary>
        const double ClearShare = 0.22;

        /// <summary>Maximum scatter of stamps on a beat, as a share of the interval: random stamps scatter by 0.29.</summary>
        const double MaxShare = 0.25;

        /// <summary>The first line may miscount; a second and a third count by the line before.</summary>
        const int Refinements = 3;

        /// <summary>Controllers' cycles are whole milliseconds, s.</summary>
        const double Beat = 1e-3;

        /// <summary>Standard errors within which a slope may be a whole one.</summary>
        const double Belief = 2;

        readonly double[] _first = new double[MinStamps];
        int _count;
        int _misfits;
        double _newest;

        // Weighted sums over the stamps; number and time count from the newest stamp, so that neither the epoch nor a count of
        // weeks costs digits.
        double _sum, _sumN, _sumT, _sumNn, _sumNt, _sumTt;

        /// <summary>Whether there is a line.</summary>
        public bool IsKnown { get; private set; }

        /// <summary>T_s, s; while <see cref="IsKnown"/>.</summary>
        public double Interval { get; private set; }

        /// <summary>Standard deviation of the stamps about the line, s; while <see cref="IsKnown"/>.</summary>
        public double Deviation { get; private set; }

        /// <summary>Whether stamps scatter so much that they can be confused with their neighbours'.</summary>
        public bool IsScatteredOut => Deviation > MaxShare * Interval;

        /// <summary>The line at the newest stamp's number, s; while <see cref="IsKnown"/>.</summary>
        public double Newest { get; private set; }

        /// <summary>The line at the number nearest to a stamp.</summary>
        public double Nearest(double stamp) => Newest + Math.Round((stamp - Newest) / Interval) * Interval;

        /// <summary>Takes the stamp of a sample that follows those before.</summary>
        public void Add(double stamp)
        {
            if (IsKnown && Math.Abs(stamp - Newest) > MaxPause * Interval) Reset();
            if (IsKnown)
            {
                Append(stamp, Math.Max(1, Math.Round((stamp - Newest) / Interval)));
                Fit();
            }
            else
            {
                _first[_count++] = stamp;
                if (_count == MinStamps) Begin();
            }
            if (!IsKnown) return;
            // Numbers once counted wrong would spoil the line until they are gone.
            _misfits = IsScatteredOut ? _misfits + 1 : 0;
            if (_misfits == MinStamps) Reset();
        }

        public void Reset()
        {
            _count = _misfits = 0;
            IsKnown = false;
        }

        // How many samples were lost among the first is unknown: the longest interval that suits the stamps is taken.
        void Begin()
        {
            var span = _first[MinStamps - 1] - _first[0];
            var best = 0;
            var leastShare = double.PositiveInfinity;
            for (var lost = 0; lost <= MaxLostAtStart && leastShare > ClearShare; lost++)
            {
                Number(span / (MinStamps - 1 + lost));
                if (!IsKnown || Deviation >= Better * leastShare * Interval) continue;
                leastShare = Deviation / Interval;
                best = lost;
            }
            Number(span / (MinStamps - 1 + best));
            if (!IsKnown) Reset();
        }

        void Number(double interval)
        {
            IsKnown = interval > 0;
            Interval = interval;
            Newest = _first[0];
            for (var i = 0; i < Refinements && IsKnown; i++)
            {
                _sum = 0;
                double before = 0, origin = Newest;
                foreach (var stamp in _first)
                {
                    var number = Math.Round((stamp - origin) / Interval);
                    Append(stamp, number - before);
                    before = number;
                }
                Fit();
            }
        }

        // Moves the origin of the sums to the new stamp, which adds nothing to them but its weight.
        void Append(double stamp, double steps)
        {
            if (_sum == 0) (_sumN, _sumT, _sumNn, _sumNt, _sumTt, _newest) = (0, 0, 0, 0, 0, stamp);
            var time = stamp - _newest;
            _sumNn += steps * (steps * _sum - 2 * _sumN);
            _sumNt += steps * time * _sum - time * _sumN - steps * _sumT;
            _sumTt += time * (time * _sum - 2 * _sumT);
            _sumN -= steps * _sum;
            _sumT -= time * _sum;
            _newest = stamp;
            if (_sum >= Memory) Forget();
            _sum++;
        }

        void Forget()
        {
            const double keeping = 1 - 1.0 / Memory;
            _sum *= keeping;
            _sumN *= keeping;
            _sumT *= keeping;
            _sumNn *= keeping;
            _sumNt *= keeping;
            _sumTt *= keeping;
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
            Newest = _newest + meanT - Interval * meanN;
        }

        // A young line's slope is uncertain, and what it errs the newest number feels most.
        static double LikelyInterval(double slope, double standardError)
        {
            var whole = Math.Round(slope / Beat) * Beat;
            return whole > 0 && Math.Abs(slope - whole) <= Belief * standardError && standardError < Beat ? whole : slope;
        }
    }
}
