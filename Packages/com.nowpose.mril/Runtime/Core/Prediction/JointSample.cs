using System;

namespace Nowpose.Prediction
{
    /// <summary>One joint's position as the control system stamped it.</summary>
    public readonly struct JointSample
    {
        /// <param name="time">t_k in seconds of control time since an epoch near by.</param>
        /// <param name="position">Finite; rad for revolute joints, m for prismatic ones.</param>
        /// <exception cref="ArgumentException">A value is not finite.</exception>
        public JointSample(double time, double position) : this(time, position, time) { }

        /// <param name="time">Stamp t_k, which may be in error, in seconds of control time since an epoch near by.</param>
        /// <param name="position">Finite; rad for revolute joints, m for prismatic ones.</param>
        /// <param name="order">Seconds that decide which sample is the newer one where <paramref name="time"/> is in error.</param>
        /// <param name="velocity">Per second; NaN where it is not known.</param>
        /// <param name="acceleration">Per second squared; NaN where it is not known.</param>
        /// <exception cref="ArgumentException">Time, position or order is not finite.</exception>
        public JointSample(
            double time, double position, double order, double velocity = double.NaN, double acceleration = double.NaN)
        {
            if (!double.IsFinite(time) || !double.IsFinite(position) || !double.IsFinite(order))
                throw new ArgumentException(
                    "time, position and order must be finite, not " + time + " s, " + position + ", " + order + " s");
            Time = time;
            Position = position;
            Order = order;
            Velocity = double.IsFinite(velocity) ? velocity : double.NaN;
            Acceleration = double.IsFinite(acceleration) ? acceleration : double.NaN;
        }

        /// <summary>Stamp t_k, which may be in error, s.</summary>
        public double Time { get; }

        /// <summary>rad or m.</summary>
        public double Position { get; }

        /// <summary>Sort key of the samples, s: equal to <see cref="Time"/> unless the stamp is in error.</summary>
        public double Order { get; }

        /// <summary>rad/s or m/s as the control system tells it; NaN where it does not.</summary>
        public double Velocity { get; }

        /// <summary>rad/s² or m/s² as the control system tells it; NaN where it does not.</summary>
        public double Acceleration { get; }
    }
}
