using System;

namespace Nowpose.Prediction.Samples
{
    /// <summary>
    /// Decides whether the stamps are wrong or the sampling is irregular: positions form a smooth curve over their true sampling
    /// times, but not over others.
    /// </summary>
    /// <remarks>
    /// Each sample is compared with the quadratic through the three before it, once with the reported stamps and once with
    /// those of the line; the better one gets a vote. The stamps of a source that really samples irregularly must not be changed.
    /// </remarks>
    sealed class SmoothnessTest
    {
        /// <summary>Weight of one vote in the mean: eight full votes against the line reject it at first, 25 after it was right for long.</summary>
        const double VoteWeight = 0.03;

        /// <summary>Maximum vote; a vote is the decimal logarithm of the ratio of the errors, up to a factor of ten.</summary>
        const double MaxVote = 1;

        /// <summary>Initial vote for the line, and the threshold below which it is not used; for noise the votes are balanced.</summary>
        const double Beginning = 0.2;

        const double Majority = -0.05;

        const int Kept = 4;

        readonly double[] _reported = new double[Kept];
        readonly double[] _onLine = new double[Kept];
        readonly double[] _positions = new double[Kept];
        int _count;
        double _vote;

        public SmoothnessTest() => Reset();

        /// <summary>Whether the line's times fit the positions at least as well as the reported ones.</summary>
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
            _vote += VoteWeight * (Math.Min(Math.Max(vote, -MaxVote), MaxVote) - _vote);
        }

        public void Reset()
        {
            _count = 0;
            _vote = Beginning;
        }

        // Lagrange form of the quadratic through samples 1 to 3 at the time of sample 0; NaN or infinite if two times coincide.
        double ErrorOf(double[] t)
        {
            var guess = 0.0;
            for (var i = 1; i < Kept; i++)
            {
                var term = _positions[i] - _positions[0];
                for (var j = 1; j < Kept; j++)
                    if (j != i) term *= (t[0] - t[j]) / (t[i] - t[j]);
                guess += term;
            }
            return Math.Abs(guess);
        }
    }
}
