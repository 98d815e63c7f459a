using System;

namespace Nowpose.Sync.Envelope
{
    /// <summary>
    /// Range of the skew that two exchanges with short round-trip times prove. One is among the oldest exchanges, the other among the newest. At
    /// each of the two times, the offset was between the bounds of the exchange.
    /// </summary>
    readonly struct ProvenSkew
    {
        readonly double _min, _max;

        ProvenSkew(double min, double max) => (_min, _max) = (min, max);

        /// <summary>Computes the range for a history of at least one exchange.</summary>
        /// <param name="resolution">Resolution of the control clock: each bound may be wrong by half of it in either direction.</param>
        public static ProvenSkew Of(BoundsHistory history, TimeSpan resolution)
        {
            var part = (history.Count + 3) / 4;
            var late = Quickest(history, 0, part);
            var early = Quickest(history, history.Count - part, history.Count);
            // The lower bound applies when the request was sent, the upper bound when the reply arrived.
            var shortest = ClockTicks.Seconds(late.Sent - early.Received);
            var longest = ClockTicks.Seconds(late.Received - early.Sent);
            if (!(shortest > 0)) return new ProvenSkew(double.NegativeInfinity, double.PositiveInfinity);
            var minRise = (late.Lower - early.Upper - resolution.Ticks) / (double)TimeSpan.TicksPerSecond;
            var maxRise = (late.Upper - early.Lower + resolution.Ticks) / (double)TimeSpan.TicksPerSecond;
            return new ProvenSkew(minRise / shortest, maxRise / longest);
        }

        /// <summary>Returns the possible skew that is nearest to <paramref name="skew"/>.</summary>
        public double Nearest(double skew) => Math.Max(_min, Math.Min(_max, skew));

        static OffsetBounds Quickest(BoundsHistory history, int from, int to)
        {
            var tightest = history[from];
            for (var i = from + 1; i < to; i++)
                if (history[i].Upper - history[i].Lower < tightest.Upper - tightest.Lower) tightest = history[i];
            return tightest;
        }
    }
}
