using Nowpose.Anchoring;

namespace Nowpose.Editor.Messages
{
    /// <summary>Texts that inspectors show as labels and values.</summary>
    static class InspectorTexts
    {
        public const string StrokeShare = "Share of the stroke";
        public const string BasePosition = "Base in the room, m";
        public const string BaseRotation = "Base rotation to the left";
        public const string ObjectPosition = "Position in 'world', m";
        public const string ObjectRotation = "Rotation to the left";
        public const string PoseFrom = "Pose from";
        public const string MovedByLock = "Moved by the newest lock";
        public const string MovedByDevice = "Moved by the device since then";
        public const string HeldByDevice = "Held by the device";
        public const string LockSpread = "Spread";
        public const string Sightings = "  Sightings";
        public const string OffBy = "  Off by";
        public const string NotHeld = "no";
        public const string MarkerSeen = "seen";
        public const string MarkerNotSeen = "not seen yet";
        public const string MarkerContradicted = "not used: the other markers contradict it";
        public const string MarkerMoved = "not at its expected position";
        public const string MarkerInLock = "part of the lock";
        public const string NoHead = "nothing: Head is empty, and no camera is tagged MainCamera";
        public const string Disabled = "nothing; the component is disabled";
        public const string ReadClipboard = "Read the code on the clipboard";
        public const string AddGhost = "Add a ghost";
        public const string GhostGap = "Gap to the displayed tool";
        public const string AxisSpeed = "Speed along the axis";
        public const string NoProfile = "none; the settings apply";
        public const string FindProfile = "Look for a profile";
        public const string OneObject = "Live values are shown for one object at a time.";
        public const string ComponentDisabled = "this component is disabled";
        public const string AttachedTo = "Attached to";
        public const string DrawnAhead = "Drawn ahead";
        public const string MovedByHand = "Moved by hand";
        public const string LegibleUpTo = "Legible up to";
        public const string BesideView = "Beside the view";
        public const string DegreesLeft = "° to the left";
        public const string DegreesRight = "° to the right";
        public const string FromHead = "From the head";
        public const string ShiftedBy = "Shifted by";
        public const string EndToEnd = "End to end";
        public const string MovingJoints = "Moving joints";
        public const string NotRecording = "not recording";
        public const string ShownTime = "Displayed control time";
        public const string ConnectionRequested = "Connection requested";
        public const string NudgeOfVisu = "Nudge of L_visu";
        public const string RestartSession = "Restart session";
        public const string LoadUrdf = "Load a URDF file …";
        public const string LoadUrdfTitle = "Load a URDF file (expand xacro files first)";

        public static string UrdfUnreadable(string asset, string path, string reason) =>
            $"[Nowpose] '{asset}': {path} cannot be read: {reason}; check the path and the file's permissions";

        /// <param name="name">Name under which the device has stored the anchor; null if it has not stored it.</param>
        public static string Held(string name) => name == null ? "yes" : $"yes, kept as {name}";

        public static string Following(string head, bool isGliding) => head + (isGliding ? ", gliding" : ", staying put");

        public static string Marks(int forward, int backward) => $"{forward} forward, {backward} backward";

        public static string Striped(string fade) => $"striped, fade {fade}";

        public static string Use(string remedy) => $"Use '{remedy}'";

        /// <param name="value">Value at the top of a chart.</param>
        public static string AtTop(string value) => $"({value} at the top)";

        public static string Ignored(string faults) => $"ignored: {faults}";

        public static string Of(SightingFault fault)
        {
            switch (fault)
            {
                case SightingFault.NotTracked: return "not tracked";
                case SightingFault.NoPose: return "without a pose";
                case SightingFault.AtOrigin: return "at the origin";
                case SightingFault.Old: return "too old";
                case SightingFault.TooFar: return "too far";
                case SightingFault.TooOblique: return "too oblique";
                case SightingFault.Behind: return "behind the head";
                case SightingFault.OtherSize: return "of another size";
                default: return "in two places";
            }
        }

        public const string AddAppearance = "Add Pose Appearance";

        public static string ShowRobot(string robot) => $"Show '{robot}' in the cell";

        /// <param name="rigs">Names of the rigs that do not have the links of the robot.</param>
        /// <param name="removed">Paths of the objects that the button removes; empty if there are none.</param>
        public static string NoLinks(string rigs, string robot, string removed) =>
            $"The links of '{robot}' are not below: {rigs}. The button adds them." + (removed.Length == 0 ? "" :
            $" It also removes these objects with everything below them except the grippers, and unpacks the instance of the cell's prefab if it "
            + $"contains them: {removed}. If one of them does not belong to another robot, move it first.");
        public const string Capacity = "capacity must be 2 or more";
        public const string Seconds = "seconds must be more than 0";
        public const string Predicted = "predicted by the runtime";
        public const string FingerWithoutJoint = "A finger without a joint";

        public static string NoFingerJoint(string robot) => $"robot '{robot}' has no such joint; the finger does not move";
        public static string NoFinger(string position) => $"{position}, but no finger is assigned";
        public static string MovedByRig(string position) => $"{position}, moved by the rig itself";
    }
}
