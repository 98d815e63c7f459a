using System;
using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Motion;

namespace Nowpose.Simulation.Work
{
    /// <summary>A conveyor around the robot that moves workpieces from the place where they are put down to the one where they are taken.</summary>
    /// <remarks>
    /// The belt moves once per cycle of the robot by one station, from rest to rest. On it, angle, radius and height around the robot's base
    /// change evenly with the way, and workpieces turn with the belt.
    /// </remarks>
    sealed class RingConveyor
    {
        /// <summary>Limits of the belt in m/s, m/s² and m/s³: a small indexing conveyor.</summary>
        const double Velocity = 0.15, Acceleration = 0.6, Jerk = 6;

        readonly RigidTransform _from;
        readonly Vector3D _turn;
        readonly double _startAngle, _angle, _startRadius, _radius, _startHeight, _height;
        readonly int _stations;
        readonly SevenPhaseProfile _step;

        /// <param name="from">Pose of a workpiece that was put down.</param>
        /// <param name="to">Pose of a workpiece that is taken.</param>
        /// <param name="stations">Number of steps from one to the other.</param>
        /// <param name="maxSeconds">Maximum duration of a step, s; the belt becomes faster if it is needed.</param>
        public RingConveyor(in RigidTransform from, in RigidTransform to, int stations, double maxSeconds)
        {
            _from = from;
            _stations = stations;
            _startAngle = Math.Atan2(from.Y, from.X);
            _angle = OtherWay(Math.Atan2(to.Y, to.X) - _startAngle);
            _startRadius = RadiusOf(from);
            _radius = RadiusOf(to) - _startRadius;
            _startHeight = from.Z;
            _height = to.Z - from.Z;
            _turn = (UnitQuaternion.Of(from).Inverse * UnitQuaternion.Exp(new Vector3D(0, 0, -_angle)) * UnitQuaternion.Of(to)).Log();
            _step = StepOf(Math.Abs(_angle) * (_startRadius + _radius / 2) / stations, maxSeconds);
        }

        /// <summary>Duration of a step, s.</summary>
        public double StepSeconds => _step.Duration;

        /// <summary>Returns the number of stations that the belt has moved since the start of a step, 0 to 1.</summary>
        public double StepAt(double seconds) => StepSeconds == 0 ? 1 : _step.PositionAt(seconds);

        /// <summary>Returns the pose of a workpiece in the robot's base frame.</summary>
        /// <param name="station">Way on the belt in stations, 0 where it was put down.</param>
        public RigidTransform At(double station)
        {
            var share = station / _stations;
            var (angle, radius) = (_startAngle + share * _angle, _startRadius + share * _radius);
            var rotation = UnitQuaternion.Exp(new Vector3D(0, 0, share * _angle)) * UnitQuaternion.Of(_from) * UnitQuaternion.Exp(_turn * share);
            return rotation.At(radius * Math.Cos(angle), radius * Math.Sin(angle), _startHeight + share * _height);
        }

        // The robot swings the shorter way, so the belt runs the longer one.
        static double OtherWay(double angle)
        {
            angle = Math.IEEERemainder(angle, 2 * Math.PI);
            return angle > 0 ? angle - 2 * Math.PI : angle + 2 * Math.PI;
        }

        static double RadiusOf(in RigidTransform pose) => Math.Sqrt(pose.X * pose.X + pose.Y * pose.Y);

        // The profile of the share of a step. If time is scaled by 1/f, velocity, acceleration and jerk are multiplied by f, f² and f³.
        static SevenPhaseProfile StepOf(double metres, double maxSeconds)
        {
            if (!(metres > 1e-6)) return default;
            var step = new SevenPhaseProfile(1, Velocity / metres, Acceleration / metres, Jerk / metres);
            var f = step.Duration / maxSeconds;
            return f <= 1 ? step : new SevenPhaseProfile(1, f * Velocity / metres, f * f * Acceleration / metres, f * f * f * Jerk / metres);
        }
    }
}
