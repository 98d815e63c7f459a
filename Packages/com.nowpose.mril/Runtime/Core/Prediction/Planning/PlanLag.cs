using System;

namespace Nowpose.Prediction.Planning
{
    /// <summary>Estimates the lag and the offset with which a joint follows its plan. Detects when it does not follow.</summary>
    /// <remarks>
    /// A Kalman filter of both, because they appear as one difference and the lag only while the joint moves. Position of the joint =
    /// plan(t − lag) + offset. The initial standard deviation of the lag is 0.1 s; the joint's first moves determine it.
    /// </remarks>
    sealed class PlanLag
    {
        /// <summary>Standard deviation of an unknown lag, s.</summary>
        const double UnknownLag = 0.1;

        /// <summary>Standard deviation of an unknown offset, as a share of the path's range.</summary>
        const double UnknownOffset = 0.02;

        /// <summary>Residual of a plan that is followed: a share of its range (the drive's own dynamics), and a sensor's noise.</summary>
        const double NoiseShare = 0.005, MinNoise = 1e-4;

        /// <summary>Drift per second of the lag, s, and of the offset, as a share of its unknown deviation.</summary>
        const double LagWander = 0.005, OffsetWander = 0.2;

        /// <summary>Maximum residual in standard deviations; beyond it, the joint does not follow.</summary>
        const double Gate = 5;

        /// <summary>Bounds above which squares overflow.</summary>
        const double MaxVariance = 1e100, MaxRange = 1e40;

        double _varLag, _covariance, _varOffset;
        double _time;
        bool _isBegun;

        /// <summary>Lag in s; positive if the joint is late.</summary>
        public double Lag { get; private set; }

        /// <summary>Offset in rad or m.</summary>
        public double Offset { get; private set; }

        /// <summary>Starts a plan; keeps the lag of the previous plan as the estimate.</summary>
        public void Begin(double range)
        {
            var offset = UnknownOffset * Math.Min(range, MaxRange) + MinNoise;
            if (!_isBegun) _varLag = UnknownLag * UnknownLag;
            _varOffset = Math.Max(_varOffset, offset * offset);
            _isBegun = true;
        }

        /// <summary>Compares the plan with a sample, and updates the estimates if the joint follows.</summary>
        /// <param name="time">Time of the sample, s.</param>
        /// <param name="difference">Sample minus plan(t − <see cref="Lag"/>) − <see cref="Offset"/>.</param>
        /// <param name="velocity">Velocity of the plan at that time.</param>
        /// <param name="range">Range of the plan's positions.</param>
        /// <returns>Whether the joint follows.</returns>
        public PlanVerdict Add(double time, double difference, double velocity, double range)
        {
            Wander(Math.Min(Math.Max(time - _time, 0), 1), range);
            _time = time;
            var noise = NoiseShare * range + MinNoise;
            // The difference is −velocity · lag error + offset error.
            var lagGain = -velocity * _varLag + _covariance;
            var offsetGain = -velocity * _covariance + _varOffset;
            var variance = -velocity * lagGain + offsetGain + noise * noise;
            // Also rejects NaN: values such as 1e200 must not enter the filter.
            if (!(difference * difference <= Gate * Gate * variance) || !(variance < MaxVariance)) return PlanVerdict.NotFollowed;
            (lagGain, offsetGain) = (lagGain / variance, offsetGain / variance);
            Lag += lagGain * difference;
            Offset += offsetGain * difference;
            var (lagOld, both, offsetOld) = (_varLag, _covariance, _varOffset);
            _varLag = Math.Max((1 + lagGain * velocity) * lagOld - lagGain * both, 1e-12);
            _covariance = (1 + lagGain * velocity) * both - lagGain * offsetOld;
            _varOffset = Math.Max(offsetGain * velocity * both + (1 - offsetGain) * offsetOld, 1e-18);
            // A plan that hardly moves agrees with any joint at rest at its position.
            return Math.Abs(velocity) * UnknownLag > Gate * noise ? PlanVerdict.Followed : PlanVerdict.Unclear;
        }

        public void Reset()
        {
            Lag = Offset = _varLag = _covariance = _varOffset = 0;
            _isBegun = false;
        }

        void Wander(double seconds, double range)
        {
            var offset = OffsetWander * (UnknownOffset * range + MinNoise);
            _varLag += LagWander * LagWander * seconds;
            _varOffset += offset * offset * seconds;
        }
    }

    /// <summary>Verdict of one sample on whether a joint follows its plan.</summary>
    enum PlanVerdict
    {
        /// <summary>The difference exceeds the plan's uncertainty.</summary>
        NotFollowed,

        /// <summary>The plan hardly moves, so the sample is not conclusive.</summary>
        Unclear,

        Followed
    }
}
