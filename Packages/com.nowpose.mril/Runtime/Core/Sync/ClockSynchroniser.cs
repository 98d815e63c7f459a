using System;
using Nowpose.Sync.Envelope;

namespace Nowpose.Sync
{
    /// <summary>Maintains the clock model. Thread-safe: exchanges can be added and the model can be read on any thread.</summary>
    /// <remarks>
    /// These classes detect changes, in this order. The last three belong to the <see cref="DefaultClockEstimator"/>, which only exchanges without a
    /// detected clock change reach.
    /// <list type="number">
    /// <item><see cref="ClockStepDetector"/>: steps that contradict the bounds of recent exchanges, corrections by the server, other resolutions. It
    /// widens the bound, makes the clock converging, and restarts the line when three exchanges agree, or five for a correction.</item>
    /// <item><see cref="OffsetShiftWatch"/> with two <see cref="OffsetShift"/>: steps below a round-trip time, from 15 exchanges. Bound and estimated
    /// error include the suspected step; the line restarts when it is confirmed.</item>
    /// <item><see cref="FastSlewDetector"/>: steps of the first two that are a fast slew. It makes the clock converging until 10 s after the last one.
    /// </item>
    /// <item><see cref="MinDelay"/>, one for each direction: a path that has become longer or shorter. It corrects the measured bounds and increases
    /// the error of the line.</item>
    /// <item><see cref="OffsetMemory"/>: an offset that has moved away from its extrapolation over 30 s. It increases the error of the line.</item>
    /// <item><see cref="UnrecognisedChange"/>: a path change that the others have not recognised. It increases the estimated error, and the fit of the
    /// next exchange allows for the change.</item>
    /// </list>
    /// If they are wrong and the line of the <see cref="DefaultClockEstimator"/> stays outside the bounds of the recent exchanges, it restarts.
    /// </remarks>
    sealed class ClockSynchroniser
    {
        /// <summary>Minimum number of exchanges of a coarse clock. Fewer exchanges do not show the scatter of their delays.</summary>
        internal const int ExchangesToBeCoarse = 5;

        /// <summary>
        /// Minimum number of contradicting exchanges for the state to become converging. A single contradicting exchange may be erroneous.
        /// </summary>
        const int SuspectsToConverge = 2;

        /// <summary>
        /// Standard deviations of the change of the skew, dimensionless. SkewUncertaintyOfSameClocks: the resolution of a clock changed, or the server
        /// corrected it. SkewUncertaintyAfterStep: another machine may provide the control clock, or a small step may be the start of a slew.
        /// SkewUncertaintyAfterSilence: after a long time without exchanges, the headset may have slept and cooled down.
        /// </summary>
        const double SkewUncertaintyOfSameClocks = 1e-6, SkewUncertaintyAfterStep = 50e-6, SkewUncertaintyAfterSilence = 5e-6;

        /// <summary>
        /// Maximum time for which the line may be outside the bounds of the recent exchanges. A change of the rate of the control clock that was
        /// mistaken for a change of the path causes such a line. Without a restart, it would remain there for hours.
        /// </summary>
        static readonly TimeSpan MaxContradiction = TimeSpan.FromSeconds(10);

        readonly object _gate = new object();
        readonly IClockEstimator _estimator;
        readonly ClockSettings _settings;
        readonly ClockStepDetector _detector;
        readonly OffsetEnvelope _envelope;
        readonly FastSlewDetector _slew = new FastSlewDetector();
        readonly ErrorThreshold _coarse, _synchronised;
        SyncExchange? _newest;
        HeadsetTime? _contradictsSince;
        volatile Estimate _estimate = Estimate.None;

        public ClockSynchroniser(IClockEstimator estimator, ClockSettings settings)
        {
            _estimator = estimator;
            _settings = settings;
            _detector = new ClockStepDetector(settings.StepMargin, settings.SkewVariation);
            _envelope = new OffsetEnvelope(settings.SkewVariation);
            _coarse = new ErrorThreshold(settings.CoarseError);
            _synchronised = new ErrorThreshold(settings.ErrorToSynchronise);
        }

        /// <summary>Number of clock steps since the start.</summary>
        public int Steps => _estimate.Steps;

        /// <summary>Round-trip time of the newest exchange that was used; zero before the first exchange.</summary>
        public TimeSpan RoundTripTime => _estimate.RoundTripTime;

        /// <summary>Resolution of the control clock in the newest exchange that was used; zero if unknown and before the first exchange.</summary>
        public TimeSpan Resolution => _estimate.Resolution;

        /// <summary>Standard error of the offset at the newest exchange; zero before the first exchange.</summary>
        public TimeSpan OffsetError => _estimate.Line.OffsetError;

