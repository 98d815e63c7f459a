using System;
using Nowpose.Prediction.Samples;

namespace Nowpose.Prediction.Forecasting
{
    /// <summary>
    /// State of one joint's motion, as the input of all forecasters: newest samples, sampling interval, rest, change points and the prediction
    /// horizon.
    /// </summary>
    sealed class MotionState
    {
        /// <summary>
        /// Weight of a new value in the running means, which follow a change of rate within ten samples. With 0.05 or 0.2, the errors are up to 0.6 %
        /// larger.
        /// </summary>
        const double MeanWeight = 0.1;

        /// <summary>
        /// Maximum sampling interval, in s. A longer pause enters the mean interval and the noise tracker with this value. Without this limit, a
        /// tenth of the pauses of 2 s or more delayed the next detection of rest with noise by 10 to 90 s.
        /// </summary>
        public const double MaxInterval = 0.3;

        /// <summary>Maximum interval that enters the mean, as a multiple of the mean, so that a single gap hardly changes it.</summary>
        const double MaxGapRatio = 3;

        /// <summary>
        /// Range of the horizon, in s. At shorter horizons, the forecasts hardly differ, so their errors determine no weights. Forecast tables end at
        /// 0.5 s.
        /// </summary>
        const double MinHorizon = 0.01, MaxHorizon = 0.45;

        /// <summary>
        /// Horizon until the first display time is known, in s: a typical latency of 100 ms and half a typical interval of 50 ms.
        /// </summary>
        const double FirstHorizon = 0.125;

        /// <summary>
        /// Maximum ratio of the smaller to the larger of two successive speeds at which a start or stop is detected. With 0.05 or 0.2, the errors on
        /// recordings are 0.2 or 0.4 % larger, and those of simulated motions the same.
        /// </summary>
        const double StartRatio = 0.1;

        readonly double _maximumGap;
        readonly double _maxHorizon;

        /// <param name="samples">History of the sample buffer.</param>
        /// <param name="limits">Limits with the maximum gap between samples of one motion.</param>
        public MotionState(SampleHistory samples, PredictionLimits limits)
        {
            Samples = samples;
            _maximumGap = limits.MaximumGap;
            // Positions beyond the cap are not predicted.
            _maxHorizon = Math.Max(MinHorizon, Math.Min(MaxHorizon, limits.HorizonCap));
            Reset();
        }

        /// <summary>Index 0 is the newest.</summary>
        public SampleHistory Samples { get; }

        public RestDetector Rest { get; } = new RestDetector();

        public ChangePointDetector ChangePoints { get; } = new ChangePointDetector();

        /// <summary>Whether the last added sample is newer than all previous samples; otherwise it was overtaken.</summary>
        public bool IsNewest { get; private set; }

        /// <summary>Number of newest samples without a gap above the maximum.</summary>
        public int ConnectedSamples { get; private set; }

        /// <summary>Number of newest samples that belong to one motion: they have no gap, and follow the newest change point.</summary>
        public int SamplesOfOneMotion => Math.Min(ConnectedSamples, ChangePoints.SamplesSince);

        /// <summary>Interval before the newest sample, in s; 0 until there are two samples.</summary>
        public double Interval { get; private set; }

        /// <summary>Mean speed over <see cref="Interval"/>, per second; 0 until there are two samples.</summary>
        public double Speed { get; private set; }

        /// <summary>Running mean of <see cref="Interval"/>, s; 0 until there are two samples.</summary>
        public double MeanInterval { get; private set; }

        /// <summary>Time at which the joint last started, stopped or reversed, in s.</summary>
        public double Start { get; private set; }

        /// <summary>
        /// Maximum speed that was reached in both of two consecutive intervals in the same direction, per second; 0 before there are two such
        /// intervals. One interval is not enough, because a joint that is repositioned, or whose angle wraps from π to −π, can have any speed in a
        /// single interval.
        /// </summary>
        public double MaxSpeed { get; private set; }

        /// <summary>Mean time from the newest sample to the display time, in s.</summary>
        public double Horizon { get; private set; }

        /// <summary>Updates the state after the buffer has added a sample.</summary>
        /// <param name="isNewest">False if newer samples have overtaken the sample.</param>
        /// <param name="displayed">Last display time, in s; NaN if nothing is displayed.</param>
        public void Add(bool isNewest, double displayed)
        {
            IsNewest = isNewest;
            if (!isNewest) ConnectedSamples = Samples.CountWithoutGap(_maximumGap);
            else ConnectedSamples = Samples.HasGap(0, _maximumGap) ? 1 : Math.Min(ConnectedSamples + 1, Samples.Count);
            var (intervalBefore, speedBefore) = (Interval, Speed);
            if (Samples.Count >= 2) UpdateSpeed();
            if (!isNewest) return;
            ChangePoints.Add(Samples.Count, Interval, Speed, intervalBefore, speedBefore);
            Rest.Add(Samples, Interval);
            if (Samples.Count < 2) return;
            UpdateMeanInterval();
            UpdateStart(speedBefore);
            UpdateMaxSpeed(speedBefore);
            UpdateHorizon(displayed);
        }

        public void Reset()
        {
            Rest.Reset();
            ChangePoints.Reset();
            Interval = Speed = MeanInterval = Start = MaxSpeed = 0;
            ConnectedSamples = 0;
            Horizon = Math.Min(FirstHorizon, _maxHorizon);
        }

        void UpdateSpeed()
        {
            Interval = Samples[0].Time - Samples[1].Time;
            Speed = (Samples[0].Position - Samples[1].Position) / Interval;
        }

        void UpdateMeanInterval()
        {
            var bounded = Math.Min(Interval, MaxInterval);
            MeanInterval = MeanInterval == 0 ? bounded
                : MeanInterval + MeanWeight * (Math.Min(bounded, MaxGapRatio * MeanInterval) - MeanInterval);
        }

        void UpdateStart(double speedBefore)
        {
            double speed = Math.Abs(Speed), before = Math.Abs(speedBefore);
            var hasChanged = before < StartRatio * speed || speed < StartRatio * before || Speed * speedBefore <= 0;
            if (Samples.Count == 2 || hasChanged) Start = Samples[1].Time;
        }

        void UpdateMaxSpeed(double speedBefore)
        {
            if (Speed * speedBefore > 0) MaxSpeed = Math.Max(MaxSpeed, Math.Min(Math.Abs(Speed), Math.Abs(speedBefore)));
        }

        void UpdateHorizon(double displayed)
        {
            // This section is displayed for one sampling interval from now on, so its mean horizon is half an interval longer than the current one.
            var ahead = displayed - Samples.NewestTime + MeanInterval / 2;
            if (ahead > 0) Horizon += MeanWeight * (Math.Min(Math.Max(ahead, MinHorizon), _maxHorizon) - Horizon);
        }
    }
}
