using System;
using Nowpose.Kinematics;
using Nowpose.Motion;

namespace Nowpose.Simulation.Work
{
    /// <summary>Conveyor belt that moves workpieces from the place where a robot puts them down to the place where a robot picks them up.</summary>
    /// <remarks>
    /// The belt moves by one station per step, from rest to rest. On a ring around the world's origin, angle, radius and height change
    /// linearly along the belt, and workpieces rotate with the belt. On a straight belt, position and rotation change linearly.
    /// </remarks>
    sealed class Belt
    {
        /// <summary>Limits of the belt's velocity (m/s), acceleration (m/s²) and jerk (m/s³), as for a small indexing conveyor.</summary>
        const double Velocity = 0.15, Acceleration = 0.6, Jerk = 6;

        readonly RigidTransform _from;
        readonly Vector3D _turn, _way;
        readonly double _startAngle, _angle, _startRadius, _radius;
        readonly bool _isRing;
        readonly int _stations;
        readonly SevenPhaseProfile _step;

        /// <param name="from">Pose at which a workpiece is put down.</param>
        /// <param name="to">Pose at which a workpiece is picked up.</param>
        /// <param name="stations">Number of steps from one pose to the other.</param>
        /// <param name="maxSeconds">Maximum duration of a step, s; the belt becomes faster if necessary.</param>
        /// <param name="isRing">
        /// Whether the belt runs around the world's origin. It takes the longer way round, because the robot swings along the shorter way.
        /// </param>
        public Belt(in RigidTransform from, in RigidTransform to, int stations, double maxSeconds, bool isRing)
        {
            _isRing = isRing;
            _from = from;
            _stations = stations;
            _way = new Vector3D(to.X - from.X, to.Y - from.Y, to.Z - from.Z);
            _startAngle = Math.Atan2(from.Y, from.X);
            _angle = isRing ? LongerWay(Math.Atan2(to.Y, to.X) - _startAngle) : 0;
            _startRadius = RadiusOf(from);
            _radius = RadiusOf(to) - _startRadius;
            _turn = (UnitQuaternion.Of(from).Inverse * UnitQuaternion.Exp(new Vector3D(0, 0, -_angle)) * UnitQuaternion.Of(to)).Log();
            var metres = (isRing ? Math.Abs(_angle) * (_startRadius + _radius / 2) : _way.Length) / stations;
            _step = StepOf(metres, maxSeconds);
            // On a belt that is shorter than its workpieces, they overlap, because they would otherwise never arrive.
            QueueDistance = Math.Min(1, CellWork.Size / metres);
        }

        /// <summary>Duration of a step, s.</summary>
        public double StepSeconds => _step.Duration;

        /// <summary>Distance between two workpieces that touch each other, in stations.</summary>
        public double QueueDistance { get; }

        /// <summary>Returns the number of stations that the belt has moved since the start of a step, 0 to 1.</summary>
        public double StepAt(double seconds) => seconds > 0 && StepSeconds == 0 ? 1 : _step.PositionAt(seconds);

        /// <summary>Returns the pose of a workpiece in the world.</summary>
        /// <param name="station">Position on the belt in stations; 0 where workpieces are put down.</param>
        public RigidTransform At(double station)
        {
            var share = station / _stations;
            var rotation = UnitQuaternion.Exp(new Vector3D(0, 0, share * _angle)) * UnitQuaternion.Of(_from) * UnitQuaternion.Exp(_turn * share);
            var (x, y) = (_from.X + share * _way.X, _from.Y + share * _way.Y);
            if (_isRing)
            {
                var (angle, radius) = (_startAngle + share * _angle, _startRadius + share * _radius);
                (x, y) = (radius * Math.Cos(angle), radius * Math.Sin(angle));
            }
            return rotation.At(x, y, _from.Z + share * _way.Z);
        }

        static double LongerWay(double angle)
        {
            angle = Math.IEEERemainder(angle, 2 * Math.PI);
            return angle > 0 ? angle - 2 * Math.PI : angle + 2 * Math.PI;
        }

        static double RadiusOf(in RigidTransform pose) => Math.Sqrt(pose.X * pose.X + pose.Y * pose.Y);

        // Returns the profile for a distance of 1, one step. If time is scaled by 1/f, velocity, acceleration and jerk are multiplied by f, f², f³.
        static SevenPhaseProfile StepOf(double metres, double maxSeconds)
        {
            if (!(metres > 1e-6)) return default;
            var step = new SevenPhaseProfile(1, Velocity / metres, Acceleration / metres, Jerk / metres);
            var f = step.Duration / maxSeconds;
            return f <= 1 ? step : new SevenPhaseProfile(1, f * Velocity / metres, f * f * Acceleration / metres, f * f * f * Jerk / metres);
        }
    }
}
