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
            return sighting.Pose * placed.Inverse;
        }
    }
}
