using Nowpose.Kinematics;

namespace Nowpose.Anchoring.Tracking
{
    /// <summary>Determines the pose of the base from markers that a person places by hand.</summary>
    sealed class HandPlacement
    {
        HeadsetTime? _last;

        /// <summary>Payload of a placed marker in this frame that is not one of the base's markers; null if there is none.</summary>
        public string RefusedPayload { get; private set; }

        public void BeginFrame() => RefusedPayload = null;

        /// <returns>The pose of the base in the room frame; null if the sighting is invalid, not new, or of an unknown marker.</returns>
        public RigidTransform? BaseOf(in MarkerSighting sighting, MarkerSet markers)
        {
            if (!sighting.Pose.IsPose() || (_last is HeadsetTime last && sighting.LastSeen <= last)) return null;
            if (!(markers.PoseInBase(sighting.Payload) is RigidTransform placed))
            {
                RefusedPayload = sighting.Payload;
                return null;
            }
            _last = sighting.LastSeen;
            var held = sighting.Pose * placed.Inverse;
            if (!sighting.KeepsUpright) return held;
            // Turns the base about the marker, so that the marker stays where the person has put it.
            var upright = UnitQuaternion.Of(held).AboutZ.At(0, 0, 0);
            var marker = upright * placed;
            return upright.MovedTo(sighting.Pose.X - marker.X, sighting.Pose.Y - marker.Y, sighting.Pose.Z - marker.Z);
        }
    }
}
