using System;
using Nowpose.Kinematics;

namespace Nowpose.Anchoring.Tracking
{
    /// <summary>Decides which sightings are valid measurements of a marker's pose.</summary>
    static class SightingGate
    {
        /// <summary>Maximum relative error of the size; errors of lenses and prints are smaller.</summary>
        const double MaxSizeDeviation = 0.1;

        /// <summary>
        /// Minimum distance of a valid pose from the origin, which is the position of the head when the app starts. No marker is that close to the
        /// head.
        /// </summary>
        const double OriginMetres = 0.001;

        /// <summary>
        /// Maximum time by which a sighting may be in the future, because the clocks of the engine and of the headset are read one after the other.
        /// </summary>
        public static readonly TimeSpan Ahead = TimeSpan.FromMilliseconds(50);

        /// <param name="head">Viewer's head in the room frame, x forward; null when unknown.</param>
        public static SightingFault Judge(
            in MarkerSighting sighting, BaseMarker marker, HeadsetTime now, in RigidTransform? head, AnchoringSettings settings)
        {
            if (sighting.Tracking < MarkerTracking.Tracking) return SightingFault.NotTracked;
            var pose = sighting.Pose;
            if (!pose.IsPose()) return SightingFault.NoPose;
            // A marker placed by hand is exact by definition.
            if (sighting.Tracking == MarkerTracking.Placed) return SightingFault.None;
            if (PoseNumbers.Length(pose.X, pose.Y, pose.Z) < OriginMetres) return SightingFault.AtOrigin;
            var age = now - sighting.LastSeen;
            if (age > settings.Oldest || age < -Ahead) return SightingFault.Old;
            if (marker.SizeMetres > 0 && sighting.SizeMetres > 0
                && Math.Abs(sighting.SizeMetres - marker.SizeMetres) > MaxSizeDeviation * marker.SizeMetres) return SightingFault.OtherSize;
            return head is RigidTransform eyes ? CheckView(pose, eyes, settings) : SightingFault.None;
        }

        static SightingFault CheckView(in RigidTransform pose, in RigidTransform head, AnchoringSettings settings)
        {
            double x = head.X - pose.X, y = head.Y - pose.Y, z = head.Z - pose.Z;
            var distance = PoseNumbers.Length(x, y, z);
            if (distance > settings.MaxDistanceMetres) return SightingFault.TooFar;
            if (head.R00 * x + head.R10 * y + head.R20 * z > 0) return SightingFault.Behind;
            var straight = pose.R02 * x + pose.R12 * y + pose.R22 * z;
            return straight < Math.Cos(settings.MaxObliqueRadians) * distance ? SightingFault.TooOblique : SightingFault.None;
        }
    }
}
