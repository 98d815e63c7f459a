using System;

namespace Nowpose.Sync
{
    /// <summary>Keeps the clock model: exchanges go in on any thread, the model comes out on any other.</summary>
    public sealed class ClockSynchroniser
    {
        readonly object _gate = new object();
        readonly IClockEstimator _estimator;
        readonly ClockSettings _settings;
        readonly ClockStepDetector _steps;
        readonly OffsetEnvelope _envelope = new OffsetEnvelope();
        SyncExchange _newest;
        bool _hasNewest;
        bool _wasSynchronised;
        volatile Belief _belief = Belief.None;

        public ClockSynchroniser(IClockEstimator estimator, ClockSettings settings)
        {
            _estimator = estimator;
            _settings = settings;
            _steps = new ClockStepDetector(settings.StepMargin);
        }

        /// <summary>How often a clock stepped since the start; a change means that older control times mean nothing any more.</summary>
        public int Steps => _belief.Steps;

        /// <summary>Round-trip time of the newest exchange that was used; zero before the first.</summary>
        public TimeSpan RoundTripTime => _belief.RoundTripTime;

        /// <summary>Checks and takes in one exchange.</summary>
        public SyncVerdict Add(in SyncExchange exchange, out SyncExchangeFault fault)
        {
            lock (_gate)
            {
                fault = _hasNewest && exchange.T4 <= _newest.T4 ? SyncExchangeFault.NotNewer : SyncExchangeRules.Check(exchange);
                if (fault != SyncExchangeFault.None) return SyncVerdict.Dropped;

                _newest = exchange;
                _hasNewest = true;
                var verdict = _steps.Judge(exchange, _envelope);
                if (verdict == SyncVerdict.Consistent) Use(exchange);
                if (verdict == SyncVerdict.Step) StartAnew();
                if (verdict != SyncVerdict.SetAside) Publish(verdict);
                return verdict;
            }
        }

        /// <summary>What is known at a headset time, with the bound and the state as they are by then. Allocates nothing.</summary>
        /// <remarks>
        /// The error bound is what the recent exchanges prove (at best half the least round trip: an asymmetry can hide no
        /// more), the server's own bound, and what three standard errors of the skew and its drift can have added since
        /// the newest exchange.
        /// </remarks>
        public ClockModel ModelAt(HeadsetTime now)
        {
            var belief = _belief;
            var line = belief.Line;
            if (line.Exchanges == 0) return default;

            var age = Math.Max(0, ClockTicks.Seconds(now - line.Reference));
            var grown = ClockTicks.Span((3 * line.SkewError + _settings.Drift) * age);
            var state = belief.State == ClockState.Synchronised && now - line.Reference > _settings.HoldoverAfter
                ? ClockState.Holdover : belief.State;
            return new ClockModel(line.Reference, line.Offset, line.Skew, belief.Bound + grown, state);
        }

        void Use(in SyncExchange exchange)
        {
            _estimator.Add(exchange);
            _envelope.Add(exchange);
        }

        void StartAnew()
        {
            _estimator.Reset();
            _envelope.Reset();
            _wasSynchronised = false;
            foreach (var suspect in _steps.Suspects) Use(suspect);
            _steps.Reset();
        }

        void Publish(SyncVerdict verdict)
        {
            var line = _estimator.Line;
            var bound = _envelope.GreatestError(line.Reference, line.Offset) + _newest.ServerErrorBound;
            var steps = _belief.Steps + (verdict == SyncVerdict.Step ? 1 : 0);
            _belief = new Belief(line, StateOf(line), bound, _newest.RoundTripTime, steps);
        }

        ClockState StateOf(in ClockLine line)
        {
            if (!_newest.ServerSynchronised) return ClockState.Converging;
            // Once settled, scatter alone does not unsettle it: the bound tells how good it is.
            _wasSynchronised = _wasSynchronised || (line.Exchanges >= _settings.ExchangesToSynchronise
                && new TimeSpan(3 * line.OffsetError.Ticks) < _settings.ErrorToSynchronise);
            return _wasSynchronised ? ClockState.Synchronised : ClockState.Converging;
        }

        sealed class Belief
        {
            public static readonly Belief None = new Belief(default, ClockState.Unsynchronised, TimeSpan.Zero, TimeSpan.Zero, 0);

            public Belief(in ClockLine line, ClockState state, TimeSpan bound, TimeSpan roundTripTime, int steps)
            {
                Line = line;
                State = state;
                Bound = bound;
                RoundTripTime = roundTripTime;
                Steps = steps;
            }

            public ClockLine Line { get; }
            public ClockState State { get; }
            public TimeSpan Bound { get; }
            public TimeSpan RoundTripTime { get; }
            public int Steps { get; }
        }
    }
}
