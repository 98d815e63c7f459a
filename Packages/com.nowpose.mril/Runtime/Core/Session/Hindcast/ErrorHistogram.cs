using System;

namespace Nowpose.Session.Hindcast
{
    /// <summary>Histogram of errors in steps of an eighth of an octave; provides percentiles without storing the values.</summary>
    sealed class ErrorHistogram
    {
        const int StepsPerOctave = 8;

        /// <summary>Range from below the resolution of encoders to 64 rad or m; values outside count in the first or last step.</summary>
        const int LowestOctave = -26, HighestOctave = 6;

        const int Steps = (HighestOctave - LowestOctave) * StepsPerOctave;

        readonly int[] _counts = new int[Steps];

        public void Add(double squared)
        {
            var step = squared > 0 ? (Math.Log(squared) / (2 * Math.Log(2)) - LowestOctave) * StepsPerOctave : 0;
            _counts[(int)Math.Min(Math.Max(step, 0), Steps - 1)]++;
        }

        public void Add(ErrorHistogram other)
        {
            for (var i = 0; i < Steps; i++) _counts[i] += other._counts[i];
        }

        public void Clear() => Array.Clear(_counts, 0, Steps);

        /// <summary>Returns the value below which the given fraction lies; 0 when the histogram is empty.</summary>
        public double At(double fraction)
        {
            long total = 0;
            foreach (var count in _counts) total += count;
            var rank = fraction * total;
            for (var i = 0; i < Steps; i++)
            {
                if (rank < _counts[i]) return SizeAt(i, rank / _counts[i]);
                rank -= _counts[i];
            }
            return 0;
        }

        // The lowest step also contains the zeros.
        static double SizeAt(int step, double part) => step == 0 ? 0 : Math.Pow(2, LowestOctave + (step + part) / StepsPerOctave);
    }
}
