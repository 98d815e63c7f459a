using System;
using System.Collections.Generic;
using Nowpose.Sync.Envelope;

namespace Nowpose.Sync
{
    /// <summary>
    /// Compares the exchanges since the first violation of a bound with the line and the bounds before it. Shows
    /// whether the opposite bound has moved by the same amount, which indicates a clock step. Single-threaded; allocates nothing after
    /// construction.
    /// </summary>
    sealed class OffsetShift
    {
        /// <summary>Minimum number of exchanges for the detection of a step.</summary>
        public const int MinExchanges = 15;

        /// <summary>Minimum number of exchanges that violate the bound for the detection of a step.</summary>
        const int MinViolations = 3;

        /// <summary>Maximum number of exchanges, three seconds at the quick pace. If they do not confirm a step, the path has changed.</summary>
        const int MaxExchanges = 60;

        /// <summary>
        /// MinShift: minimum step, s. LatenessShare: minimum step as a multiple of the accuracy of the bounds, which is the mean lateness divided by
        /// the number of older exchanges.
        /// </summary>
        const double MinShift = 0.15e-3, LatenessShare = 10;

        /// <summary>
        /// Minimum ratio of the smaller to the larger movement of the two bounds. A step moves both bounds by the same amount and leaves
        /// the minimum round-trip time unchanged, while the two directions of a path change by different amounts.
        /// </summary>
        const double CommonShare = 0.8;

        /// <summary>
        /// Movement of the other bound that is attributed to late packets, as a fraction of the maximum lateness in the earlier groups of exchanges
        /// (<see cref="OffsetCorridor.RowBelow"/> and <see cref="OffsetCorridor.RowAbove"/>). With the full maximum, steps of half a millisecond over
        /// WiFi would not be detected.
        /// </summary>
        const double RowShare = 0.75;

        readonly int _sign;
        readonly OffsetCorridor _past = new OffsetCorridor(MinExchanges);
        readonly List<SyncExchange> _since = new List<SyncExchange>(MaxExchanges);
        ClockLine _line;
        int _violations;
        double _broken, _other;

        /// <param name="sign">1 to detect a rise of the offset, which violates the lower bound; −1 to detect a fall.</param>
        public OffsetShift(int sign) => _sign = sign;

        /// <summary>Exchanges since the first exchange that violates the bound; empty if none does.</summary>
        public List<SyncExchange> Since => _since;

        /// <summary>Maximum violation of the bound, s; zero while no exchange violates it.</summary>
        public double Broken => _since.Count == 0 ? 0 : _broken;

        public void Reset() => _since.Clear();

        /// <returns>Whether a clock has stepped.</returns>
        /// <param name="line">Clock line before this exchange is added to the estimate.</param>
        /// <param name="past">Bounds from earlier exchanges, relative to the line. The newest exchanges are not included.</param>
        public bool Judge(in SyncExchange exchange, in ClockLine line, OffsetCorridor past)
        {
            if (_since.Count == MaxExchanges) _since.Clear();
            if (_since.Count == 0)
            {
                if (Violation(exchange, line, past) <= Margin(exchange, line, past)) return false;
                // Stores the current line and bounds, because the exchanges after a step also move the line.
                _line = line;
                _past.CopyFrom(past);
                (_violations, _broken, _other) = (0, 0, double.PositiveInfinity);
            }
            var margin = Margin(exchange, _line, _past);
            var (below, above) = OffsetCorridor.Residuals(_line, new OffsetBounds(exchange));
            var violation = Violation(exchange, _line, _past);
            _since.Add(exchange);
            if (violation > margin) _violations++;
            _broken = Math.Max(_broken, violation);
            _other = Math.Min(_other, _sign > 0 ? above - _past.Upper : _past.Lower - below);
            if (_since.Count < MinExchanges || _violations < MinViolations) return false;
            // The larger the group, the smaller the lateness of the packet with the shortest delay.
            var byChance = RowShare * (_sign > 0 ? _past.RowAbove : _past.RowBelow) * MinExchanges / _since.Count;
            return _other - byChance > Math.Max(margin, CommonShare * _broken)
                && CommonShare * _other <= _broken + ClockTicks.Seconds(exchange.Resolution);
        }

        double Violation(in SyncExchange exchange, in ClockLine line, OffsetCorridor past)
        {
            var (below, above) = OffsetCorridor.Residuals(line, new OffsetBounds(exchange));
            return _sign > 0 ? below - past.Lower : past.Upper - above;
        }

        // Includes the resolution, because the stamps of a coarse clock occasionally appear to step by it.
        static double Margin(in SyncExchange exchange, in ClockLine line, OffsetCorridor past) =>
            Math.Max(MinShift + ClockTicks.Seconds(exchange.Resolution), LatenessShare * past.Lateness / past.Count)
            + line.SkewError * ClockTicks.Seconds(exchange.T4 - line.Reference);
    }
}
