using System;
using Nowpose.Kinematics;

namespace Nowpose.Session.Hindcast
{
    /// <summary>True speeds of the joints and the tool between consecutive scored frames; 0 for the first frame after a pause.</summary>
    sealed class TrueSpeeds
    {
        /// <summary>Maximum interval between frames. The mean speed over a longer interval is not the current speed.</summary>
        static readonly TimeSpan MaxPause = new TimeSpan(TimeSpan.TicksPerSecond / 5);

        readonly double[] _positions;
        RigidTransform _tool;
        ControlTime? _at;
        double _perSecond;

        public TrueSpeeds(int jointCount) => _positions = new double[jointCount];

        /// <summary>Starts a frame. Then call <see cref="OfJoint"/> for each joint and <see cref="OfTool"/> once.</summary>
        public void Next(ControlTime at)
        {
            var passed = _at.HasValue ? at - _at.Value : TimeSpan.Zero;
            _perSecond = passed > TimeSpan.Zero && passed <= MaxPause ? 1 / ClockTicks.Seconds(passed) : 0;
            _at = at;
        }

        /// <summary>Returns the speed of a joint, rad/s or m/s.</summary>
        public double OfJoint(int joint, double position)
        {
            var speed = Math.Abs(position - _positions[joint]) * _perSecond;
            _positions[joint] = position;
            return speed;
        }

        /// <summary>Returns the speed of the tool, m/s.</summary>
        public double OfTool(in RigidTransform tool)
        {
            var (x, y, z) = (tool.X - _tool.X, tool.Y - _tool.Y, tool.Z - _tool.Z);
            _tool = tool;
            return Math.Sqrt(x * x + y * y + z * z) * _perSecond;
        }

        public void Reset() => _at = null;
    }
}
