using System;
using Nowpose.Prediction.Samples;

namespace Nowpose.Prediction.Forecasting
{
    /// <summary>
    /// State of one joint that all forecasters share: newest samples, sampling interval, rest, change points and the prediction horizon.
    /// </summary>
    sealed class MotionState
    {
        /// <summary>Weight of a new value in the running means, which follow a change of rate within ten samples.</summary>
        const double MeanShare = 0.1;

        /// <summary>Maximum sampling interval, in s; a longer pause is not included in the mean.</summary>
        const double MaxInterval = 0.3;

        /// <summary>Maximum interval that enters the mean, as a multiple of the mean, so that a single gap hardly changes it.</summary>
        const double MaxGapRatio = 3;

        /// <summary>Range of the horizon, in s: forecast tables end at 0.5 s.</summary>
        const double MinHorizon = 0.01, MaxHorizon = 0.45;

        /// <summary>Horizon before the first displayed moment is known, in s.</summary>
        const double FirstHorizon = 0.125;

        /// <summary>A speed below this share of the neighbouring one marks a start or a stop.</summary>
        const double StartShare = 0.1;

        readonly double _maximumGap;
        readonly double _maxHorizon;
        double _lastSpeed;

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

        /// <summary>Whether the last sample taken is newer than all before; otherwise it was overtaken.</summary>
        public bool IsNewest { get; private set; }

        /// <summary>Number of newest samples without a gap above the maximum.</summary>
        public int Connected { get; private set; }

        /// <summary>Number of newest samples that belong to one motion.</summary>
        public int OfOneMotion => Math.Min(Connected, ChangePoints.Available);

        /// <summary>Interval before the newest sample, in s; 0 before two samples.</summary>
        public double Interval { get; private set; }

        /// <summary>Mean speed over <see cref="Interval"/>, per second; 0 before two samples.</summary>
        public double Speed { get; private set; }

        /// <summary>Running mean of <see cref="Interval"/>, s; 0 before two samples.</summary>
        public double MeanInterval { get; private set; }

        /// <summary>Time at which the joint last started, stopped or reversed, in s.</summary>
        public double Start { get; private set; }

        /// <summary>
        /// Maximum speed of two consecutive intervals in the same direction, per second; 0 before there were two. One interval is not enough,
        /// because a joint that is repositioned, or whose angle wraps from π to −π, can have any speed in a single interval.
        /// </summary>
        public double MaxSpeed { get; private set; }

        /// <summary>Mean time from the newest sample to the display time, in s.</summary>
        public double Horizon { get; private set; }

        /// <summary>Processes the sample that the buffer took last.</summary>
        /// <param name="isNewest">False if newer samples have overtaken it.</param>
        /// <param name="displayed">The last displayed moment, in s; NaN if nothing is displayed.</param>
        public void Take(bool isNewest, double displayed)
        {
            IsNewest = isNewest;
            Connected = isNewest && !Samples.HasGap(0, _maximumGap) ? Math.Min(Connected + 1, Samples.Count) : Samples.CountWithoutGap(_maximumGap);
            if (!isNewest) return;
            double intervalBefore = 0, speedBefore = 0;
            if (Samples.Count >= 2) (Interval, Speed) = Increment(0);
            if (Samples.Count >= 3) (intervalBefore, speedBefore) = Increment(1);
            ChangePoints.Add(Samples.Count, Interval, Speed, intervalBefore, speedBefore);
            Rest.Add(Samples, Interval);
            if (Samples.Count >= 2) Measure(speedBefore, displayed);
        }

        public void Reset()
        {
            Rest.Reset();
            ChangePoints.Reset();
            Interval = Speed = MeanInterval = Start = MaxSpeed = _lastSpeed = 0;
            Connected = 0;
            Horizon = Math.Min(FirstHorizon, _maxHorizon);
        }

        void Measure(double speedBefore, double displayed)
        {
            var bounded = Math.Min(Interval, MaxInterval);
            MeanInterval = MeanInterval == 0 ? bounded
                : MeanInterval + MeanShare * (Math.Min(bounded, MaxGapRatio * MeanInterval) - MeanInterval);
            if (Samples.Count == 2 || IsStart(Speed, speedBefore)) Start = Samples[1].Time;
            if (Speed * _lastSpeed > 0) MaxSpeed = Math.Max(MaxSpeed, Math.Min(Math.Abs(Speed), Math.Abs(_lastSpeed)));
            _lastSpeed = Speed;
            // On average, the display uses this section for another half of the sampling interval.
            var ahead = displayed - Samples.NewestTime + MeanInterval / 2;
            if (ahead > 0) Horizon += MeanShare * (Math.Min(Math.Max(ahead, MinHorizon), _maxHorizon) - Horizon);
        }

        (double Interval, double Speed) Increment(int age)
        {
            ref readonly var newer = ref Samples[age];
            ref readonly var older = ref Samples[age + 1];
            var interval = newer.Time - older.Time;
            return (interval, (newer.Position - older.Position) / interval);
        }

        static bool IsStart(double speed, double before) =>
            Math.Abs(before) < StartShare * Math.Abs(speed) || Math.Abs(speed) < StartShare * Math.Abs(before) || speed * before <= 0;
    }
}
