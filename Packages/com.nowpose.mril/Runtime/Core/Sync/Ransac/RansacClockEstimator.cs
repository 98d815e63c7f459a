using System;
using System.Collections.Generic;

namespace Nowpose.Sync.Ransac
{
    /// <summary>
    /// The paper's estimator: the offsets of Eq. (5), outliers removed by RANSAC, a least-squares line through the rest
    /// (Eq. (6)), and a moving average over the fitted lines (Schnierle &amp; Röck 2022, 2.1.1 and Fig. 8).
    /// </summary>
    sealed class RansacClockEstimator : IClockEstimator
    {
        const int MinForLine = 3;

        /// <summary>
        /// Minimum number of exchanges for using the standard error of the skew. A burst of late replies can tilt a line
        /// through fewer exchanges.
        /// </summary>
        const int MatureExchanges = 50;

        /// <summary>
        /// Additional error of the skew. Its standard errors do not include delays that occur in bursts. In fifty simulated outages of 30 s on a
        /// loaded WiFi, the error exceeded three times 80 ppm once, and never exceeded three times 130 ppm.
        /// </summary>
        const double BurstError = 130e-6;

        readonly RansacSettings _settings;
        readonly List<OffsetPoint> _points = new List<OffsetPoint>();
        readonly Queue<ClockLine> _lines = new Queue<ClockLine>();
        Random _random;
        int _exchanges;

        public RansacClockEstimator(RansacSettings settings)
        {
            _settings = settings;
            Restart(ClockLine.MaxSkew);
        }

        public ClockLine Line { get; private set; }

        /// <summary>Zero: this estimator does not search for changes of the path.</summary>
        public TimeSpan PathChangeError => TimeSpan.Zero;

        public TimeSpan? MaxOutsideBounds => null;

        public void Restart(double skewUncertainty)
        {
            _points.Clear();
            _lines.Clear();
            _random = new Random(_settings.Seed);
            _exchanges = 0;
            Line = default;
        }

        public void Add(in SyncExchange exchange)
        {
            _points.Add(new OffsetPoint(exchange));
            if (_points.Count > _settings.History)
                _points.RemoveAt(0);
            _exchanges++;
            Line = _points.Count < MinForLine ? MedianSoFar() : Averaged(Fit());
        }

        ClockLine MedianSoFar()
        {
            var newest = _points[_points.Count - 1];
            // Half the difference from the first offset: the result is the mean of two offsets, or the only offset.
            var change = new TimeSpan((_points[0].Offset - newest.Offset).Ticks / 2);
            return new ClockLine(newest.At, newest.Offset + change, 0, TimeSpan.Zero, ClockLine.MaxSkewError(0), _exchanges);
        }

        double SkewErrorOf(double skew, double standardError)
        {
            var max = Math.Max(standardError, ClockLine.MaxSkewError(skew));
            if (_exchanges < MatureExchanges) return max;
            var (oldest, newest) = (_points[0], _points[_points.Count - 1]);
            var server = ClockLine.ServerSkewError(oldest.ServerErrorBound, newest.ServerErrorBound, newest.At - oldest.At);
            return Math.Min(max, standardError + BurstError + server);
        }

        ClockLine Fit()
        {
            // Times and offsets are relative to the newest exchange, because the normal equations lose milliseconds at absolute times.
            var newest = _points[_points.Count - 1];
            var x = new double[_points.Count];
            var y = new double[_points.Count];
            for (var i = 0; i < x.Length; i++)
            {
                x[i] = ClockTicks.Seconds(_points[i].At - newest.At);
                y[i] = ClockTicks.Seconds(_points[i].Offset - newest.Offset);
            }
            var bound = ClockTicks.Seconds(_settings.InlierBound);
            var inliers = RansacLine.Inliers(x, y, _settings.Hypotheses, bound, _random);
            return FittedLine.Through(inliers.X, inliers.Y, newest.At, newest.Offset, bound, _exchanges);
        }

        // Each earlier line is extrapolated to the present by its own slope before averaging: an average of the offsets at their own times
        // would lag behind by half the window times the skew. The weight of a line is the inverse of its variance at the present. With a
        // full history, all weights are nearly equal; in the paper they are equal. The first lines, which are fitted to few points, have little
        // weight; their slopes would otherwise disturb the average for four seconds.
        ClockLine Averaged(in ClockLine fitted)
        {
            _lines.Enqueue(fitted);
            if (_lines.Count > _settings.MovingAverage)
                _lines.Dequeue();

            double weights = 0, change = 0, skew = 0, error = 0, skewError = 0;
            foreach (var line in _lines)
            {
                var lineError = line.ErrorAt(fitted.Reference);
                var weight = 1 / (lineError * lineError);
                weights += weight;
                change += weight * ClockTicks.Seconds(line.OffsetAt(fitted.Reference) - fitted.Offset);
                skew += weight * line.Skew;
                // Neighbouring lines share all but one of their points, so their errors do not average out.
                error += weight * lineError;
                skewError += weight * line.SkewError;
            }
            return new ClockLine(
                fitted.Reference, fitted.Offset + ClockTicks.Span(change / weights), skew / weights,
                ClockTicks.Span(error / weights), SkewErrorOf(skew / weights, skewError / weights), _exchanges);
        }

        readonly struct OffsetPoint
        {
            public OffsetPoint(in SyncExchange exchange)
            {
                At = exchange.T4;
                Offset = exchange.Offset;
                ServerErrorBound = exchange.ServerErrorBound;
            }

            public HeadsetTime At { get; }
            public ClockOffset Offset { get; }
            public TimeSpan ServerErrorBound { get; }
        }
    }
}