        /// <summary>
        /// Number of exchanges that the model is based on: all since the start, the last step or correction of the control clock, the last long
        /// time without exchanges, or the last restart of a line that had stayed outside the bounds of the recent exchanges.
        /// </summary>
        public int Exchanges => _estimate.Line.Exchanges;

        /// <summary>Whether recent exchanges indicate a step or a correction that only further exchanges can confirm.</summary>
        public bool IsStepSuspected => _estimate.IsStepSuspected;

        /// <summary>Raised for each exchange with its verdict, in order, by <see cref="Add"/> on the same thread.</summary>
        /// <remarks>A handler must be fast, must not throw, and must not call this object.</remarks>
        public event SyncExchangeHandler Judged;

        /// <summary>Checks an exchange and adds it.</summary>
        public SyncVerdict Add(in SyncExchange exchange, out SyncExchangeFault fault)
        {
            lock (_gate)
            {
                var verdict = Take(exchange, out fault);
                Judged?.Invoke(exchange, verdict, fault);
                return verdict;
            }
        }

        /// <summary>Returns the model at a headset time, with error bound and state as of that time. Allocates nothing.</summary>
        /// <remarks>
        /// The error bound is the sum of the bound from the recent exchanges (at most half the minimum round-trip time, the maximum effect of an
        /// asymmetry), the server's error bound, and the growth since the newest exchange due to the uncertain skew. It relies on the resolution that
        /// the server states. If a clock steps by less than the minimum round-trip time, the bound includes the step from the first exchange on whose
        /// delay is short enough to show it. A step of less than about 0.3 ms may not be detected; the bound then includes it only after the
        /// exchanges before the step have become a minute old.
        /// </remarks>
        public ClockModel ModelAt(HeadsetTime now)
        {
            var estimate = _estimate;
            var line = estimate.Line;
            if (line.Exchanges == 0) return default;

            var age = Math.Max(0, ClockTicks.Seconds(now - line.Reference));
            // Skew beyond the maximum of real clocks counts as an error, because a line through two late replies can be too steep.
            var excess = Math.Max(0, Math.Abs(line.Skew) - ClockLine.MaxSkew);
            var grown = ClockTicks.Span((3 * line.SkewError + _settings.SkewVariation + excess) * age);
            var isUsable = estimate.State == ClockState.Synchronised || estimate.State == ClockState.Coarse;
            var state = isUsable && now - line.Reference > _settings.HoldoverAfter ? ClockState.Holdover : estimate.State;
            return new ClockModel(
                line.Reference, line.Offset, line.Skew, estimate.Bound + grown, state, estimate.Steps, estimate.EstimatedError + grown);
        }

        SyncVerdict Take(in SyncExchange exchange, out SyncExchangeFault fault)
        {
            fault = exchange.T4 <= _newest?.T4 ? SyncExchangeFault.NotNewer : SyncExchangeRules.Check(exchange);
            if (fault != SyncExchangeFault.None) return SyncVerdict.Dropped;

            if (exchange.T4 - _newest?.T4 > _settings.RestartAfter)
            {
                ResetLine(SkewUncertaintyAfterSilence);
                _detector.ForgetSuspects();
            }
            _newest = exchange;
            switch (_detector.Judge(exchange, _estimator.Line, _envelope))
            {
                case ClockChange.Suspected:
                    WidenBound(exchange, IsSerious(exchange));
                    return SyncVerdict.SetAside;
                case ClockChange.Resolution:
                case ClockChange.ServerCorrection:
                    Restart(exchange, SkewUncertaintyOfSameClocks, stepped: false);
                    return SyncVerdict.Consistent;
                case ClockChange.Step:
                    Restart(exchange, SkewUncertaintyAfterStep, stepped: true);
                    return SyncVerdict.Step;
                default:
                    Use(exchange);
                    var proven = _envelope.ErrorOf(_estimator.Line);
                    if (IsRefuted(proven.Min, exchange.T4))
                    {
                        ResetLine(SkewUncertaintyAfterStep);
                        _estimator.Add(exchange);
                        proven = _envelope.ErrorOf(_estimator.Line);
                    }
                    Publish(exchange, proven.Max, stepped: false);
                    return SyncVerdict.Consistent;
            }
        }

        void Use(in SyncExchange exchange)
        {
            _estimator.Add(exchange);
            _envelope.Add(exchange);
        }

        void Restart(in SyncExchange exchange, double skewUncertainty, bool stepped)
        {
            ResetLine(skewUncertainty);
            _envelope.Reset();
            foreach (var suspect in _detector.Suspects) Use(suspect);
            _detector.Reset();
            if (stepped) _slew.Add(_estimator.Line);
            Publish(exchange, _envelope.ErrorOf(_estimator.Line).Max, stepped);
        }

