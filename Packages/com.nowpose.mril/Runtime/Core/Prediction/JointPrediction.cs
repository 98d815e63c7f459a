using System.Globalization;

namespace Nowpose.Prediction
{
    /// <summary>Origin of a displayed position.</summary>
    public enum PredictionKind
    {
        /// <summary>No sample yet: the position is a placeholder (0) and must not be shown as a pose.</summary>
        None,

        /// <summary>A value that stands still: the newest sample's, or the section's at the horizon cap or at its oldest sample.</summary>
        Held,

        /// <summary>At or before the newest sample.</summary>
        Interpolated,

        /// <summary>Ahead of the newest sample.</summary>
        Predicted,

        /// <summary>Where the control system means the joint to be, as late as it follows: nothing is predicted.</summary>
        Planned
    }

    /// <summary>One joint's position at a time asked for, and how it was made.</summary>
    /// <remarks><c>default</c> is "no sample yet": position 0, <see cref="PredictionKind.None"/>. Always finite.</remarks>
    public readonly struct JointPrediction
    {
        public JointPrediction(double position, PredictionKind kind)
        {
            Position = position;
            Kind = kind;
        }

        /// <summary>In the unit of the samples: rad for revolute joints, m for prismatic ones.</summary>
        public double Position { get; }

        public PredictionKind Kind { get; }

        public override string ToString() => Kind + " " + Position.ToString("R", CultureInfo.InvariantCulture);
    }
}
