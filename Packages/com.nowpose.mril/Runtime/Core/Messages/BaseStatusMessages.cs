namespace Nowpose.Messages
{
    /// <summary>Messages about the state of a base and of its markers. Each is one line with an instruction to the user.</summary>
    static class BaseStatusMessages
    {
        public const string Placed = "placed by hand";
        public const string BeingPlaced = "being placed by hand";

        /// <param name="marker">Name of the marker, such as marker 'a'.</param>
        public static string NotOfThisBase(string marker) => $"hand placed {marker} is not a marker of this base; correct its Payload";

        /// <param name="markers">Number of markers of the lock; 0 if the base was placed by hand.</param>
        public static string Locked(int markers)
        {
            if (markers == 0) return Placed;
            return markers == 1 ? "locked by 1 marker" : $"locked by {markers} markers";
        }

        public static string MovedBy(string mm, string degrees) => $", moved by {mm} mm, {degrees}°";

        public static string NudgedBy(string mm, string degrees) =>
            $", nudged by {mm} mm, {degrees}°: correct the offsets of the markers, because a new lock omits the nudge";

        public static string Conflict(string first, string second, string difference) =>
            $"{first} and {second} disagree by {difference}: measure their poses again";

        public static string Scatters(string marker, string spread) => $"the poses of {marker} scatter by {spread}: move closer and keep still";
        public static string Alternates(string marker) => $"the poses of {marker} alternate between two: look at it from another angle";
        public static string Gathers(int inView, int count) => $"{inView} of {count} markers in view: keep looking at them";
        public static string Moving(string marker) => $"{marker} is moving: keep it and the robot still";

        public const string Lost = "the headset has lost the position of the base: look around";

        /// <param name="problem">Reason why the device no longer holds the position; null if it gives none.</param>
        public static string Removed(string problem) => problem ?? "the device no longer holds the position of the base; lock or place the base again";

        public static string TooFar(string maxMetres) => $"is too far away: move to within {maxMetres} m of it";

        public const string TooOblique = "is seen too obliquely: stand in front of it";
        public const string Behind = "is behind you: look at it";
        public const string OtherSize = "does not have the configured size: correct the size of the marker, or print it at this size";
        public const string TwoPlaces = "is in two places: cover one of the two";
        public const string NotInView = "is no longer in view: look at it";
        public const string NotPlaced = "has no position from the headset yet: look at it";

        public static string ConflictOfLock(string marker, int mm, string degrees) =>
            $"; {marker} is {mm} mm, {degrees}° from where the other markers place it";

        public static string Corrected(int mm, string degrees) => $"; the headset has moved it by {mm} mm, {degrees}°";

        /// <param name="isBlind">Whether no code of any kind has been reported for a long time.</param>
        /// <param name="problem">Problem of the source of markers; null if there is none.</param>
        public static string Looking(bool isBlind, string problem) =>
            isBlind ? "looking for markers; go closer, and allow access to the camera if it is blocked" : "looking for markers" + Because(problem);

        /// <param name="marker">The marker with the largest difference.</param>
        public static string Moved(int markers, string marker, string difference) => markers > 1
            ? $"{markers} markers have moved; the worst, {marker}, is {difference} from its expected position: put them back, or lock again"
            : $"{marker} is {difference} from its expected position: put it back, or lock again";

        public static string Restored(bool hasMarkers, string problem) =>
            "not confirmed since the app started or was paused: "
            + (hasMarkers ? "look at a marker to confirm it" : "compare it with the robot; lock it if it matches, or place it again")
            + Because(problem);

        /// <param name="hasMarkers">Whether markers are part of the lock.</param>
        public static string Unconfirmed(int mm, string degrees, bool hasMarkers, string problem) =>
            $"the headset has moved the base by {mm} mm, {degrees}°: "
            + (hasMarkers ? "look at a marker to confirm it, or lock again" : "compare it with the robot, and lock it to confirm it") + Because(problem);

        public static string Elsewhere(string metres, string degrees, bool hasMarkers) => hasMarkers
            ? $"the headset now reports the base {metres} m, {degrees}° from its last pose; the new pose is ignored: look around, or lock again"
            : $"the headset now reports the base {metres} m, {degrees}° from its last pose; the new pose is ignored: look around, or place it again";

        /// <summary>Returns the suffix that adds a problem to a line: "; " and the problem. Empty if the problem is null.</summary>
        public static string Because(string problem) => problem == null ? "" : "; " + problem;
    }
}
