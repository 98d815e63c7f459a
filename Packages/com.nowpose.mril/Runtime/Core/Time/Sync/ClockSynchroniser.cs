using System;

namespace Nowpose.Sync
{
    /// <summary>Keeps the clock model: exchanges go in on any thread, the model comes out on any other.</summary>
    public sealed class ClockSynchroniser
    {
        /// <summary>One exchange that contradicts the past may be a fault; two are reason to doubt the clock already.</summary>
        const int SuspectsToDoubt = 2;

        readonly object _gate = new object();
        readonly IClockEstimator _estimator;
        readonly ClockSettings _settings;
        readonly ClockStepDetector _detector;
        readonly OffsetEnvelope _envelope = new OffsetEnvelope();
        SyncExchange? _newest;
        bool _wasSynchronised;
        volatile Belief _belief = Belief.None;

        public ClockSynchroniser(IClockEstimator estimator, ClockSettings settings)
        {
            _estimator = estimator;
            _settings = settings;
            _detector = new ClockStepDetector(settings.StepMargin);
        }

        /// <summary>How often a clock stepped since the start.</summary>
        public int Steps => _belief.Steps;

        /// <summary>Round-trip time of the newest exchange that was used; zero before the first.</summary>
        public TimeSpan RoundTripTime => _belief.RoundTripTime;

        /// <summary>Each exchange with what became of it, in their order; raised by <see cref="Add"/> on its thread.</summary>
        /// <remarks>A handler must be quick, must not throw, and must not call back.</remarks>
        public event SyncExchangeHandler Judged;

        /// <summary>Checks and takes in one exchange.</summary>
        public SyncVerdict Add(in SyncExchange exchange, out SyncExchangeFault fault)
        {
            lock (_gate)
            {
                var verdict = Take(exchange, out fault);
                Judged?.Invoke(exchange, verdict, fault);
                return verdict;
            }
        }

        /// <summary>What is known at a headset time, with the bound and the state as they are by then. Allocates nothing.</summary>
        /// <remarks>
        /// The error bound is what the recent exchanges prove (at best half the least round trip: an asymmetry can hide no
        /// more), the server's own bound, and what doubts of the skew can have added since the newest exchange. It counts on
        /// the server to say its clock's resolution. A step of less than the least round trip and the step margin can be
        /// missed; then, for 25 exchanges, the bound does not cover it.
        /// </remarks>
        public ClockModel ModelAt(HeadsetTime now)
        {
            var belief = _belief;
            var line = belief.Line;
            if (line.Exchanges == 0) return default;

            var age = Math.Max(0, ClockTicks.Seconds(now - line.Reference));
            // More than any clock's skew is error by definition: a line through two late replies can be that steep.
            var excess = Math.Max(0, Math.Abs(line.Skew) - ClockLine.GreatestSkew);
            var grown = ClockTicks.Span((3 * line.SkewError + _settings.SkewDoubt + excess) * age);
            var state = belief.State == ClockState.Synchronised && now - line.Reference > _settings.HoldoverAfter
                ? ClockState.Holdover : belief.State;
            return new ClockModel(line.Reference, line.Offset, line.Skew, belief.Bound + grown, state, belief.Steps);
        }

        SyncVerdict Take(in SyncExchange exchange, out SyncExchangeFault fault)
        {
            fault = exchange.T4 <= _newest?.T4 ? SyncExchangeFault.NotNewer : SyncExchangeRules.Check(exchange);
            if (fault != SyncExchangeFault.None) return SyncVerdict.Dropped;

            if (exchange.T4 - _newest?.T4 > _settings.StartAnewAfter) ForgetTheLine();
            _newest = exchange;
            var verdict = _detector.Judge(exchange, _estimator.Line, _envelope);
            if (verdict == SyncVerdict.Consistent) Use(exchange);
            else if (verdict == SyncVerdict.Step) StartAnew();
            else if (_detector.Suspects.Count >= SuspectsToDoubt || _estimator.Line.Exchanges == 0) Doubt(exchange);
            if (verdict != SyncVerdict.SetAside) Publish(exchange, verdict == SyncVerdict.Step);
            return verdict;
        }

        void Use(in SyncExchange exchange)
        {
            _estimator.Add(exchange);
            _envelope.Add(exchange);
        }

        void StartAnew()
        {
            ForgetTheLine();
            _envelope.Reset();
            foreach (var suspect in _detector.Suspects) Use(suspect);
            _detector.Reset();
        }

        // The proofs stay: they are what tells whether a clock stepped meanwhile.
        void ForgetTheLine()
        {
            _estimator.Reset();
            _wasSynchronised = false;
        }

        // The old line stays in use, but no longer as a settled one, and with a bound that admits the contradiction.
        void Doubt(in SyncExchange exchange)
        {
            var model = ModelAt(exchange.T4);
            var contradiction = (exchange.Offset - model.OffsetAt(exchange.T4)).Duration() + exchange.RoundTripTime.Duration();
            var bound = contradiction > _belief.Bound ? contradiction : _belief.Bound;
            _belief = new Belief(_belief.Line, ClockState.Converging, bound, _belief.RoundTripTime, _belief.Steps);
        }

        void Publish(in SyncExchange exchange, bool stepped)
        {
            var line = _estimator.Line;
            var bound = _envelope.GreatestError(line) + exchange.ServerErrorBound;
            _belief = new Belief(line, StateOf(line, exchange.ServerSynchronised), bound, exchange.RoundTripTime, _belief.Steps + (stepped ? 1 : 0));
        }

        ClockState StateOf(in ClockLine line, bool isServerSynchronised)
        {
            if (!isServerSynchronised) return ClockState.Converging;
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
