using System;
using System.Collections.Generic;
using Nowpose.Sync.Envelope;

namespace Nowpose.Sync
{
    /// <summary>Detects a clock step that is shorter than a round-trip time, which no single exchange contradicts.</summary>
    /// <remarks>
    /// When the offset steps, both bounds move with it: several requests arrive earlier than ever before and all replies arrive later, or vice
    /// versa. The minimum round-trip time stays the same. A path that becomes shorter or longer moves one bound, or moves both bounds apart. A path
    /// that becomes shorter in one direction and longer in the other moves them by different amounts. None of these changes is a step. If one
    /// direction becomes shorter by as much as the other becomes longer, the change is not distinguishable from a step.
    /// </remarks>
    sealed class OffsetShiftWatch
    {
        /// <summary>
        /// MinAge: minimum age, in exchanges, of an exchange that contributes to the bounds. MinPast: minimum number of exchanges of at least this
        /// age. Newer exchanges do not contribute: after a step whose first exchanges are late, they would move the bounds in small steps.
        /// </summary>
        const int MinAge = 2 * OffsetShift.MinExchanges, MinPast = 30;

        /// <summary>Maximum standard error of the skew with which a bound can be extrapolated over a minute.</summary>
        const double MaxSkewError = 25e-6;

        readonly OffsetCorridor _past = new OffsetCorridor(OffsetShift.MinExchanges);
        readonly OffsetShift _rise = new OffsetShift(1), _fall = new OffsetShift(-1);

        /// <summary>
        /// Maximum violation of a bound by recent exchanges, caused by a step or by a path that has become shorter; zero without a violation.
        /// </summary>
        public TimeSpan Suspicion => ClockTicks.Span(Math.Max(_rise.Broken, _fall.Broken));

        /// <summary>Exchanges since the step that <see cref="Judge"/> detected.</summary>
        public IReadOnlyList<SyncExchange> Since { get; private set; }

        public void Reset()
        {
            _rise.Reset();
            _fall.Reset();
        }

        /// <returns>Whether a clock has stepped.</returns>
        /// <param name="exchange">An exchange that is not yet in the envelope.</param>
        /// <param name="line">Clock line before this exchange is added to the estimate.</param>
        public bool Judge(in SyncExchange exchange, in ClockLine line, OffsetEnvelope envelope)
        {
            if (line.Exchanges == 0 || line.SkewError > MaxSkewError) return false;
            envelope.Fill(_past, line, MinAge - 1);
            if (_past.Count < MinPast) return false;
            var hasRisen = _rise.Judge(exchange, line, _past);
            var hasFallen = _fall.Judge(exchange, line, _past);
            Since = hasRisen ? _rise.Since : _fall.Since;
            return hasRisen || hasFallen;
        }
    }
}
