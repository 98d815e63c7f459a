using System;
using System.Collections.Generic;

namespace Nowpose.Sync
{
    /// <summary>Tells a step of a clock from a slow path: a path, however slow or lopsided, never contradicts the envelope.</summary>
    sealed class ClockStepDetector
    {
        /// <summary>One may be a fault of the server; three in a row that contradict the past and agree with each other are a step.</summary>
        const int InARow = 3;

        readonly TimeSpan _margin;
        readonly OffsetEnvelope _suspected = new OffsetEnvelope();
        readonly List<SyncExchange> _suspects = new List<SyncExchange>(InARow);

        public ClockStepDetector(TimeSpan margin) => _margin = margin;

        /// <summary>The suspects once they are a step; they are all that is known of the new offset.</summary>
        public IReadOnlyList<SyncExchange> Suspects => _suspects;

        public SyncVerdict Judge(in SyncExchange exchange, in ClockLine line, OffsetEnvelope envelope)
        {
            if (envelope.Allows(exchange, line, _margin))
            {
                Reset();
                return SyncVerdict.Consistent;
            }
            if (!_suspected.Allows(exchange, default, _margin)) Reset();
            _suspects.Add(exchange);
            _suspected.Add(exchange);
            return _suspects.Count < InARow ? SyncVerdict.SetAside : SyncVerdict.Step;
        }

        public void Reset()
        {
            _suspects.Clear();
            _suspected.Reset();
        }
    }
}
