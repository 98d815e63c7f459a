using Nowpose.Kinematics;
using Nowpose.Prediction;

namespace Nowpose.Frames
{
    /// <summary>One pose of a tracked frame as six coordinates: the position, m, and the angles of <see cref="RotationHistory"/>, rad.</summary>
    readonly struct BodySample : ISample<BodySample>
    {
        /// <summary>Number of components: three of the position, followed by three angles.</summary>
        public const int Coordinates = 6;

        public BodySample(double time, in Vector3D position, in Vector3D angles, double order)
        {
            Time = time;
            Position = position;
            Angles = angles;
            Order = order;
        }

        public double Time { get; }

        public double Order { get; }

        public Vector3D Position { get; }

        public Vector3D Angles { get; }

        public int Components => Coordinates;

        double ISample<BodySample>.Velocity => double.NaN;

        double ISample<BodySample>.Acceleration => double.NaN;

        public double this[int component] => component < 3 ? Position[component] : Angles[component - 3];

        public BodySample With(double time, double order) => new BodySample(time, Position, Angles, order);
    }
}
