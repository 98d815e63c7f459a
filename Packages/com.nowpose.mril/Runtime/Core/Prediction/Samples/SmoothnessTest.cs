using System;

namespace Nowpose.Prediction.Samples
{
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
