using System;
using System.Collections.Generic;

namespace Nowpose.Sync
{
    /// <summary>
    /// Tells a step of a clock from a slow path. A long step contradicts what the recent exchanges prove, which no path,
    /// however slow or lopsided, ever does. A short one shows in how both bounds move. Also notices another resolution.
    /// </summary>
    sealed class ClockStepDetector
    {
        /// <summary>One may be a fault of the server; three in a row that do not go with the past and agree with each other are a change.</summary>
        const int InARow = 3;

        readonly TimeSpan _margin;
        readonly OffsetEnvelope _suspected;
        readonly OffsetShiftWatch _shift = new OffsetShiftWatch();
        readonly List<SyncExchange> _suspects = new List<SyncExchange>(InARow);
        TimeSpan _resolution;
        bool _hasContradicted;

        /// <param name="skewDoubt">As of <see cref="OffsetEnvelope"/>.</param>
        public ClockStepDetector(TimeSpan margin, double skewDoubt)
        {
            _margin = margin;
            _suspected = new OffsetEnvelope(skewDoubt);
        }

        /// <summary>The suspects once they are a change; they are all that is known of the clock since.</summary>
        public IReadOnlyList<SyncExchange> Suspects => _suspects;

        /// <summary>By how much recent exchanges, though used, break a bound of the earlier ones: the clock may be off by as much more.</summary>
        public TimeSpan Suspicion => _shift.Suspicion;

        /// <summary>Judges an exchange that is not in the envelope and the line yet.</summary>
        public ClockChange Judge(in SyncExchange exchange, in ClockLine line, OffsetEnvelope envelope)
        {
            if (line.Exchanges == 0) _resolution = exchange.Resolution;
            var isContradiction = !envelope.Allows(exchange, line, _margin);
            if (isContradiction || IsOther(exchange.Resolution, _resolution)) return Suspect(exchange, isContradiction);
            ForgetSuspects();
            if (!_shift.Judge(exchange, line, envelope)) return ClockChange.None;
            _suspects.AddRange(_shift.Since);
            return ClockChange.ShortStep;
        }

        /// <summary>The suspects are the past from now on.</summary>
        public void Reset()
        {
            _resolution = _suspects[_suspects.Count - 1].Resolution;
            ForgetSuspects();
            _shift.Reset();
        }

        ClockChange Suspect(in SyncExchange exchange, bool isContradiction)
        {
            if (!GoesWithSuspects(exchange)) ForgetSuspects();
            _suspects.Add(exchange);
            _suspected.Add(exchange);
            _hasContradicted |= isContradiction;
            if (_suspects.Count < InARow) return ClockChange.Suspected;
            return _hasContradicted ? ClockChange.LongStep : ClockChange.Resolution;
        }

        bool GoesWithSuspects(in SyncExchange exchange) => _suspects.Count == 0
            || (_suspected.Allows(exchange, default, _margin) && !IsOther(exchange.Resolution, _suspects[0].Resolution));

        // A resolution that the server estimates varies, by less than half of it; what is below the margin matters to nobody.
        bool IsOther(TimeSpan one, TimeSpan other)
        {
            var apart = (one - other).Duration();
            return apart > _margin && apart.Ticks > Math.Max(one.Ticks, other.Ticks) / 2;
        }

        void ForgetSuspects()
        {
            _suspects.Clear();
            _suspected.Reset();
            _hasContradicted = false;
        }
    }
}
