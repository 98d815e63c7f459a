using System;

namespace Nowpose.Prediction.Samples
{
    /// <summary>Corrects the stamps of a periodic source to its sampling times.</summary>
    /// <remarks>
    /// At 1 m/s a stamp error of 5 ms is 5 mm, which a quadratic at 100 ms turns into 40 mm. Stamps are not changed if they are within
    /// 0.3 ms of their line, have no period, or fit the positions better than the line does.
    /// </remarks>
    sealed class StampCorrection
    {
        /// <summary>Minimum standard deviation of stamps to correct, in s; less scatter is harmless.</summary>
        const double MinDeviation = 0.3e-3;

        /// <summary>Stamps with a smaller standard deviation are not occasionally late, in s.</summary>
        const double CleanDeviation = 1e-3;

        /// <summary>Maximum distance from the line, in standard deviations; uniform scatter stays within two.</summary>
        const double MaxLead = 3;

        /// <summary>
        /// Number of consecutive stamps beyond two deviations on the same side, which is unlikely for scatter: the period has changed.
        /// </summary>
        const int InARow = 3;

        /// <summary>Distance from the line, in standard deviations, beyond which a stamp is off it.</summary>
        const double Deviations = 2;

        readonly StampLine _line = new StampLine();
        readonly StampJudge _judge = new StampJudge();

        // Number of consecutive newest stamps that are off the line, with the sign of their side.
        int _run;

        /// <summary>Returns the corrected time of a sample.</summary>
        /// <param name="stamp">Uncorrected stamp, in s.</param>
        public double Correct(double stamp, double position, bool isNewest)
        {
            if (isNewest) Follow(stamp);
            if (!_line.IsKnown) return stamp;
            var onLine = isNewest ? _line.Newest : _line.Nearest(stamp);
            if (isNewest) _judge.Add(stamp, onLine, position);
            var isScattered = _line.Deviation > MinDeviation && !_line.IsScatteredOut;
            // A stamp may be late by any delay but is never early, so an early stamp means that the period has changed. So does an offset when the
            // stamps had little scatter, or several consecutive late stamps.
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
