using System;
using Nowpose.Kinematics;

namespace Nowpose.Frames
{
    /// <summary>Keeps the displayed pose of a frame continuous when its parent changes: the difference of the two poses fades out.</summary>
    /// <remarks>
    /// With D the pose shown at the hand-over, relative to the new one, the displayed pose after the time t is T(t) · D^w, where w falls
    /// from 1 to 0 within <see cref="Seconds"/> without a jump of the velocity. A difference as small as the corrections by each sample is not
    /// kept, so that a gripped object is in the gripper at once; nor is one so large that the object must have been moved elsewhere.
    /// <c>default</c> is a hand-over that has ended.
    /// </remarks>
    readonly struct HandOver
    {
        /// <summary>Length of the blend, s: a gripper has moved on by then, and a person does not notice a shift of some millimetres.</summary>
        public const double Seconds = 0.15;

        /// <summary>Differences up to these are not kept, m and rad.</summary>
        const double MinShift = 0.002, MinTurn = 0.02;

        /// <summary>Differences from this one on are not kept, m.</summary>
        const double MaxShift = 0.25;

        readonly double _start;
        readonly Vector3D _shift;
        readonly Vector3D _turn;
        readonly bool _isOpen;

        /// <param name="start">Time of the hand-over, s.</param>
        /// <param name="shown">Pose that the former parent gives at that time.</param>
        /// <param name="now">Pose that the new parent gives at that time.</param>
        public HandOver(double start, in RigidTransform shown, in RigidTransform now)
        {
            var difference = now.Inverse * shown;
            _start = start;
            _shift = new Vector3D(difference.X, difference.Y, difference.Z);
            _turn = UnitQuaternion.Of(difference).Log();
            _isOpen = (_shift.Length > MinShift || _turn.Length > MinTurn) && _shift.Length < MaxShift;
        }

        // Also true if one of the times is unknown.
        public bool IsOverAt(double time) => !_isOpen || !(time < _start + Seconds);

        /// <param name="now">Pose that the new parent gives at the time.</param>
        public RigidTransform At(double time, in RigidTransform now)
        {
            if (IsOverAt(time)) return now;
            var passed = Math.Max(0, (time - _start) / Seconds);
            var weight = 1 - passed * passed * (3 - 2 * passed);
            var shift = _shift * weight;
            return now * UnitQuaternion.Exp(_turn * weight).At(shift.X, shift.Y, shift.Z);
        }
    }
}
