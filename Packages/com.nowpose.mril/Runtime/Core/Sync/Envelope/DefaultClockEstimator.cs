using System;

namespace Nowpose.Sync.Envelope
{
    /// <summary>
    /// The default estimator. The offset lies between the lower bounds from requests and the upper bounds from replies. The bounds from packets with
    /// short delays are close to the offset. The estimate is halfway between two curves along these bounds. It needs no outlier rejection, and its
    /// accuracy increases with the number of exchanges.
    /// </summary>
    /// <remarks>
    /// An offset according to Eq. (5) of the paper is the mean of a request's and a reply's bound, and is wrong if either packet is late. This
    /// estimator uses requests and replies separately. An asymmetry of the minimum delays is not observable; the error bound includes it.
    /// </remarks>
    sealed class DefaultClockEstimator : IClockEstimator
    {
        /// <summary>
        /// History: maximum number of exchanges that are used, which is three minutes at five exchanges per second. HistorySeconds: their maximum
        /// age, s. Older exchanges do not improve the accuracy.
        /// </summary>
        const int History = 900;
        const double HistorySeconds = 180;

        /// <summary>
        /// NewestBlock: number of exchanges in the newest block. Each block has one exchange more than the next newer block, up to MaxBlock. In a
        /// quiet network, the short blocks show the current skew; in a busy network, the long blocks contain at least one packet with a short delay.
        /// </summary>
        const int NewestBlock = 6, MaxBlock = 30;

        /// <summary>
        /// Minimum ratio of the number of exchanges to the block length. A block whose packets are all late can be recognised only by comparison with
        /// several other blocks.
        /// </summary>
        const int MinBlocks = 10;

        /// <summary>Maximum number of blocks. Shorter blocks than NewestBlock occur only with fewer than 60 exchanges: at most 20.</summary>
        const int MaxBlocks = History / NewestBlock;

        /// <summary>
        /// ScatterShare: maximum hidden scatter of the bounds, as a multiple of the mean excess of the round-trip times over their minimum.
        /// MinForScatter: minimum number of exchanges for this limit to apply.
        /// </summary>
        const int ScatterShare = 2, MinForScatter = 5;

        /// <summary>
        /// SkewPrior: initial standard deviation of the skew, dimensionless. SkewWander: increase of this standard deviation after a restart, 1/s.
        /// </summary>
        const double SkewPrior = 50e-6, SkewWander = 0.05e-6;

        /// <summary>
        /// Age of the slope that is used as the skew for extrapolation, s. The slope at the end of the curve is the least certain, and an
        /// extrapolation may last for seconds or minutes.
        /// </summary>
        const double SkewAge = 20;

        /// <summary>
        /// Time constant with which the steady (long-term) skew follows the estimate, s. When the delays of a path change, the curve bends from the
        /// earlier bounds to the new bounds. Its slope then shows neither the skew of the clocks nor the accuracy of the skew.
        /// </summary>
        const double SkewTimeConstant = 60;

        const double SecondsPerTick = 1e-7;

        readonly BoundsHistory _history = new BoundsHistory(History, ClockTicks.Span(HistorySeconds), expiresByServerError: true);
        readonly EnvelopeSide _below = new EnvelopeSide(1, MaxBlocks);
        readonly EnvelopeSide _above = new EnvelopeSide(-1, MaxBlocks);
        readonly EnvelopeFit _fit;
        readonly MinDelay _up, _down;
        readonly OffsetMemory _memory = new OffsetMemory();
        readonly UnrecognisedChange _unrecognised;
        readonly UnsampledPart _unsampledPart = new UnsampledPart();
        OffsetCurve _curve;
        double _expectedSkew, _steadySkew, _steadySkewError, _steadyBend;
        double _skewUncertainty = SkewPrior;
        HeadsetTime _start;
        int _exchanges;

