using System;

namespace Nowpose.Unity.Messages
{
    /// <summary>Messages in Unity's console about changes of a session.</summary>
    static class SessionMessages
    {
        public static string DescriptionUnusable(string reason) => $"the gateway's robot description cannot be used: {reason}";

        public static string DescriptionDiffers(string robot, string asset) =>
            $"the gateway describes robot '{robot}' with a URDF that differs from asset '{asset}'; the displayed robot may differ from the real one; load the gateway's URDF into the asset";

        public static string Description(string robot) => $"the gateway describes robot '{robot}'";
        public static string Recording(string path) => $"recording the session to {path}";

        public const string FirstPositions = "the first joint positions have arrived";
        public const string Synchronised = "clock synchronised";
        public const string SynchronisationLost = "clock synchronisation lost; poses are not current; check the network and the gateway";
        public const string WithinRange = "render time within the constant-latency range";
        public const string NoRefreshesMissed = "frames no longer miss refreshes of the display";
        public const string BeyondRange =
            "render time beyond the constant-latency range; poses are late by an unknown time; reduce the load of the scene";

        public const string RefreshesMissed =
            "frames miss refreshes of the display; poses are late by an unknown time; reduce the load of scene and scripts, and end recording or "
            + "streaming";

        public const string LatenciesDiffer =
            "display times of the runtime and the calibrated L_visu differ by more than 5 ms; calibrate again";

        /// <param name="predictedMs">Time from the start of a frame to its display time, as the runtime predicts it.</param>
        /// <param name="setMs">L_visu of the settings.</param>
        public static string LatencyNotVerified(double predictedMs, double setMs) =>
            FormattableString.Invariant($"the runtime predicts an L_visu of {predictedMs:0.#} ms, and the settings contain {setMs:0.#} ms; ")
            + "the runtime's value is used; calibrate L_visu to verify it";

        public const string PlausibleAgain = "display times of the runtime are plausible again and are used";

        /// <param name="joints">Description of the joints without data; empty if these joints are unknown.</param>
        public static string Stale(string joints) =>
            joints.Length == 0 ? "joint positions are stale; the pose is held" : $"joint positions are stale; the pose is held: {joints}";
    }
}
