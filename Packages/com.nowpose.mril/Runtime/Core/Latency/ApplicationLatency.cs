using System;

namespace Nowpose.Latency
{
    /// <summary>L_app, sample after sample: control time of arrival minus control time of the sample, Eq. (2).</summary>
    /// <remarks>Schnierle &amp; Röck 2022, Eq. (2). Allocates nothing; not thread-safe.</remarks>
    sealed class ApplicationLatency
    {
        /// <summary>Ten seconds of samples every 50 ms.</summary>
        const int Window = 200;

        readonly RollingPercentiles _recent = new RollingPercentiles(Window);

        /// <summary>Samples measured since the start.</summary>
        public long Count { get; private set; }

        /// <summary>
        /// Samples that arrived before they were taken, as far as the clocks can tell. A few at the start are the clock's
        /// error; more mean that a source does not stamp with the control clock.
        /// </summary>
        public long NegativeCount { get; private set; }

        /// <summary>L_app of the newest sample; negative when its stamp lies ahead of its arrival.</summary>
        public TimeSpan Newest { get; private set; }

        /// <summary>Median of the newest 200; null before the first.</summary>
        public TimeSpan? Median => Percentile(0.5);

        /// <summary>Exceeded by one in twenty of the newest 200; null before the first.</summary>
        public TimeSpan? Percentile95 => Percentile(0.95);

        /// <param name="arrival">Control time at which the sample reached the headset.</param>
        /// <param name="taken">t_k.</param>
        public void Add(ControlTime arrival, ControlTime taken)
        {
            Newest = arrival - taken;
            Count++;
            if (Newest < TimeSpan.Zero) NegativeCount++;
            _recent.Add(Newest);
        }

        /// <summary>Forgets the recent lengths, not the counts: a clock stepped.</summary>
        public void Reset()
        {
            _recent.Reset();
            Newest = TimeSpan.Zero;
        }

        TimeSpan? Percentile(double fraction) => _recent.Count == 0 ? (TimeSpan?)null : _recent.At(fraction);
    }
}