        public DefaultClockEstimator()
        {
            _fit = new EnvelopeFit(_below, _above);
            _up = new MinDelay(1, _history);
            _down = new MinDelay(-1, _history);
            _unrecognised = new UnrecognisedChange(_below, _above, _history);
        }

        public ClockLine Line { get; private set; }

        public TimeSpan PathChangeError { get; private set; }

        public TimeSpan? MaxOutsideBounds { get; private set; } = TimeSpan.Zero;

        public void Restart(double skewUncertainty)
        {
            if (_exchanges > 0) _expectedSkew = Line.Skew;
            _skewUncertainty = Math.Min(SkewPrior, skewUncertainty + (_exchanges > 0 ? Line.SkewError : SkewPrior));
            _curve = new OffsetCurve(_expectedSkew, 0);
            _history.Clear();
            _up.Reset();
            _down.Reset();
            _memory.Reset();
            _unrecognised.Reset();
            _exchanges = 0;
            Line = default;
        }

        public void Add(in SyncExchange exchange)
        {
            _history.Add(new OffsetBounds(exchange).Shifted(ClockTicks.Span(_up.Excess).Ticks, -ClockTicks.Span(_down.Excess).Ticks));
            if (Line.Exchanges > 0)
            {
                var resolution = ClockTicks.Seconds(exchange.Resolution);
                // Measures relative to the steady curve: after a change of the path, the newest bounds tilt and bend the current curve, which would
                // hide or exaggerate the change.
                var steady = new OffsetCurve(_steadySkew, _steadyBend);
                _up.Measure(steady);
                _down.Measure(steady);
                var since = Math.Max(_up.Update(_down, _steadySkewError, resolution), _down.Update(_up, _steadySkewError, resolution));
                if (since > 0)
                {
                    _memory.Explain();
                    _unrecognised.Explain(since);
                }
            }
            if (_exchanges++ == 0)
            {
                _start = exchange.T4;
                _steadySkew = _expectedSkew;
                _steadyBend = 0;
                _steadySkewError = _skewUncertainty;
            }

            var newest = _history[0];
            // Halves each bound first, because their sum may overflow.
            var middle = newest.Lower / 2 + newest.Upper / 2;
            var scatter = Collect(newest.Received, middle);
            var running = ClockTicks.Seconds(newest.Received - _start);
            // A skew outside the proven range would leave large residuals, as if the data were inaccurate.
            var proven = ProvenSkew.Of(_history, exchange.Resolution);
            var part = _unsampledPart.Of(_history, exchange.Resolution);
            var unsampled = ClockTicks.Seconds(part);
            var common = UnsampledPart.CommonError(part, exchange.Resolution);
            _fit.Solve(
                ClockTicks.Seconds(scatter + exchange.Resolution), unsampled, new OffsetCurve(proven.Nearest(_curve.Slope), _curve.Bend),
                proven.Nearest(_expectedSkew), Math.Min(SkewPrior, _skewUncertainty + SkewWander * running),
                (ClockTicks.Seconds(_unrecognised.ProbableAt - newest.Received), _unrecognised.ProbableChange));
            _curve = _fit.Curve;
            Line = LineAt(newest.Received, middle, running, unsampled, ClockTicks.Seconds(common));
            MaxOutsideBounds = common;
            PathChangeError = ClockTicks.Span(_unrecognised.Error(_up, _down));
        }

        // Collects the bounds of both sides. Returns the maximum difference between bounds that are equally accurate.
        TimeSpan Collect(HeadsetTime reference, long referenceOffset)
        {
            _below.Clear();
            _above.Clear();
            var largest = Math.Max(1, Math.Min(MaxBlock, _history.Count / MinBlocks));
            var length = Math.Min(NewestBlock, largest);
            for (var from = 0; from + length <= _history.Count; from += length, length = Math.Min(length + 1, largest))
                CollectBlock(from, length, reference, referenceOffset);
            long min = long.MaxValue, sum = 0;
            for (var i = 0; i < _history.Count; i++)
            {
                var roundTrip = _history[i].Upper - _history[i].Lower;
                min = Math.Min(min, roundTrip);
                sum += roundTrip;
            }
            // If the round-trip times scatter little, all bounds are nearly equal, even if the round-trip times are long.
            var scatter = ScatterShare * (sum / _history.Count - min);
            return new TimeSpan(Math.Max(0, _history.Count < MinForScatter ? min : Math.Min(min, scatter)));
        }

