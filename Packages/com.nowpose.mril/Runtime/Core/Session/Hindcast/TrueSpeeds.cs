using System;
using Nowpose.Kinematics;

namespace Nowpose.Session.Hindcast
{
    /// <summary>How fast the joints and the tool truly moved from one judged frame to the next; 0 for the first after a pause.</summary>
    sealed class TrueSpeeds
    {
        /// <summary>Frames further apart tell of a way, not of a speed.</summary>
        static readonly TimeSpan LongestPause = new TimeSpan(TimeSpan.TicksPerSecond / 5);

        readonly double[] _positions;
        RigidTransform _tool;
        ControlTime? _at;
        double _perSecond;

        public TrueSpeeds(int jointCount) => _positions = new double[jointCount];

        /// <summary>Goes on to a frame, of which each joint and the tool are told next.</summary>
        public void Next(ControlTime at)
        {
            var passed = _at.HasValue ? at - _at.Value : TimeSpan.Zero;
            _perSecond = passed > TimeSpan.Zero && passed <= LongestPause ? 1 / ClockTicks.Seconds(passed) : 0;
            _at = at;
        }

        /// <summary>rad/s or m/s.</summary>
        public double OfJoint(int joint, double position)
        {
            var speed = Math.Abs(position - _positions[joint]) * _perSecond;
            _positions[joint] = position;
            return speed;
        }

        /// <summary>m/s.</summary>
        public double OfTool(in RigidTransform tool)
        {
            var (x, y, z) = (tool.X - _tool.X, tool.Y - _tool.Y, tool.Z - _tool.Z);
            _tool = tool;
            return Math.Sqrt(x * x + y * y + z * z) * _perSecond;
        }

        public void Reset() => _at = null;
    }
}
