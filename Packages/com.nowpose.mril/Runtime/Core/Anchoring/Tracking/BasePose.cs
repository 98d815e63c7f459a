using System;
using Nowpose.Kinematics;

namespace Nowpose.Anchoring.Tracking
{
    /// <summary>
    /// The pose of a base in the room frame, the lock from which it comes, and the displayed pose, which follows the pose without jumps.
    /// </summary>
    sealed class BasePose
    {
        /// <summary>Correction of the map above which the base is uncertain until a marker or a person confirms it.</summary>
        const double MaxUnconfirmedMetres = 0.02, MaxUnconfirmedRadians = 1 * Math.PI / 180;

        readonly EasedPose _shown;
        RigidTransform? _confirmed;

        /// <param name="ease">Duration over which a change is blended in.</param>
        public BasePose(TimeSpan ease) => _shown = new EasedPose(ease);

        /// <summary>The pose; null if it is unknown.</summary>
        public RigidTransform? Newest { get; private set; }

        /// <summary>Pose from which the next lock is blended in, until the pose is known; null if no such pose is known.</summary>
        public RigidTransform? From { get; private set; }

        public RigidTransform? Shown => Newest.HasValue ? _shown.Pose : null;

        /// <summary>The newest lock; null if the pose does not come from a lock.</summary>
        public LockReport Lock { get; private set; }

        /// <summary>Distance and angle by which the device has moved the base since the lock.</summary>
        public MapCorrection Correction { get; private set; }

        /// <summary>Correction of the map since a marker or a person confirmed the lock, if it is large; otherwise null.</summary>
        public MapCorrection? Unconfirmed =>
            _confirmed is RigidTransform before && new MapCorrection(before, Newest.Value) is var correction
            && correction.IsBeyond(MaxUnconfirmedMetres, MaxUnconfirmedRadians)
                ? correction
                : (MapCorrection?)null;

        /// <summary>Applies a lock.</summary>
        public void Take(LockReport report) => (Newest, From, Lock, Correction, _confirmed) = (report.Base, null, report, default, report.Base);

        /// <summary>Records that the pose is correct.</summary>
        public void Confirm() => _confirmed = Newest;

        /// <summary>Applies the pose that the device reports for the lock.</summary>
        public void Correct(in RigidTransform pose)
        {
            if (Lock != null) Correction = new MapCorrection(Lock.Base, pose);
            Newest = pose;
        }

        /// <summary>Applies a pose that comes from no lock.</summary>
        public void Replace(in RigidTransform pose) => (Newest, Lock, Correction, _confirmed) = (pose, null, default, null);

        /// <summary>Applies a pose during a motion, without a transition.</summary>
        public void Jump(in RigidTransform pose)
        {
            Newest = pose;
            _shown.Jump(pose);
        }

        /// <summary>Removes pose and lock.</summary>
        /// <param name="from">Value of <see cref="From"/>; null: the next pose applies at once.</param>
        public void Clear(in RigidTransform? from)
        {
            (Newest, From, Lock, Correction, _confirmed) = (null, from, null, default, null);
            _shown.Jump(from);
        }

        /// <summary>Processes one frame.</summary>
        public void Follow(HeadsetTime now)
        {
            if (Newest is RigidTransform pose) _shown.Follow(pose, now);
            else _shown.Rest(now);
        }
    }
}
