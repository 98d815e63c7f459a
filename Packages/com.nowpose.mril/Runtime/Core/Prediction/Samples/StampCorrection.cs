using System;

namespace Nowpose.Prediction.Samples
{
    /// <summary>Puts the stamps of a source that samples on a beat back on it.</summary>
    /// <remarks>
    /// At 1 m/s a stamp wrong by 5 ms is 5 mm, which a quadratic at 100 ms turns into 40 mm. Stamps within 0.3 ms of their
    /// line, without a beat, or truer than the line by the positions, are left alone.
    /// </remarks>
    sealed class StampCorrection
    {
        /// <summary>Less scatter than this does no harm, s.</summary>
        const double MinDeviation = 0.3e-3;

        /// <summary>Stamps that scatter by less are not late now and then, s.</summary>
        const double CleanDeviation = 1e-3;

        /// <summary>In deviations; scatter alone stays within two where it is uniform.</summary>
        const double MaxLead = 3;

        /// <summary>
        /// Stamps in a row beyond two deviations on the same side, which scatter alone does not make: the beat has changed.
        /// </summary>
        const int InARow = 3;

        /// <summary>Distance from the line, in deviations, beyond which a stamp is off it.</summary>
        const double Deviations = 2;

        readonly StampLine _line = new StampLine();
        readonly StampJudge _judge = new StampJudge();

        // How many of the newest stamps lie far off in a row, with the sign of their side.
        int _run;

        /// <summary>The time to use for a sample.</summary>
        /// <param name="stamp">Uncorrected, s.</param>
        public double Correct(double stamp, double position, bool isNewest)
        {
            if (isNewest) Follow(stamp);
            if (!_line.IsKnown) return stamp;
            var onLine = isNewest ? _line.Newest : _line.Nearest(stamp);
            if (isNewest) _judge.Add(stamp, onLine, position);
            var isScattered = _line.Deviation > MinDeviation && !_line.IsScatteredOut;
            // A stamp may be late by any delay, but none comes before its time: then the beat has changed. So it has when the
            // stamps were nearly clean, or one after the other is late.
            var off = stamp - onLine;
            var isOffBeat = (off < 0 || _line.Deviation < CleanDeviation || Math.Abs(_run) > 1)
                && Math.Abs(off) > MaxLead * _line.Deviation;
            return isScattered && !isOffBeat && _judge.PrefersLine ? onLine : stamp;
        }

        public void Reset()
        {
            _line.Reset();
            _judge.Reset();
            _run = 0;
        }

        void Follow(double stamp)
        {
            _line.Add(stamp);
            if (!_line.IsKnown) return;
            var off = stamp - _line.Newest;
            var side = Math.Abs(off) > Math.Max(MinDeviation, Deviations * _line.Deviation) ? Math.Sign(off) : 0;
            _run = side == 0 ? 0 : side == Math.Sign(_run) ? _run + side : side;
            if (Math.Abs(_run) < InARow) return;
            _run = 0;
            _line.Reset();
            _line.Add(stamp);
        }
    }
}
