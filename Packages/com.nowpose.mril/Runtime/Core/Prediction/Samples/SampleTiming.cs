using System;
using Nowpose.Prediction.Forecasting;

namespace Nowpose.Prediction.Samples
{
    /// <summary>Intervals between the samples of a joint or an object, and the prediction horizon.</summary>
    sealed class SampleTiming
    {
        /// <summary>
        /// Weight of a new value in the running means, which follow a change of rate within ten samples. With 0.05 or 0.2, the errors are up to 0.6 %
        /// larger.
        /// </summary>
        public const double MeanWeight = 0.1;

        /// <summary>
        /// Interval that counts as a pause, as a multiple of the mean interval. A single pause hardly changes the mean. With 1.5 or 6, the mean errors change
        /// by at most 0.1 %.
        /// </summary>
        const double PauseRatio = 3;

        /// <summary>
        /// Horizon until the first display time is known, in s: a typical latency of 100 ms and half a typical interval of 50 ms.
        /// </summary>
        const double FirstHorizon = 0.125;

        readonly double _maximumGap;
        readonly double _maxHorizon;

        /// <param name="limits">Limits with the maximum gap between samples of one motion.</param>
        public SampleTiming(PredictionLimits limits)
        {
            _maximumGap = limits.MaximumGap;
            // Positions beyond the cap are not predicted.
            _maxHorizon = Math.Min(ForecastTable.Span, limits.HorizonCap);
            Reset();
        }

        /// <summary>Number of newest samples without a gap above the maximum.</summary>
        public int ConnectedSamples { get; private set; }

        /// <summary>Interval before the newest sample, in s; 0 until there are two samples.</summary>
        public double Interval { get; private set; }

        /// <summary>
        /// Whether samples may be missing before the newest one, or its stamp may be in the future: the interval is several times as long as the mean.
        /// </summary>
        public bool IsAfterPause => Interval > PauseRatio * MeanInterval;

        /// <summary>Running mean of <see cref="Interval"/>, s; 0 until there are two samples without a gap.</summary>
        public double MeanInterval { get; private set; }

        /// <summary>Mean time from the newest sample to the display time, in s.</summary>
        public double Horizon { get; private set; }

        /// <summary>Updates the intervals after a sample has been added to the history.</summary>
        /// <param name="before">Time of the previous newest sample, in s; negative infinity if there is none.</param>
        /// <param name="displayed">Last display time, in s; NaN if nothing is displayed.</param>
        public void Add<TSample>(SampleBuffer<TSample> samples, double before, double displayed) where TSample : struct, ISample<TSample>
        {
            ConnectedSamples = samples.CountWithoutGap(_maximumGap);
            if (!(samples.NewestTime > before))
            {
                // The added sample may be the one before the newest.
                if (samples.Count > 1) Interval = samples[0].Time - samples[1].Time;
                return;
            }
            if (double.IsNegativeInfinity(before)) return;
            Interval = samples.NewestTime - before;
            // A pause is not a sampling interval.
            if (!(Interval > _maximumGap))
                MeanInterval += MeanInterval == 0 ? Interval : MeanWeight * (Math.Min(Interval, PauseRatio * MeanInterval) - MeanInterval);
            // This section is displayed for one sampling interval from now on, so its mean horizon is half an interval longer than the current one.
            var ahead = displayed - samples.NewestTime + MeanInterval / 2;
            if (ahead > 0) Horizon += MeanWeight * (Math.Min(ahead, _maxHorizon) - Horizon);
        }

        public void Reset()
        {
            Interval = MeanInterval = 0;
            ConnectedSamples = 0;
            Horizon = Math.Min(FirstHorizon, _maxHorizon);
        }
    }
}
