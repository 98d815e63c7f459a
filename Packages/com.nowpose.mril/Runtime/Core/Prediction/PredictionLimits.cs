using System;
using Nowpose.Messages;

namespace Nowpose.Prediction
{
    /// <summary>Bounds of a joint's prediction: maximum horizon, maximum gap between samples, and the joint's own limits.</summary>
    /// <remarks>Immutable; one instance may be used for several joints.</remarks>
    public sealed class PredictionLimits
    {
        /// <param name="lower">Minimum position, rad or m.</param>
        /// <param name="upper">Maximum position, rad or m.</param>
        /// <param name="horizonCap">Maximum horizon in s, 0 or more; infinity without a maximum.</param>
        /// <param name="maximumGap">Maximum gap between samples in s, positive; infinity without a maximum.</param>
        /// <param name="velocity">Maximum speed, per second, positive; infinity if it is unknown.</param>
        /// <param name="acceleration">Maximum acceleration, per second squared, positive; infinity if it is unknown.</param>
        /// <param name="jerk">Maximum jerk, per second cubed, positive; infinity if it is unknown.</param>
        /// <param name="isEndless">See <see cref="IsEndless"/>.</param>
        /// <exception cref="ArgumentException">A value is outside its range, lower is above upper, or a continuous joint has a limit.</exception>
        public PredictionLimits(double lower = double.NegativeInfinity, double upper = double.PositiveInfinity,
            double horizonCap = 0.3, double maximumGap = 0.5, double velocity = double.PositiveInfinity,
            double acceleration = double.PositiveInfinity, double jerk = double.PositiveInfinity,
            bool isEndless = false)
        {
            if (!(lower <= upper) || double.IsPositiveInfinity(lower) || double.IsNegativeInfinity(upper))
                throw new ArgumentException(PredictionMessages.LimitOrder(lower, upper));
            // The unwrapped positions of a continuous joint have no limit.
            if (isEndless && (double.IsFinite(lower) || double.IsFinite(upper)))
                throw new ArgumentException(PredictionMessages.LimitsOfContinuousJoint(lower, upper), nameof(isEndless));
            if (!(horizonCap >= 0))
                throw new ArgumentOutOfRangeException(nameof(horizonCap), horizonCap, PredictionMessages.NegativeSeconds);
            if (!(maximumGap > 0))
                throw new ArgumentOutOfRangeException(nameof(maximumGap), maximumGap, PredictionMessages.NotPositiveSeconds);

            RequirePositive(velocity, nameof(velocity), "per second");
            RequirePositive(acceleration, nameof(acceleration), "per second squared");
            RequirePositive(jerk, nameof(jerk), "per second cubed");

            Lower = lower;
            Upper = upper;
            HorizonCap = horizonCap;
            MaximumGap = maximumGap;
            Velocity = velocity;
            Acceleration = acceleration;
            Jerk = jerk;
            IsEndless = isEndless;
        }

        /// <summary>No joint limits, horizon cap or maximum gap. Studies and replays use this value to evaluate predictors without limits.</summary>
        public static PredictionLimits Unlimited { get; } =
            new PredictionLimits(horizonCap: double.PositiveInfinity, maximumGap: double.PositiveInfinity);

        /// <summary>Minimum displayed position, rad or m.</summary>
        public double Lower { get; }

        /// <summary>Maximum displayed position, rad or m.</summary>
        public double Upper { get; }

        /// <summary>
        /// Maximum time from the newest sample to a prediction, s. Beyond the cap, the section's value at the cap is held; before the section's
        /// oldest sample, its value at that sample is held. The forecasts of <c>adaptive</c> end after 0.5 s. Default 0.3 s,
        /// because errors grow with the horizon: at 250 ms latency and T_s 50 ms, a quadratic has 0.62 times and a cubic 0.94 times the error of
        /// hold.
        /// </summary>
        public double HorizonCap { get; }

        /// <summary>
        /// Maximum interval between consecutive samples of one motion, s. Samples before a longer interval are not used, because a polynomial fitted
        /// across a pause in the transmission overshoots. The default is longer than the horizon cap, after which the joint is held.
        /// </summary>
        public double MaximumGap { get; }

        /// <summary>Maximum speed, rad/s or m/s; bounds the mixture of <c>adaptive</c>.</summary>
        public double Velocity { get; }

        /// <summary>Maximum acceleration, rad/s² or m/s²; bounds the change of speed of the <c>adaptive</c> mixture.</summary>
        public double Acceleration { get; }

        /// <summary>Maximum jerk, rad/s³ or m/s³. S-curve profiles require it together with the maximum speed and acceleration.</summary>
        public double Jerk { get; }

        /// <summary>
        /// Whether the joint is continuous: its positions are angles in rad, which may wrap from π to −π. A continuous joint has no position limits.
        /// </summary>
        public bool IsEndless { get; }

        internal double Clamp(double position) => position < Lower ? Lower : position > Upper ? Upper : position;

        static void RequirePositive(double value, string name, string unit)
        {
            if (!(value > 0)) throw new ArgumentOutOfRangeException(name, value, PredictionMessages.NotPositive(unit));
        }
    }
}
