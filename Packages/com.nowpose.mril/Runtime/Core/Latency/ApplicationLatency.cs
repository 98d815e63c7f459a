using System;

namespace Nowpose.Latency
{
    /// <summary>Statistics of L_app: control time of arrival minus control time of the sample, Eq. (2).</summary>
    /// <remarks>Schnierle &amp; Röck 2022, Eq. (2). Allocates nothing; not thread-safe.</remarks>
    sealed class ApplicationLatency
    {
        /// <summary>Window length in samples: ten seconds at one sample every 50 ms.</summary>
        const int Window = 200;

        readonly RollingPercentiles _recent = new RollingPercentiles(Window);

        /// <summary>
        /// Number of samples whose time stamp is later than their arrival. The error of the clock estimate causes a few such samples at the start. A
        /// larger number means that a source does not use the control clock for its time stamps.
        /// </summary>
        public long NegativeCount { get; private set; }

        /// <summary>L_app of the newest sample; negative when its time stamp is later than its arrival.</summary>
        public TimeSpan Newest { get; private set; }

        /// <summary>Median of the newest 200 samples; null before the first sample.</summary>
        public TimeSpan? Median => Percentile(0.5);

        /// <summary>95th percentile of the newest 200 samples; null before the first sample.</summary>
        public TimeSpan? Percentile95 => Percentile(0.95);

        /// <param name="arrival">Control time at which the sample reached the headset.</param>
        /// <param name="taken">Control time t_k of the sample.</param>
        public void Add(ControlTime arrival, ControlTime taken)
        {
            Newest = arrival - taken;
            if (Newest < TimeSpan.Zero) NegativeCount++;
            _recent.Add(Newest);
        }

        /// <summary>Removes the recent values and keeps <see cref="NegativeCount"/>. Call it after a step of the clock.</summary>
        public void Reset()
        {
            _recent.Reset();
            Newest = TimeSpan.Zero;
        }

        TimeSpan? Percentile(double fraction) => _recent.Count == 0 ? (TimeSpan?)null : _recent.At(fraction);
    }
}
