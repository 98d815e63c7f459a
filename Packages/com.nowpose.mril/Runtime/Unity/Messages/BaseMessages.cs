using System;
using UnityEngine;

namespace Nowpose.Unity.Messages
{
    /// <summary>Error messages about the robot's base, and names of its states.</summary>
    static class BaseMessages
    {
        public static string PositionNotFinite(Vector3 position) => $"position {position} is not finite; pass three finite lengths in m";
        public static string RotationInvalid(Quaternion rotation) => $"rotation {rotation} is not a rotation; pass a quaternion of length 1";

        public static string AngleNotFinite(double degrees) =>
            FormattableString.Invariant($"the angle {degrees}° is not finite; pass a finite angle in degrees");

        /// <param name="scale">Scale of the base anchor in the scene.</param>
        public static string Scaled(Vector3 scale) => FormattableString.Invariant(
            $"its scale in the scene is ({scale.x:0.###}, {scale.y:0.###}, {scale.z:0.###}), so the robot has another size than the real robot, at ")
            + "which the markers place it; set the scale of the object and of its parents to 1";

        public const string Disabled = "the Base Anchor or its object is disabled, so nothing checks the base; enable both";
        public const string Destroyed = "its Base Anchor was destroyed; add another one, and disable and enable this object";

        public const string NoMarkerSource =
            "no marker source is switched on; add QR Markers or Tracked Images on or below the session, or switch them on";

        public const string BeingPlacedLabel = "being placed";
        public const string FollowsMarker = "the base follows a marker that is being moved";
        public const string NotLocated = "no marker has located the base";
        public const string Restored = "the pose of the base is not confirmed; see the instruction of the Base Anchor";
        public const string NotLockedLabel = "base not locked";
        public const string NotConfirmedLabel = "base not confirmed";
        public const string MovedLabel = "base or marker moved";
        public const string Moved = "a marker is not at its expected position";
        public const string LostLabel = "base lost";
        public const string Lost = "the headset has lost the position of the base";
    }
}
