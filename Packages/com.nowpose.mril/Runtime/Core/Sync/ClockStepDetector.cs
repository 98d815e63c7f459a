using System;
using System.Collections.Generic;
using Nowpose.Sync.Envelope;

namespace Nowpose.Sync
{
    /// <summary>
    /// Distinguishes a step of a clock from a slow path. A large step contradicts the bounds from recent exchanges; no path can do this, however slow
    /// or asymmetric it is. A small step moves the lower and the upper bound by the same amount. Also detects a change of the resolution.
    /// </summary>
    sealed class ClockStepDetector
    {
        /// <summary>
        /// Number of exchanges that must contradict earlier exchanges and agree with each other to indicate a change. Exchanges between them must
        /// agree with them.
        /// </summary>
        const int InARow = 3;

        /// <summary>
        /// Replaces <see cref="InARow"/> if the server may have corrected its clock. It equals the minimum number of exchanges for a coarse clock,
        /// so that the pose remains current when the estimate restarts.
        /// </summary>
        const int InARowAfterCorrection = ClockSynchroniser.ExchangesToBeCoarse;

        /// <summary>
        /// Maximum time since the newest suspected exchange. If all later exchanges allow for the step for this long, the suspected exchanges were
        /// erroneous, or the step is too small to be detected in this way. While a step is suspected, the exchanges are quick and the bound is wide.
        /// </summary>
        static readonly TimeSpan MaxTimeWithoutSuspects = TimeSpan.FromSeconds(10);

        readonly TimeSpan _margin;
        readonly OffsetEnvelope _suspected;
        readonly OffsetShiftWatch _shift = new OffsetShiftWatch();
        readonly List<SyncExchange> _suspects = new List<SyncExchange>(InARowAfterCorrection);
        TimeSpan _resolution;
        bool _hasContradicted;
        int _unexplained;

        /// <param name="skewUncertainty">See <see cref="OffsetEnvelope"/>.</param>
        public ClockStepDetector(TimeSpan margin, double skewUncertainty)
        {
            _margin = margin;
            _suspected = new OffsetEnvelope(skewUncertainty);
        }

        /// <summary>Suspected exchanges; after a detected change, all exchanges since the change.</summary>
        public IReadOnlyList<SyncExchange> Suspects => _suspects;

        /// <summary>
        /// Maximum amount by which recent exchanges that are not suspected violate an earlier bound; the clock may have this additional error.
        /// </summary>
        public TimeSpan Suspicion => _shift.Suspicion;

        /// <summary>
        /// Whether the error bounds that the server stated explain all contradictions of the suspected exchanges. Also true without suspected
        /// exchanges.
        /// </summary>
        public bool IsServerCorrection { get; private set; } = true;

        /// <summary>
        /// Number of suspected exchanges in a row that the server's error bounds do not explain, whether or not they agree with each other: during a fast
        /// slew, they do not.
        /// </summary>
        public int Unexplained => IsServerCorrection ? 0 : _unexplained;

        /// <summary>
        /// Returns the maximum distance of the true offset from the line at its reference time if the suspected exchanges are right; zero without
        /// suspected exchanges.
        /// </summary>
        public TimeSpan MaxSuspectedError(in ClockLine line) => _suspects.Count == 0 ? TimeSpan.Zero : _suspected.ErrorOf(line).Max;

        /// <summary>Classifies an exchange before it is added to the envelope and the line.</summary>
        public ClockChange Judge(in SyncExchange exchange, in ClockLine line, OffsetEnvelope envelope)
        {
            if (line.Exchanges == 0) _resolution = exchange.Resolution;
            var isContradiction = !envelope.Allows(exchange, line, _margin);
            var hasOtherResolution = IsOther(exchange.Resolution, _resolution);
            if (isContradiction || hasOtherResolution)
            {
                var isExplained = !hasOtherResolution && envelope.Explains(exchange, line, _margin);
                // An exchange of another kind begins a new group, so that a single exchange never completes a step.
                if (isExplained != IsServerCorrection || !AgreesWithSuspects(exchange)) BeginGroup();
                _unexplained = isExplained ? 0 : _unexplained + 1;
                _hasContradicted |= isContradiction;
                IsServerCorrection = isExplained;
                return Suspect(exchange);
            }
            // A long round-trip time can hide a step: an exchange that allows for the suspected step does not refute it. If the server corrects its
            // clock, exchanges contradict earlier exchanges more often, so only consecutive exchanges count.
            if (exchange.ServerErrorBound > _margin || !AgreesWithSuspects(exchange) || AreSuspectsOld(exchange.T4)) ForgetSuspects();
            if (!_shift.Judge(exchange, line, envelope)) return ClockChange.None;
            ForgetSuspects();
            _suspects.AddRange(_shift.Since);
            return Suspicion > envelope.MaxServerErrorBound() + exchange.ServerErrorBound ? ClockChange.Step : ClockChange.ServerCorrection;
        }

        /// <summary>Makes the suspected exchanges the reference for later exchanges.</summary>
        public void Reset()
        {
            _resolution = _suspects[_suspects.Count - 1].Resolution;
            ForgetSuspects();
        }

        /// <summary>Discards the comparison of the recent exchanges with a line that restarts.</summary>
        public void ForgetShift() => _shift.Reset();

        /// <summary>
        /// Discards the suspected exchanges, for example after a long time without exchanges, because exchanges before and after such a time do not
        /// indicate a change.
        /// </summary>
        public void ForgetSuspects()
        {
            BeginGroup();
            _unexplained = 0;
        }

        void BeginGroup()
        {
            _suspects.Clear();
            _suspected.Reset();
            _hasContradicted = false;
            IsServerCorrection = true;
        }

        ClockChange Suspect(in SyncExchange exchange)
        {
            _suspects.Add(exchange);
            _suspected.Add(exchange);
            if (_suspects.Count < (IsServerCorrection ? InARowAfterCorrection : InARow)) return ClockChange.Suspected;
            if (IsServerCorrection) return ClockChange.ServerCorrection;
            return _hasContradicted ? ClockChange.Step : ClockChange.Resolution;
        }

        bool AgreesWithSuspects(in SyncExchange exchange) => _suspects.Count == 0
            || (_suspected.Allows(exchange, default, _margin, includeServerError: true) && !IsOther(exchange.Resolution, _suspects[0].Resolution));

        bool AreSuspectsOld(HeadsetTime now) => _suspects.Count > 0 && now - _suspects[_suspects.Count - 1].T4 > MaxTimeWithoutSuspects;

        // A server may estimate its resolution. Such an estimate varies by less than half of its value, which is not a change. A difference below the
        // margin has no effect.
        bool IsOther(TimeSpan one, TimeSpan other)
        {
            var apart = (one - other).Duration();
            return apart > _margin && apart.Ticks > Math.Max(one.Ticks, other.Ticks) / 2;
        }
    }
}
