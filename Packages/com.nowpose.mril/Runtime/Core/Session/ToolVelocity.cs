using System;
using Nowpose.Kinematics;

namespace Nowpose.Session
{
    /// <summary>Velocity of the displayed tool centre point, from its positions at the display times of successive frames.</summary>
    /// <remarks>The velocity applies to the midpoint between the two newest frames. Allocates nothing; not thread-safe.</remarks>
    sealed class ToolVelocity
    {
        /// <summary>Maximum interval. The mean velocity over a longer interval is not the current velocity.</summary>
        static readonly TimeSpan MaxInterval = TimeSpan.FromMilliseconds(100);

        ControlTime? _time;
        (double X, double Y, double Z) _position;

        /// <summary>Velocity in the robot's base frame, m/s; null if the pose of this or of the previous frame was not current.</summary>
        public (double X, double Y, double Z)? Value { get; private set; }

        /// <summary>Adds a computed frame. Ignores a computation that is not displayed, because the frame is computed again.</summary>
        public void Follow(DisplayFrame frame)
        {
            if (frame.IsLast) Follow(frame.State == PoseState.Current ? frame.DisplayTime : null, frame.ToolPose);
        }

        /// <param name="displayTime">Display time; null if the pose is not current.</param>
        /// <param name="tool">Tool pose in the robot's base frame, m.</param>
        public void Follow(ControlTime? displayTime, in RigidTransform tool)
        {
            var passed = displayTime - _time;
            // The rig has applied the same frame again.
            if (passed == TimeSpan.Zero) return;
            var seconds = passed > TimeSpan.Zero && passed <= MaxInterval ? ClockTicks.Seconds(passed.Value) : double.NaN;
            Value = double.IsNaN(seconds)
                ? ((double, double, double)?)null
                : ((tool.X - _position.X) / seconds, (tool.Y - _position.Y) / seconds, (tool.Z - _position.Z) / seconds);
            _time = displayTime;
            _position = (tool.X, tool.Y, tool.Z);
        }

        /// <summary>Resets the state. Call it when the robot or the session changes.</summary>
        public void Reset()
        {
            _time = null;
            Value = null;
        }
    }
}
