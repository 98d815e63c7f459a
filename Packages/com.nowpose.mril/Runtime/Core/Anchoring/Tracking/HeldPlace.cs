using Nowpose.Kinematics;

namespace Nowpose.Anchoring.Tracking
{
    /// <summary>The place of the base as the device holds it.</summary>
    /// <remarks>Looked for at the start, held from a lock on, and followed as the device corrects its map.</remarks>
    sealed class HeldPlace
    {
        /// <summary>Nearer than this to the application's origin, and this far from where it was, is no place but none.</summary>
        const double OriginMetres = 0.001, JumpMetres = 0.1;

        /// <summary>A correction of the map is smaller; what moves a place farther at once is another map, or another place.</summary>
        const double MostMetres = 0.3;

        ISpatialAnchor _anchor, _former;
        bool _isSought;

        public bool IsThere => _anchor != null;

        /// <summary>The device knows that it holds it, and not where it is; or tells it so far away that it is not followed.</summary>
        public bool IsLost => _anchor != null && (_anchor.State == SpatialAnchorState.Lost || ElsewhereMetres > 0);

        /// <summary>How far away the device says that it is, where that is not followed; else 0.</summary>
        public double ElsewhereMetres { get; private set; }

        /// <summary>The name it is kept under; null while it is not.</summary>
        public string KeptAs => _anchor?.KeptAs;

        /// <summary>Why it is not held or not kept; null when nothing is wrong.</summary>
        public string Problem => _anchor?.Problem;

        /// <summary>Looks once for what was kept in an earlier run.</summary>
        public void Seek(ISpatialAnchors anchors, string name)
        {
            if (_isSought || anchors == null || name.Length == 0 || !anchors.IsReady) return;
            _isSought = true;
            _anchor = anchors.Find(name);
        }

        /// <summary>Holds another place from now on, and keeps it instead of the one before.</summary>
        /// <param name="anchors">Null where the device holds none.</param>
        /// <param name="name">Empty not to keep it.</param>
        public void Hold(ISpatialAnchors anchors, in RigidTransform pose, string name)
        {
            _isSought = true;
            ElsewhereMetres = 0;
            _former?.Dispose();
            _former = _anchor;
            _anchor = anchors?.Hold(pose);
            if (_anchor == null) Leave(ref _former);
            else if (name.Length > 0) _anchor.Keep(name);
        }

        /// <summary>Lets go of it.</summary>
        /// <param name="seekAgain">Whether an earlier run's is to be looked for again: under another name.</param>
        public void Release(bool seekAgain)
        {
            ElsewhereMetres = 0;
            Leave(ref _former);
            Leave(ref _anchor);
            _isSought = !seekAgain;
        }

        /// <param name="last">Where it was last; null before it was anywhere.</param>
        /// <returns>Where it is; null while nobody knows.</returns>
        public RigidTransform? Follow(in RigidTransform? last)
        {
            ElsewhereMetres = 0;
            if (_anchor == null || _anchor.State != SpatialAnchorState.Tracking) return null;
            Leave(ref _former);
            if (!(_anchor.Pose is RigidTransform pose) || !pose.IsPose()) return null;
            var jump = last is RigidTransform before ? before.DistanceTo(pose) : 0;
            if (PoseNumbers.Length(pose.X, pose.Y, pose.Z) < OriginMetres && (!last.HasValue || jump > JumpMetres)) return null;
            if (jump <= MostMetres) return pose;
            ElsewhereMetres = jump;
            return null;
        }

        static void Leave(ref ISpatialAnchor anchor)
        {
            anchor?.Dispose();
            anchor = null;
        }
    }
}