        // Adds the tightest bound of a block to each side. The bounds are compared along the curve, whose height has no effect.
        void CollectBlock(int from, int length, HeadsetTime reference, long referenceOffset)
        {
            var curve = _curve;
            var (lowest, highest) = (double.PositiveInfinity, double.NegativeInfinity);
            var (below, above) = (from, from);
            for (var i = from; i < from + length; i++)
            {
                ref readonly var bounds = ref _history[i];
                // A multiplication takes a fraction of the time of a division, which only the selected bounds need.
                var lower = (bounds.Lower - referenceOffset) * SecondsPerTick - curve.At((bounds.Sent - reference).Ticks * SecondsPerTick);
                var upper = (bounds.Upper - referenceOffset) * SecondsPerTick - curve.At((bounds.Received - reference).Ticks * SecondsPerTick);
                if (lower > highest) (highest, below) = (lower, i);
                if (upper < lowest) (lowest, above) = (upper, i);
            }
            var (request, reply) = (_history[below], _history[above]);
            _below.Add(ClockTicks.Seconds(request.Sent - reference), ClockTicks.Seconds(new TimeSpan(request.Lower - referenceOffset)));
            _above.Add(ClockTicks.Seconds(reply.Received - reference), ClockTicks.Seconds(new TimeSpan(reply.Upper - referenceOffset)));
        }

        ClockLine LineAt(HeadsetTime reference, long referenceOffset, double running, double unsampled, double common)
        {
            var span = ClockTicks.Seconds(reference - _history[_history.Count - 1].Received);
            var slope = _curve.Slope - 2 * _curve.Bend * Math.Min(SkewAge, span / 2);
            var skew = ClockLine.LimitSkew(slope);
            var passed = _history.Count < 2 ? 0 : ClockTicks.Seconds(reference - _history[1].Received);
            // The time constant is at most half of the elapsed time.
            var share = Math.Min(1, passed / Math.Max(1e-3, Math.Min(SkewTimeConstant, running / 2)));
            _steadySkew += (skew - _steadySkew) * share;
            _steadyBend += (_curve.Bend - _steadyBend) * share;
            // Error of the slope if the offset is wrong by half of the unsampled part at one end of the history and by the opposite amount at the
            // other end. A third of this error is used as the standard error.
            var hidden = unsampled / Math.Max(1e-3, span) / 3;
            var oldest = _history[_history.Count - 1];
            var server = ClockLine.ServerSkewError(
                new TimeSpan(oldest.ServerErrorBound), new TimeSpan(_history[0].ServerErrorBound), reference - oldest.Received);
            var skewError = Math.Min(
                ClockLine.MaxSkewError(skew), _fit.SlopeError + Math.Abs(skew - _steadySkew) + Math.Abs(slope - skew) + hidden + server);
            _steadySkewError += (skewError - _steadySkewError) * share;
            var offset = new ClockOffset(new TimeSpan(referenceOffset) + ClockTicks.Span(_fit.Offset));
            // Three standard errors include the common error.
            var error = _fit.OffsetError + (_up.Error + _down.Error) / 2 + common / 3;
            var line = new ClockLine(reference, offset, skew, ClockTicks.Span(error), skewError, _exchanges);
            _memory.Add(line, running);
            return new ClockLine(reference, offset, skew, ClockTicks.Span(error + _memory.Error), skewError, _exchanges);
        }
    }
}
