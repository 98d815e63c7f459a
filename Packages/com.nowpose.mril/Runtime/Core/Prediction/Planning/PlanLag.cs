using System;

namespace Nowpose.Prediction.Planning
{
    /// <summary>How a joint follows its plan: so much later, and beside it by so much. Tells when it does not follow.</summary>
    /// <remarks>
    /// A Kalman filter of the two, since both show as one difference: the lag only while the joint moves. Position of the joint =
    /// plan(t − lag) + offset. It starts as not knowing the lag to 0.1 s, and the joint's first moves tell it.
    /// </remarks>
    sealed class PlanLag
    {
        /// <summary>Standard deviation of a lag nobody has seen yet, s.</summary>
        const double UnknownLag = 0.1;

        /// <summary>Of an offset nobody has seen yet: a share of the path's range.</summary>
        const double UnknownOffset = 0.02;

        /// <summary>What a plan that is followed leaves: a share of its range (the drive's own dynamics), and a sensor's noise.</summary>
        const double NoiseShare = 0.005, LeastNoise = 1e-4;

        /// <summary>How far the lag wanders in a second, s, and the offset, as a share of what it is unknown by.</summary>
        const double LagWander = 0.005, OffsetWander = 0.2;

        /// <summary>Standard deviations beyond which the joint does not follow.</summary>
        const double Gate = 5;

        const double GreatestVariance = 1e100;

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
            var offset = UnknownOffset * range + LeastNoise;
            if (!_isBegun) _varLag = UnknownLag * UnknownLag;
            _varOffset = Math.Max(_varOffset, offset * offset);
            _isBegun = true;
        }

        /// <summary>Compares the plan with a sample, and learns from it when the joint follows.</summary>
        /// <param name="time">Of the sample, s.</param>
        /// <param name="difference">Sample minus plan(t − <see cref="Lag"/>) − <see cref="Offset"/>.</param>
        /// <param name="velocity">Of the plan there.</param>
        /// <param name="range">Of the plan.</param>
        /// <returns>Whether the joint follows.</returns>
        public PlanVerdict Add(double time, double difference, double velocity, double range)
        {
            Wander(Math.Min(Math.Max(time - _time, 0), 1), range);
            _time = time;
            var noise = NoiseShare * range + LeastNoise;
            // The difference is −velocity · lag error + offset error.
            var lagGain = -velocity * _varLag + _covariance;
            var offsetGain = -velocity * _covariance + _varOffset;
            var variance = -velocity * lagGain + offsetGain + noise * noise;
            // Also what is no number: a plan of 1e200 must not stay in the filter.
            if (!(difference * difference <= Gate * Gate * variance) || !(variance < GreatestVariance)) return PlanVerdict.NotFollowed;
            (lagGain, offsetGain) = (lagGain / variance, offsetGain / variance);
            Lag += lagGain * difference;
            Offset += offsetGain * difference;
            var (lagOld, both, offsetOld) = (_varLag, _covariance, _varOffset);
            _varLag = Math.Max((1 + lagGain * velocity) * lagOld - lagGain * both, 1e-12);
            _covariance = (1 + lagGain * velocity) * both - lagGain * offsetOld;
            _varOffset = Math.Max(offsetGain * velocity * both + (1 - offsetGain) * offsetOld, 1e-18);
            // A plan that stands, or hardly moves, agrees with whatever stands there.
            return Math.Abs(velocity) * UnknownLag > Gate * noise ? PlanVerdict.Followed : PlanVerdict.Unclear;
        }

        public void Reset()
        {
            Lag = Offset = _varLag = _covariance = _varOffset = 0;
            _isBegun = false;
        }

        void Wander(double seconds, double range)
        {
            var offset = OffsetWander * (UnknownOffset * range + LeastNoise);
            _varLag += LagWander * LagWander * seconds;
            _varOffset += offset * offset * seconds;
        }
    }
}
