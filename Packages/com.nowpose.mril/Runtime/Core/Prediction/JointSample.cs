using System;
using Nowpose.Messages;
using Nowpose.Prediction.Samples;

namespace Nowpose.Prediction
{
    /// <summary>One joint's position with the control system's stamp.</summary>
    public readonly struct JointSample : ISample<JointSample>
    {
        /// <summary>Minimum difference of two stamps, in s: closer stamps count as equal, because a speed between them has no meaning.</summary>
        internal const double SameSeconds = 1e-6;

        /// <summary>
        /// Maximum displacement, velocity, acceleration and scored error, in m or rad and per second: larger than any of a machine. The square of a larger value
        /// would remain in every running mean, and products of several could overflow.
        /// </summary>
        internal const double MaxMagnitude = 1e9;

        /// <param name="time">t_k in seconds of control time since a nearby epoch.</param>
        /// <param name="position">Finite; rad for revolute joints, m for prismatic ones.</param>
        /// <exception cref="ArgumentException">A value is not finite.</exception>
        public JointSample(double time, double position) : this(time, position, time) { }

        /// <param name="time">Stamp t_k, which may be wrong, in seconds of control time since a nearby epoch.</param>
        /// <param name="position">Finite; rad for revolute joints, m for prismatic ones.</param>
        /// <param name="order">Sort key in seconds, which determines the order of the samples if <paramref name="time"/> is wrong.</param>
        /// <param name="velocity">Velocity per second; NaN if it is unknown. A magnitude of 1e9 or more counts as unknown.</param>
        /// <param name="acceleration">Acceleration per second squared; otherwise like <paramref name="velocity"/>.</param>
        /// <exception cref="ArgumentException">Time, position or order is not finite.</exception>
        public JointSample(
            double time, double position, double order, double velocity = double.NaN, double acceleration = double.NaN)
        {
            if (!double.IsFinite(time) || !double.IsFinite(position) || !double.IsFinite(order))
                throw new ArgumentException(PredictionMessages.NotFinite(time, position, order));
            Time = time;
            Position = position;
            Order = order;
            Velocity = Math.Abs(velocity) < MaxMagnitude ? velocity : double.NaN;
            Acceleration = Math.Abs(acceleration) < MaxMagnitude ? acceleration : double.NaN;
        }

        /// <summary>Stamp t_k, which may be wrong, in s.</summary>
        public double Time { get; }

        /// <summary>Position, in rad or m.</summary>
        public double Position { get; }

        /// <summary>
        /// Sort key of the samples, in s: <see cref="Time"/>, or the true time of a sample whose stamp is wrong in a simulation, for example in <c>replay</c>.
        /// </summary>
        public double Order { get; }

        /// <summary>Velocity reported by the control system, in rad/s or m/s; NaN if it is not reported.</summary>
        public double Velocity { get; }

        /// <summary>Acceleration reported by the control system, in rad/s² or m/s²; NaN if it is not reported.</summary>
        public double Acceleration { get; }

        int ISample<JointSample>.Components => 1;

        double ISample<JointSample>.this[int component] => Position;

        JointSample ISample<JointSample>.With(double time, double order) => new JointSample(time, Position, order, Velocity, Acceleration);

        internal static bool IsSameTime(double one, double other) => Math.Abs(one - other) < SameSeconds;
    }

    /// <summary>A sample with its stamp: the position of a joint, or the pose of an object with several components.</summary>
    interface ISample<TSample>
    {
        /// <summary>Stamp t_k, which may be wrong; in a <see cref="SampleBuffer{TSample}"/> the corrected time. In s.</summary>
        double Time { get; }

        /// <summary>Sort key of the samples, s: equal to <see cref="Time"/> unless the stamp is wrong.</summary>
        double Order { get; }

        /// <summary>Number of components.</summary>
        int Components { get; }

        /// <summary>One component, in rad or m.</summary>
        double this[int component] { get; }

        /// <summary>Velocity reported by the source, per second; NaN if it is not reported.</summary>
        double Velocity { get; }

        /// <summary>Acceleration reported by the source, per second squared; NaN if it is not reported.</summary>
        double Acceleration { get; }

        /// <summary>Returns the same sample with a corrected stamp and sort key.</summary>
        TSample With(double time, double order);
    }
}
