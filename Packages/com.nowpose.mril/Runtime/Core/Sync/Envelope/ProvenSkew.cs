using System;

namespace Nowpose.Sync.Envelope
{
    /// <summary>
    /// Range of the skew that follows from two exchanges with short round trips, one among the oldest and one among the newest: the
    /// offset was between the bounds of each.
    /// </summary>
    readonly struct ProvenSkew
    {
        readonly double _least, _greatest;

        ProvenSkew(double least, double greatest)
        {
            _least = least;
            _greatest = greatest;
        }

        /// <summary>Computes the range for a history of at least one exchange.</summary>
        /// <param name="resolution">Resolution of the control clock: each bound may be wrong by half of it in either direction.</param>
        public static ProvenSkew Of(BoundsHistory history, TimeSpan resolution)
        {
            var part = (history.Count + 3) / 4;
            var late = Quickest(history, 0, part);
            var early = Quickest(history, history.Count - part, history.Count);
            // Each bound applies at its own time.
            var least = ClockTicks.Seconds(late.Sent - early.Received);
            var greatest = ClockTicks.Seconds(late.Received - early.Sent);
            if (!(least > 0)) return new ProvenSkew(double.NegativeInfinity, double.PositiveInfinity);
            var fell = (late.Least - early.Greatest - resolution.Ticks) / (double)TimeSpan.TicksPerSecond;
            var rose = (late.Greatest - early.Least + resolution.Ticks) / (double)TimeSpan.TicksPerSecond;
            return new ProvenSkew(fell / least, rose / greatest);
        }

        /// <summary>Returns the possible skew that is nearest to <paramref name="skew"/>.</summary>
        public double Nearest(double skew) => Math.Max(_least, Math.Min(_greatest, skew));

        static OffsetBounds Quickest(BoundsHistory history, int from, int to)
        {
            var quickest = history[from];
            for (var i = from + 1; i < to; i++)
                if (history[i].Greatest - history[i].Least < quickest.Greatest - quickest.Least) quickest = history[i];
            return quickest;
        }
    }
}
