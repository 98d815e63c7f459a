using System.Globalization;

namespace Nowpose.Prediction
{
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
