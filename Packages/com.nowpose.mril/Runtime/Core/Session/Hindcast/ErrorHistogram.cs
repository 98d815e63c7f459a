using System;

namespace Nowpose.Session.Hindcast
{
    /// <summary>Histogram of errors in steps of an eighth of an octave; provides percentiles without storing the values.</summary>
    sealed class ErrorHistogram
    {
        const int StepsPerOctave = 8;

        /// <summary>
        /// Exponents of 2 that bound the range: from 1.5e-8, below the resolution of encoders, to 64 rad or m. Values outside the range are counted
        /// in the first or last step.
        /// </summary>
        const int LowestOctave = -26, HighestOctave = 6;

        const int Steps = (HighestOctave - LowestOctave) * StepsPerOctave;

        static readonly double StepsPerNaturalLogarithm = StepsPerOctave / (2 * Math.Log(2));

        readonly int[] _counts = new int[Steps];

        // Range of the steps in use. Loops skip all other steps, because the errors of one quantity fall into only a few steps.
        int _first = Steps, _end;

        public void Add(double squared)
        {
            var step = squared > 0 ? Math.Log(squared) * StepsPerNaturalLogarithm - LowestOctave * StepsPerOctave : 0;
            var place = (int)Math.Min(Math.Max(step, 0), Steps - 1);
            _counts[place]++;
            Cover(place, place + 1);
        }

        public void Add(ErrorHistogram other)
        {
            for (var i = other._first; i < other._end; i++) _counts[i] += other._counts[i];
            Cover(other._first, other._end);
        }

        public void Clear()
        {
            if (_first < _end) Array.Clear(_counts, _first, _end - _first);
            (_first, _end) = (Steps, 0);
        }

        /// <summary>Returns the value below which the given fraction of the errors lies; 0 when the histogram is empty.</summary>
        public double At(double fraction)
        {
            long total = 0;
            for (var i = _first; i < _end; i++) total += _counts[i];
            var rank = fraction * total;
            for (var i = _first; i < _end; i++)
            {
                if (rank < _counts[i]) return SizeAt(i, rank / _counts[i]);
                rank -= _counts[i];
            }
            return 0;
        }

        void Cover(int first, int end) => (_first, _end) = (Math.Min(_first, first), Math.Max(_end, end));

        // The lowest step also contains the zeros.
        static double SizeAt(int step, double part) => step == 0 ? 0 : Math.Pow(2, LowestOctave + (step + part) / StepsPerOctave);
    }
}
