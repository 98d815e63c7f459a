using System;
using System.Collections.Generic;

namespace Nowpose.Sync
{
    /// <summary>
    /// Tells a step of a clock from a slow path. A long step contradicts what the recent exchanges prove, which no path,
    /// however slow or lopsided, ever does. A short one shows in how both bounds move.
    /// </summary>
    sealed class ClockStepDetector
    {
        /// <summary>One may be a fault of the server; three in a row that contradict the past and agree with each other are a step.</summary>
        const int InARow = 3;

        readonly TimeSpan _margin;
        readonly OffsetEnvelope _suspected;
        readonly OffsetShiftWatch _shift = new OffsetShiftWatch();
        readonly List<SyncExchange> _suspects = new List<SyncExchange>(InARow);

        /// <param name="skewDoubt">As of <see cref="OffsetEnvelope"/>.</param>
        public ClockStepDetector(TimeSpan margin, double skewDoubt)
        {
            _margin = margin;
            _suspected = new OffsetEnvelope(skewDoubt);
        }

        /// <summary>The suspects once they are a step; they are all that is known of the new offset.</summary>
        public IReadOnlyList<SyncExchange> Suspects => _suspects;

        /// <summary>By how much recent exchanges, used though they are, break a bound of the earlier ones: the clock may be off by as much more.</summary>
        public TimeSpan Suspicion => _shift.Suspicion;

        /// <param name="isShort">Whether the step is a short one, of two clocks that have not changed otherwise.</param>
        public SyncVerdict Judge(in SyncExchange exchange, in ClockLine line, OffsetEnvelope envelope, out bool isShort)
        {
            isShort = false;
            if (!envelope.Allows(exchange, line, _margin)) return Suspect(exchange);
            ForgetSuspects();
            if (!_shift.Judge(exchange, line, envelope)) return SyncVerdict.Consistent;
            isShort = true;
            _suspects.AddRange(_shift.Since);
            return SyncVerdict.Step;
        }

        public void Reset()
        {
            ForgetSuspects();
            _shift.Reset();
        }

        SyncVerdict Suspect(in SyncExchange exchange)
        {
            if (!_suspected.Allows(exchange, default, _margin)) ForgetSuspects();
            _suspects.Add(exchange);
            _suspected.Add(exchange);
            return _suspects.Count < InARow ? SyncVerdict.SetAside : SyncVerdict.Step;
        }

        void ForgetSuspects()
        {
            _suspects.Clear();
            _suspected.Reset();
        }
    }
}
