using System;
using Nowpose.Kinematics;

namespace Nowpose.Frames
{
    /// <summary>Keeps the displayed pose of a frame continuous when its parent changes: the difference between the two poses fades out.</summary>
    /// <remarks>
    /// D is the former pose relative to the new one at the hand-over. At a later time t, the displayed pose is T(t) · D^w, where w falls from
    /// 1 to 0 within <see cref="Seconds"/> without a jump of the velocity. A difference as small as the corrections by each sample is ignored,
    /// so that a gripped object is in the gripper at once. A large difference that the object's speed does not explain is also ignored, because the
    /// object must have been moved elsewhere.
    /// <c>default</c> is a fade that has ended.
    /// </remarks>
    readonly struct PoseFade
    {
        /// <summary>
        /// Duration of the fade, in s. It is so short that a person does not notice a shift of a few millimetres while the gripper moves away.
        /// </summary>
        public const double Seconds = 0.15;

        /// <summary>Differences up to these values are ignored because they are small, in m and rad.</summary>
        const double MinShift = 0.002, MinTurn = 0.02;

        /// <summary>Minimum difference that is ignored because it is large, in m. For a fast object, the limit is larger.</summary>
        const double MaxShift = 0.25;

        /// <summary>
        /// Maximum time, in s, for which the object may be displayed with the former parent although it already has the new one: the default horizon
        /// cap.
        /// </summary>
        const double MaxLateness = 0.3;

        /// <summary>Limit of the difference for an object of any speed, in m.</summary>
        const double MaxShiftOfFastObject = 1;

        readonly double _start;
        readonly Vector3D _shift;
        readonly Vector3D _turn;
        readonly bool _isOpen;

        /// <param name="start">Time of the hand-over, s.</param>
        /// <param name="shown">Pose in the world at that time, according to the former parent.</param>
        /// <param name="now">Pose in the world at that time, according to the new parent.</param>
        /// <param name="speed">Speed of the displayed object before the hand-over, m/s.</param>
        public PoseFade(double start, in RigidTransform shown, in RigidTransform now, double speed = 0)
        {
            var difference = now.Inverse * shown;
            _start = start;
            _shift = new Vector3D(difference.X, difference.Y, difference.Z);
            _turn = UnitQuaternion.Of(difference).Log();
            _isOpen = (_shift.Length > MinShift || _turn.Length > MinTurn) && _shift.Length < Math.Max(MaxShift, Math.Min(speed * MaxLateness, MaxShiftOfFastObject));
        }

        // Returns whether the fade has ended at a given time; true if this time or the start is unknown.
        public bool IsOverAt(double time) => !_isOpen || !(time < _start + Seconds);

        /// <param name="now">Pose in the world at <paramref name="time"/>, according to the new parent.</param>
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
