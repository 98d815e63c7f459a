using System;
using Nowpose.Kinematics;

namespace Nowpose.Session
{
    /// <summary>Velocity of the displayed tool centre point, from its positions at the display times of successive frames.</summary>
    /// <remarks>It is that of the middle between two frames: half a frame late. Allocates nothing; not thread-safe.</remarks>
    sealed class ToolVelocity
    {
        /// <summary>Below this a frame is the same one, computed once more; a difference would be noise.</summary>
        static readonly TimeSpan Shortest = TimeSpan.FromMilliseconds(5);

        /// <summary>After a longer pause the difference is not the velocity of now.</summary>
        static readonly TimeSpan Longest = TimeSpan.FromMilliseconds(100);

        ControlTime? _time;
        (double X, double Y, double Z) _position;

        /// <summary>In the robot's base frame, m/s; null where the pose is not current, and until two frames in a row were.</summary>
        public (double X, double Y, double Z)? Value { get; private set; }

        /// <summary>Takes a frame as it was computed.</summary>
        public void Follow(DisplayFrame frame) => Follow(frame.State == PoseState.Current ? frame.DisplayTime : null, frame.ToolPose);

        /// <param name="displayTime">Null where the pose is not current.</param>
        /// <param name="tool">In the robot's base frame, m.</param>
        public void Follow(ControlTime? displayTime, in RigidTransform tool)
        {
            var passed = displayTime - _time;
            if (passed >= TimeSpan.Zero && passed < Shortest) return;
            var seconds = passed > TimeSpan.Zero && passed <= Longest ? ClockTicks.Seconds(passed.Value) : double.NaN;
            Value = double.IsNaN(seconds)
                ? ((double, double, double)?)null
                : ((tool.X - _position.X) / seconds, (tool.Y - _position.Y) / seconds, (tool.Z - _position.Z) / seconds);
            _time = displayTime;
            _position = (tool.X, tool.Y, tool.Z);
        }

        /// <summary>Forgets all: another robot or session.</summary>
        public void Reset()
        {
            _time = null;
            Value = null;
        }
    }
}