        // Returns whether the line has been outside the bounds of the recent exchanges for too long.
        bool IsRefuted(TimeSpan outside, HeadsetTime now)
        {
            if (!(_estimator.MaxOutsideBounds is TimeSpan allowed)) return false;
            if (outside <= _settings.StepMargin + allowed) _contradictsSince = null;
            else _contradictsSince ??= now;
            return now - _contradictsSince > MaxContradiction;
        }

        // Keeps the envelope, because it shows whether a clock stepped during the time without exchanges.
        void ResetLine(double skewUncertainty)
        {
            _estimator.Restart(skewUncertainty);
            _detector.ForgetShift();
            _contradictsSince = null;
            _coarse.Reset();
            _synchronised.Reset();
        }

        bool IsSerious(in SyncExchange exchange) => _estimator.Line.Exchanges == 0 || !exchange.ServerSynchronised || IsStepProbable;

        // The estimated error includes the server's error bound, so it remains valid while the server corrects its clock within this bound.
        bool IsStepProbable => _detector.Unexplained >= SuspectsToConverge;

        // Keeps the previous line, and widens its error bound so that the bound includes the contradiction. If the contradiction is serious, the
        // state becomes converging.
        void WidenBound(in SyncExchange exchange, bool isSerious)
        {
            var model = ModelAt(exchange.T4);
            var contradiction = (exchange.Offset - model.OffsetAt(exchange.T4)).Duration() + exchange.RoundTripTime.Duration()
                + exchange.ServerErrorBound;
            var bound = contradiction > _estimate.Bound ? contradiction : _estimate.Bound;
            _estimate = new Estimate(
                _estimate.Line, isSerious ? ClockState.Converging : _estimate.State, bound, isSerious ? bound : _estimate.EstimatedError,
                _estimate.RoundTripTime, _estimate.Resolution, _estimate.Steps, isStepSuspected: true);
        }

        // The proven error is a parameter, because the check of the line needs it too, and computing it reads all recent exchanges.
        void Publish(in SyncExchange exchange, TimeSpan proven, bool stepped)
        {
            var line = _estimator.Line;
            // While a step is suspected, this exchange allows for it, and either the earlier or the suspected exchanges are right.
            var suspected = _detector.MaxSuspectedError(line);
            var bound = (suspected > proven ? suspected : proven) + _detector.Suspicion;
            var error = IsStepProbable ? bound : EstimatedError(line, proven) + _detector.Suspicion;
            _estimate = new Estimate(
                line, StateOf(line, error, exchange.ServerSynchronised && !_slew.IsSlewedAt(exchange.T4)), bound, error, exchange.RoundTripTime,
                exchange.Resolution, _estimate.Steps + (stepped ? 1 : 0), _detector.Suspects.Count > 0 || _detector.Suspicion > TimeSpan.Zero);
        }

        TimeSpan EstimatedError(in ClockLine line, TimeSpan proven)
        {
            if (line.OffsetError == TimeSpan.Zero) return proven;
            var likely = new TimeSpan(3 * line.OffsetError.Ticks) + _estimator.PathChangeError + _envelope.ServerErrorBound();
            return likely > proven ? proven : likely;
        }

        ClockState StateOf(in ClockLine line, TimeSpan error, bool isReliable)
        {
            if (!isReliable || IsStepProbable) return ClockState.Converging;
            if (line.Exchanges >= _settings.ExchangesToSynchronise && _synchronised.Admits(error)) return ClockState.Synchronised;
            return line.Exchanges >= ExchangesToBeCoarse && _coarse.Admits(error) ? ClockState.Coarse : ClockState.Converging;
        }

        sealed class Estimate
        {
            public static readonly Estimate None = new Estimate(default, ClockState.Unsynchronised, default, default, default, default, 0, false);

            public Estimate(
                in ClockLine line, ClockState state, TimeSpan bound, TimeSpan estimatedError, TimeSpan roundTripTime, TimeSpan resolution,
                int steps, bool isStepSuspected)
            {
                Line = line;
                State = state;
                Bound = bound;
                EstimatedError = estimatedError;
                RoundTripTime = roundTripTime;
                Resolution = resolution;
                Steps = steps;
                IsStepSuspected = isStepSuspected;
            }

            public ClockLine Line { get; }
            public ClockState State { get; }
            public TimeSpan Bound { get; }
            public TimeSpan EstimatedError { get; }
            public TimeSpan RoundTripTime { get; }
            public TimeSpan Resolution { get; }
            public int Steps { get; }
            public bool IsStepSuspected { get; }
        }
    }
}
