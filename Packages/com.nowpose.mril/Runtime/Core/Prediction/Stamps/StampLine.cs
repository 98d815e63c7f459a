using System;

namespace Nowpose.Prediction.Stamps
{
    /// <summary>The line through the stamps of a periodic source: sample number against t_k, over the newest 256.</summary>
    /// <remarks>
    /// A controller samples on a clock's beat, but stamps when it gets round to it. The line knows the beat better than any
    /// single stamp. Numbers come from the stamps themselves, so that lost samples leave no trace. Allocates nothing.
    /// </remarks>
    sealed class StampLine
    {
        const int Capacity = 256;

        /// <summary>So few stamps say too little of the interval.</summary>
        const int FewestStamps = 8;

        /// <summary>A pause of so many intervals ends the beat: the source may have started anew.</summary>
        const double LongestPause = 40;

        /// <summary>Of the first stamps' neighbours so many may have been lost.</summary>
        const int MostLostAtStart = 4;

        /// <summary>Shorter intervals suit any stamps better; this much is more than chance.</summary>
        const double Better = 0.6;

        /// <summary>Scatter, as a share of the interval, that leaves no doubt of the count.</summary>
        const double ClearShare = 0.22;

        /// <summary>Scatter, as a share of the interval, beyond which there is no beat: stamps at random scatter by 0.29.</summary>
        const double GreatestShare = 0.25;

        const int Refinements = 3;

        /// <summary>Controllers' cycles are whole milliseconds, s.</summary>
        const double Beat = 1e-3;

        /// <summary>Standard errors within which a slope may be a whole one.</summary>
        const double Belief = 2;

        readonly double[] _stamps = new double[Capacity];
        readonly double[] _numbers = new double[Capacity];
        int _count;
        int _newest = -1;
        int _misfits;

        /// <summary>Whether there is a line.</summary>
        public bool IsKnown { get; private set; }

        /// <summary>T_s, s; while <see cref="IsKnown"/>.</summary>
        public double Interval { get; private set; }

        /// <summary>Standard deviation of the stamps about the line, s; while <see cref="IsKnown"/>.</summary>
        public double Deviation { get; private set; }

        /// <summary>Whether stamps lie so far off that they may be taken for their neighbours'.</summary>
        public bool IsScatteredOut => Deviation > GreatestShare * Interval;

        /// <summary>The line at the newest stamp's number, s; while <see cref="IsKnown"/>.</summary>
        public double Newest { get; private set; }

        /// <summary>The line at the number nearest to a stamp.</summary>
        public double Nearest(double stamp) => Newest + Math.Round((stamp - Newest) / Interval) * Interval;

        /// <summary>Takes the stamp of a sample that follows those before.</summary>
        public void Add(double stamp)
        {
            if (IsKnown && Math.Abs(stamp - Newest) > LongestPause * Interval) Reset();
            var number = IsKnown ? _numbers[_newest] + Math.Max(1, Math.Round((stamp - Newest) / Interval)) : _count;
            _newest = (_newest + 1) % Capacity;
            _stamps[_newest] = stamp;
            _numbers[_newest] = number;
            if (_count < Capacity) _count++;
            if (IsKnown) Fit();
            else if (_count == FewestStamps) Begin();
            if (!IsKnown) return;
            // Numbers once counted wrong would spoil the line until they are gone.
            _misfits = IsScatteredOut ? _misfits + 1 : 0;
            if (_misfits == FewestStamps) Reset();
        }

        public void Reset()
        {
            _count = 0;
            _newest = -1;
            _misfits = 0;
            IsKnown = false;
        }

        // How many samples were lost among the first is unknown: the longest interval that suits the stamps is taken.
        void Begin()
        {
            var span = _stamps[_newest] - _stamps[0];
            var best = 0;
            var leastShare = double.PositiveInfinity;
            for (var lost = 0; lost <= MostLostAtStart && leastShare > ClearShare; lost++)
            {
                Number(span / (_count - 1 + lost));
                if (!IsKnown || Deviation >= Better * leastShare * Interval) continue;
                leastShare = Deviation / Interval;
                best = lost;
            }
            Number(span / (_count - 1 + best));
            if (!IsKnown) Reset();
        }

        void Number(double interval)
        {
            IsKnown = interval > 0;
            Interval = interval;
            Newest = _stamps[0];
            for (var i = 0; i < Refinements && IsKnown; i++)
            {
                for (var k = 0; k < _count; k++) _numbers[k] = Math.Round((_stamps[k] - Newest) / Interval);
                Fit();
            }
        }

        void Fit()
        {
            // Relative to the newest: neither the epoch nor a count of weeks costs digits.
            double stamp = _stamps[_newest], number = _numbers[_newest];
            double sumN = 0, sumT = 0, sumNn = 0, sumNt = 0, sumTt = 0;
            for (var i = 0; i < _count; i++)
            {
                var n = _numbers[i] - number;
                var t = _stamps[i] - stamp;
                sumN += n;
                sumT += t;
                sumNn += n * n;
                sumNt += n * t;
                sumTt += t * t;
            }
            var meanN = sumN / _count;
            var meanT = sumT / _count;
            var spread = sumNn - sumN * meanN;
            var slope = (sumNt - sumN * meanT) / spread;
            if (!(spread > 0) || !(slope > 0))
            {
                Reset();
                return;
            }
            Deviation = Math.Sqrt(Math.Max(0, (sumTt - sumT * meanT - slope * (sumNt - sumN * meanT)) / _count));
            Interval = LikelyInterval(slope, Deviation / Math.Sqrt(spread));
            Newest = stamp + meanT - Interval * meanN;
        }

        // A young line's slope is uncertain, and what it errs the newest number feels most.
        static double LikelyInterval(double slope, double standardError)
        {
            var whole = Math.Round(slope / Beat) * Beat;
            return whole > 0 && Math.Abs(slope - whole) <= Belief * standardError && standardError < Beat ? whole : slope;
        }
    }
}
