using System;

namespace Nowpose.Prediction.Planning
{
    /// <summary>Estimates how a joint follows its plan: by which lag and which offset. Detects when it does not follow.</summary>
    /// <remarks>
    /// A Kalman filter of the two, since both show as one difference: the lag only while the joint moves. Position of the joint =
    /// plan(t − lag) + offset. It starts as not knowing the lag to 0.1 s, and the joint's first moves tell it.
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

        /// <summary>Standard deviations beyond which the joint does not follow.</summary>
        const double Gate = 5;

        /// <summary>Beyond, nothing is known and squares overflow.</summary>
        const double MaxVariance = 1e100, MaxRange = 1e40;

        double _varLag, _covariance, _varOffset;
        double _time;
        bool _isBegun;

        /// <summary>s; positive when the joint is late.</summary>
        public double Lag { get; private set; }

        /// <summary>rad or m.</summary>
        public double Offset { get; private set; }

        /// <summary>A plan begins: the lag of the plan before is likely its lag, too.</summary>
        public void Begin(double range)
        {
            var offset = UnknownOffset * Math.Min(range, MaxRange) + MinNoise;
            if (!_isBegun) _varLag = UnknownLag * UnknownLag;
            _varOffset = Math.Max(_varOffset, offset * offset);
            _isBegun = true;
        }

        /// <summary>Compares the plan with a sample, and learns from it when the joint follows.</summary>
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
            // NaN too: a plan of 1e200 must not stay in the filter.
            if (!(difference * difference <= Gate * Gate * variance) || !(variance < MaxVariance)) return PlanVerdict.NotFollowed;
            (lagGain, offsetGain) = (lagGain / variance, offsetGain / variance);
            Lag += lagGain * difference;
            Offset += offsetGain * difference;
            var (lagOld, both, offsetOld) = (_varLag, _covariance, _varOffset);
            _varLag = Math.Max((1 + lagGain * velocity) * lagOld - lagGain * both, 1e-12);
            _covariance = (1 + lagGain * velocity) * both - lagGain * offsetOld;
            _varOffset = Math.Max(offsetGain * velocity * both + (1 - offsetGain) * offsetOld, 1e-18);
            // A plan that hardly moves agrees with any joint at rest there.
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
        /// <summary>Further off than the plan's uncertainty explains.</summary>
        NotFollowed,

        /// <summary>At rest any plan agrees that ends there.</summary>
        Unclear,

        Followed
    }
}
