using System;
using Nowpose.Kinematics;

namespace Nowpose.Anchoring.Tracking
{
    /// <summary>Tells sightings that say where a marker is from those that only seem to.</summary>
    static class SightingGate
    {
        /// <summary>A lens or a print errs by less.</summary>
        const double MostOfSize = 0.1;

        /// <summary>No marker is so near to where the head was when the application began.</summary>
        const double OriginMetres = 0.001;

        /// <summary>Clocks of the engine and of the headset are read one after the other.</summary>
        public static readonly TimeSpan Ahead = TimeSpan.FromMilliseconds(50);

        /// <param name="head">Of the viewer in the room frame, x forward; null where it is not known.</param>
        public static SightingFault Judge(
            in MarkerSighting sighting, BaseMarker marker, HeadsetTime now, in RigidTransform? head, AnchoringSettings settings)
        {
            if (sighting.Tracking < MarkerTracking.Tracking) return SightingFault.NotTracked;
            var pose = sighting.Pose;
            if (!pose.IsPose()) return SightingFault.NoPose;
            // What a hand has placed is where it was meant to be.
            if (sighting.Tracking == MarkerTracking.Placed) return SightingFault.None;
            if (PoseNumbers.Length(pose.X, pose.Y, pose.Z) < OriginMetres) return SightingFault.AtOrigin;
            var age = now - sighting.LastSeen;
            if (age > settings.Oldest || age < -Ahead) return SightingFault.Old;
            if (marker.SizeMetres > 0 && sighting.SizeMetres > 0
                && Math.Abs(sighting.SizeMetres - marker.SizeMetres) > MostOfSize * marker.SizeMetres) return SightingFault.OtherSize;
            return head is RigidTransform eyes ? JudgeView(pose, eyes, settings) : SightingFault.None;
        }

        static SightingFault JudgeView(in RigidTransform pose, in RigidTransform head, AnchoringSettings settings)
        {
            double x = head.X - pose.X, y = head.Y - pose.Y, z = head.Z - pose.Z;
            var distance = PoseNumbers.Length(x, y, z);
            if (distance > settings.FarthestMetres) return SightingFault.TooFar;
            if (head.R00 * x + head.R10 * y + head.R20 * z > 0) return SightingFault.Behind;
            var straight = pose.R02 * x + pose.R12 * y + pose.R22 * z;
            return straight < Math.Cos(settings.MostObliqueRadians) * distance ? SightingFault.TooOblique : SightingFault.None;
        }
    }
}
