using System;

namespace Nowpose.Prediction.Samples
{
    /// <summary>
    /// Tells whether the stamps err or the sampling does: positions lie on a smooth curve over the times at which they were
    /// taken, and not over others.
    /// </summary>
    /// <remarks>
    /// Each sample is compared with the quadratic through the three before it, once with the stamps as reported and once with
    /// those of the line, and counts a vote for the better one. The stamps of a source that truly samples off the beat must be used as they are.
    /// </remarks>
    sealed class StampJudge
    {
        /// <summary>Weight of one vote: a dozen clear ones turn the verdict.</summary>
        const double Share = 0.03;

        /// <summary>A vote is the decimal logarithm of the errors' ratio, up to a factor of ten.</summary>
        const double MaxVote = 1;

        /// <summary>Trust in the line to begin with, and below which it is lost; where positions are noise the votes are even.</summary>
        const double Beginning = 0.2;

        const double Majority = -0.05;

        const int Kept = 4;

        readonly double[] _reported = new double[Kept];
        readonly double[] _onLine = new double[Kept];
        readonly double[] _positions = new double[Kept];
        int _count;
        double _vote;

        public StampJudge() => Reset();

        /// <summary>Whether the line's times suit the positions no worse than the reported ones.</summary>
        public bool PrefersLine => _vote >= Majority;

        public void Add(double reported, double onLine, double position)
        {
            for (var i = Kept - 1; i > 0; i--)
            {
                _reported[i] = _reported[i - 1];
                _onLine[i] = _onLine[i - 1];
                _positions[i] = _positions[i - 1];
            }
            _reported[0] = reported;
            _onLine[0] = onLine;
            _positions[0] = position;
            if (_count < Kept) _count++;
            if (_count < Kept) return;
            double errorReported = ErrorOf(_reported), errorOnLine = ErrorOf(_onLine);
            if (!(errorReported > 0 && errorOnLine > 0)) return;
            var vote = Math.Log10(errorReported / errorOnLine);
            _vote += Share * (Math.Min(Math.Max(vote, -MaxVote), MaxVote) - _vote);
        }

        public void Reset()
        {
            _count = 0;
            _vote = Beginning;
        }

        // Lagrange's form of the quadratic through samples 1 to 3 at the time of sample 0; no number where two times coincide.
        double ErrorOf(double[] t)
        {
            var guess = 0.0;
            for (var i = 1; i < Kept; i++)
            {
                var share = _positions[i] - _positions[0];
                for (var j = 1; j < Kept; j++)
                    if (j != i) share *= (t[0] - t[j]) / (t[i] - t[j]);
                guess += share;
            }
            return Math.Abs(guess);
        }
    }
}
