using System;

namespace Nowpose.Prediction.Stamps
{
    /// <summary>Corrects the stamps of a source that samples on a beat, then leaves the samples to another predictor.</summary>
    /// <remarks>
    /// At 1 m/s a stamp wrong by 5 ms is 5 mm, which a quadratic at 100 ms turns into 40 mm. Stamps within 0.3 ms of their
    /// line, without a beat, or truer than the line by the positions, are left alone.
    /// </remarks>
    public sealed class DejitteredPredictor : IJointPredictor
    {
        /// <summary>Less scatter than this does no harm, s.</summary>
        const double LeastDeviation = 0.3e-3;

        /// <summary>Stamps that scatter by less are not late now and then, s.</summary>
        const double CleanDeviation = 1e-3;

        /// <summary>In deviations; scatter alone stays within two where it is uniform.</summary>
        const double GreatestLead = 3;

        readonly IJointPredictor _inner;
        readonly StampLine _line = new StampLine();
        readonly StampJudge _judge = new StampJudge();
        readonly BeatWatch _watch = new BeatWatch();
        JointSample _newest;
        bool _hasSample;

        public DejitteredPredictor(IJointPredictor inner)
        {
            _inner = inner ?? throw new ArgumentNullException(nameof(inner));
            Reset();
        }

        /// <inheritdoc/>
        public double Hold => _newest.Position;

        /// <inheritdoc/>
        public double NewestTime => _hasSample ? _newest.Time : double.NegativeInfinity;

        /// <inheritdoc/>
        public SampleOutcome Add(in JointSample sample)
        {
            var isNewest = !_hasSample || sample.Order > _newest.Order;
            if (isNewest) Follow(sample.Time);
            var time = Corrected(sample, isNewest);
            var outcome = _inner.Add(new JointSample(time, sample.Position, time, sample.Velocity, sample.Acceleration));
            if (!isNewest) return outcome;
            _newest = sample;
            _hasSample = true;
            // Scatter alone can make the newest sample look older than another; what counts is that it was taken in.
            return outcome == SampleOutcome.Late ? SampleOutcome.Accepted : outcome;
        }

        /// <inheritdoc/>
        public JointPrediction At(double time) => _inner.At(time);

        /// <inheritdoc/>
        public void Reset()
        {
            _newest = default;
            _hasSample = false;
            _line.Reset();
            _judge.Reset();
            _watch.Reset();
            _inner.Reset();
        }

        void Follow(double stamp)
        {
            _line.Add(stamp);
            if (!_line.IsKnown || !_watch.Add(stamp - _line.Newest, _line.Deviation, LeastDeviation)) return;
            _line.Reset();
            _line.Add(stamp);
        }

        double Corrected(in JointSample sample, bool isNewest)
        {
            if (!_line.IsKnown) return sample.Time;
            var onLine = isNewest ? _line.Newest : _line.Nearest(sample.Time);
            if (isNewest) _judge.Add(sample.Time, onLine, sample.Position);
            var isScattered = _line.Deviation > LeastDeviation && !_line.IsScatteredOut;
            // A stamp may be late by any delay, but none comes before its time: then the beat has changed. So it has when the
            // stamps were nearly clean, or one after the other is late.
            var off = sample.Time - onLine;
            var isOffBeat = (off < 0 || _line.Deviation < CleanDeviation || _watch.Run > 1) && Math.Abs(off) > GreatestLead * _line.Deviation;
            return isScattered && !isOffBeat && _judge.PrefersLine ? onLine : sample.Time;
        }
    }
}
