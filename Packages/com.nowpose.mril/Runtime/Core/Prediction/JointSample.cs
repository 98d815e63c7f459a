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

        /// <param name="time">t_k as told, in seconds of control time since an epoch near by.</param>
        /// <param name="position">Finite; rad for revolute joints, m for prismatic ones.</param>
        /// <param name="order">Seconds that decide which sample is the newer one where <paramref name="time"/> is in error.</param>
        /// <exception cref="ArgumentException">A value is not finite.</exception>
        public JointSample(double time, double position, double order)
        {
            if (!double.IsFinite(time) || !double.IsFinite(position) || !double.IsFinite(order))
                throw new ArgumentException(
                    "time, position and order must be finite, not " + time + " s, " + position + ", " + order + " s");
            Time = time;
            Position = position;
            Order = order;
        }

        /// <summary>t_k as the predictor is told, s.</summary>
        public double Time { get; }

        /// <summary>rad or m.</summary>
        public double Position { get; }

        /// <summary>What sorts the samples, s: equal to <see cref="Time"/> unless the time told is in error.</summary>
        public double Order { get; }
    }
}
