using System;

namespace Nowpose.Prediction.Stamps
{
    /// <summary>Notices that a source has changed its beat: stamps in a row lie on the same side of their line.</summary>
    sealed class BeatWatch
    {
        /// <summary>Scatter alone does not put so many in a row beyond two deviations.</summary>
        const int InARow = 3;

        const double Deviations = 2;

        int _run;

        /// <summary>How many of the newest stamps in a row lie on the same side, far off.</summary>
        public int Run => Math.Abs(_run);

        /// <param name="off">The newest stamp minus its line, s.</param>
        /// <param name="deviation">Of the stamps about the line, s.</param>
        /// <param name="least">Less than this is no change, s.</param>
        /// <returns>Whether the line is that of another beat.</returns>
        public bool Add(double off, double deviation, double least)
        {
            var side = Math.Abs(off) > Math.Max(least, Deviations * deviation) ? Math.Sign(off) : 0;
            _run = side == 0 ? 0 : side == Math.Sign(_run) ? _run + side : side;
            if (Math.Abs(_run) < InARow) return false;
            _run = 0;
            return true;
        }

        public void Reset() => _run = 0;
    }
}
