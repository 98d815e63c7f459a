using System;
using Nowpose.Kinematics;

namespace Nowpose.Anchoring.Tracking
{
    /// <summary>The position of the base that the device holds.</summary>
    /// <remarks>
    /// Searches for a stored position at startup, holds the position after a lock, and updates it when the device corrects its map.
    /// </remarks>
    sealed class HeldPlace
    {
        /// <summary>
        /// A pose closer to the application's origin than OriginMetres is invalid, unless it is closer to the previous pose than JumpMetres.
        /// </summary>
        const double OriginMetres = 0.001, JumpMetres = 0.1;

        /// <summary>Maximum correction of the map; a larger one indicates another map or another position.</summary>
        const double MaxJumpMetres = 0.3, MaxTurnRadians = 10 * Math.PI / 180;

        /// <summary>Time after a resume in which the device may find its place in the room again, and move the origin of its poses.</summary>
        static readonly TimeSpan RelocationTime = TimeSpan.FromSeconds(30);

        HeadsetTime? _resumed;
        ISpatialAnchor _anchor, _former;
        bool _isSought, _hasTracked;

        public bool IsThere => _anchor != null;

        /// <summary>
        /// Whether the pose of the position is unknown or too different to be followed, or the device no longer holds the position.
        /// </summary>
        public bool IsLost => _anchor != null && (_anchor.State == SpatialAnchorState.Lost || Elsewhere.HasValue || IsRemoved);

        /// <summary>Whether the device has held the position and no longer holds it.</summary>
        /// <remarks>
        /// The device's map may have changed, so the position is lost. A position that the device has never held was measured in the current map.
        /// </remarks>
        public bool IsRemoved => _hasTracked && _anchor.State == SpatialAnchorState.Failed;

        /// <summary>Whether the device has held the position since the lock, and still holds it.</summary>
        public bool IsConfirmed => _hasTracked && !IsRemoved;

        /// <summary>Whether the last followed pose was too far from the previous one for a correction of the map.</summary>
        public bool HasJumped { get; private set; }

        /// <summary>Difference of the reported pose, if it is too large to be followed; otherwise null.</summary>
        public MapCorrection? Elsewhere { get; private set; }

        /// <summary>Name under which the position is stored; null when it is not stored.</summary>
        public string KeptAs => _anchor?.KeptAs;

        /// <summary>Reason why the position is not held or not stored; null if nothing is wrong.</summary>
        public string Problem => _anchor?.Problem;

        /// <summary>Searches for the position stored in an earlier run, once, as soon as the device has loaded its anchors.</summary>
        public void Seek(ISpatialAnchors anchors, string name)
        {
            if (_isSought || anchors == null || name.Length == 0 || !anchors.IsReady) return;
            _isSought = true;
            _hasTracked = false;
            _anchor = anchors.Find(name);
        }

        /// <summary>Holds another position and stores it instead of the previous position.</summary>
        /// <param name="anchors">Anchors of the device; null if it has none.</param>
        /// <param name="name">Name under which the position is stored; empty if it must not be stored.</param>
        public void Hold(ISpatialAnchors anchors, in RigidTransform pose, string name)
        {
            _hasTracked = false;
            Elsewhere = null;
            _former?.Dispose();
            _former = _anchor;
            _anchor = anchors?.Hold(pose);
            if (_anchor == null) Leave(ref _former);
            else if (name.Length > 0) _anchor.Keep(name);
        }

        /// <summary>Releases the position.</summary>
        /// <param name="seekAgain">Whether <see cref="Seek"/> may search again for a position from an earlier run, for example under another
        /// name.</param>
        public void Release(bool seekAgain)
        {
            Elsewhere = null;
            Leave(ref _former);
            Leave(ref _anchor);
            _hasTracked = false;
            _isSought = !seekAgain;
        }

        /// <summary>Records that the app was suspended. For some time, a pose is followed however far it is from the previous one.</summary>
        public void Resume(HeadsetTime now) => _resumed = now;

        /// <param name="last">Previous pose; null before the first pose.</param>
        /// <returns>The current pose; null when it is unknown.</returns>
        public RigidTransform? Follow(in RigidTransform? last, HeadsetTime now)
        {
            Elsewhere = null;
            HasJumped = false;
            if (_anchor == null || _anchor.State != SpatialAnchorState.Tracking) return null;
            _hasTracked = true;
            Leave(ref _former);
            if (!(_anchor.Pose is RigidTransform pose) || !pose.IsPose()) return null;
            var jump = last is RigidTransform before ? new MapCorrection(before, pose) : default;
            if (PoseNumbers.Length(pose.X, pose.Y, pose.Z) < OriginMetres && (!last.HasValue || jump.Metres > JumpMetres)) return null;
            HasJumped = jump.Metres > MaxJumpMetres || jump.Radians > MaxTurnRadians;
            if (!HasJumped || (_resumed is HeadsetTime resumed && now - resumed <= RelocationTime)) return pose;
            Elsewhere = jump;
            return null;
        }

        static void Leave(ref ISpatialAnchor anchor)
        {
            anchor?.Dispose();
            anchor = null;
        }
    }
}
