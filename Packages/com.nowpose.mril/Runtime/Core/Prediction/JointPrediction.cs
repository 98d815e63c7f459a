using System.Globalization;

namespace Nowpose.Prediction
{
    /// <summary>Origin of a displayed position.</summary>
    public enum PredictionKind
    {
        /// <summary>No sample yet: the position is a placeholder (0) and must not be shown as a pose.</summary>
        None,

        /// <summary>
        /// A constant value: the position of the newest sample, or the value of the predicted curve at the end of its range. The range extends from
        /// the oldest sample that the curve uses to the horizon cap.
        /// </summary>
        Held,

        /// <summary>The time is not later than the newest sample.</summary>
        Interpolated,

        /// <summary>The time is later than the newest sample.</summary>
        Predicted,

        /// <summary>
        /// The position in the control system's plan, delayed by the time by which the joint lags behind the plan. It is not predicted.
        /// </summary>
        Planned
    }

    /// <summary>One joint's position at a requested time, and its origin.</summary>
    /// <remarks><c>default</c> is "no sample yet": position 0, <see cref="PredictionKind.None"/>. Always finite.</remarks>
    public readonly struct JointPrediction
    {
        public JointPrediction(double position, PredictionKind kind)
        {
            Position = position;
            Kind = kind;
        }

        /// <summary>Position in the unit of the samples: rad for revolute joints, m for prismatic ones.</summary>
        public double Position { get; }

        public PredictionKind Kind { get; }

        public override string ToString() => Kind + " " + Position.ToString("R", CultureInfo.InvariantCulture);
    }
}
