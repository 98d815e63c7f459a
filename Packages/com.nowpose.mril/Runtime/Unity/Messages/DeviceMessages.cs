using System;

namespace Nowpose.Unity.Messages
{
    /// <summary>Messages about problems of devices with anchors, markers, display times and depth. Most messages state a remedy.</summary>
    static class DeviceMessages
    {
        public const string NoStoreComponent =
            "anchors are lost at the next start, because the object with the component Spatial Anchors has no component Anchor Store; add it";

        public const string AnchorsOff = "the component Spatial Anchors is switched off, so the device does not correct the position; switch it on";

        public const string StoreOff = "anchors are lost at the next start, because the component Anchor Store is switched off; switch it on";

        public const string NotStoredYet = "the device has not stored the anchor yet";

        /// <param name="problem">Problem that the store reported; null if it reported none.</param>
        public static string NotStored(string anchor, string problem) => problem == null
            ? $"the device could not store the anchor as '{anchor}'; it is lost at the next start, so place the base again then"
            : $"the device could not store the anchor as '{anchor}': {problem}; it is lost at the next start, so place the base again then";

        public const string AnchorWithoutName = "an anchor without a name cannot be stored; enter a name for the cell";

        public static string AnchorNameTooLong(int length, int max) =>
            $"the name of an anchor has {length} bytes (UTF-8); the maximum is {max}; shorten the name of the cell";

        public const string AnchorOfEarlierSession = "the headset's runtime was restarted, and the anchor is not valid any more; lock or place the base again";
        public const string AnchorRemoved = "the device has removed the anchor; lock or place the base again";
        public const string NoAnchors = "the device has no anchors; lock or place the base again";
        public const string AnchorNotCreated = "the device cannot create an anchor here; look around, so that it maps the room, and lock or place the base again";
        public static string AnchorRefused(string reason) => $"the device cannot create an anchor: {reason}; lock or place the base again";
        public const string AnchorNeeds = "anchors need a device that supports them";
        public const string ImageNeeds = "tracked images need a library with the images, and a device that tracks images";

        public const string QrCodeNeeds =
            "QR codes need a HoloLens 2, the WebCam capability, the user's permission to use the camera, and OpenXR "
            + "for Windows Mixed Reality 113.2403 or newer";

        public const string LoadAnchors = "load the stored anchors";

        public const string NoAnchorStore =
            "the device's XR runtime has no anchor store, so anchors are lost at the next start; place the base again after each start";

        public const string NoOrigin = "the main camera has no XR Origin above it; add one, or assign it";

        public static string NoManager(string manager, string need) => $"the XR Origin has no {manager}; add one to it; {need}";

        public static string ManagerOff(string manager) => $"the {manager} on the XR Origin is switched off; switch it on";

        public static string NotOffered(string manager, string need) => $"the device's XR runtime is not running, or does not support the {manager}: {need}";

        public static string NotRunning(string manager) =>
            $"the subsystem of the {manager} has stopped, so positions are no longer updated; restart the app if this message stays";

        public const string NoArSession = "the scene has no AR Session; add one (XR > AR Session)";

        public static string MarkerMode(string component, string mode, string used) =>
            $"QR markers '{component}': the marker manager's mode was {mode}, which shifts codes along the room's axes; it was changed to {used}";

        public const string PlanarPaused = "planar reprojection is paused because the rig receives no poses; enable the rig and its session";
        public const string PlanarWithoutRig = "has no rig on its object or a child; assign one";
        public static string PlanarRefused(string reason) => $"is refused: {reason}; build again with all files of the OpenXR plugin";
        public static string PlanarLog(string component, string why) => $"planar reprojection '{component}' (experiment) {why}";
        public static string PlanarProblem(string why) => $"planar reprojection {why}";
        public const string PlanarNotSupported = "is refused: the runtime does not support PlanarManual; its own mode stays in use; remove this component";

        public static string CountersPaired(string component, long hertz, long stopwatchHertz, double microseconds) => FormattableString.Invariant(
            $"display time '{component}': performance counter {hertz} Hz, stopwatch {stopwatchHertz} Hz, paired within {microseconds:0.0} µs");

        public const string OtherClock =
            "the session's clock does not read the performance counter; remove the script that sets HeadsetClock, "
            + "or implement IPerformanceCounterClock in the class of that clock";

        public static string NotRewritten(string component) =>
            $"display time '{component}': Rewrite Before Render is off, so the runtime predicts from the previous frame, and the pose of a late "
            + "frame is one refresh behind; switch it on in the Session Settings";

        public static string NoDisplayTime(string component, string reason) => $"display time '{component}': {reason}; the calibrated L_visu is used";

        public static string DepthUnknown(string component, string reason) =>
            $"reprojection check '{component}': {reason}; it is unknown whether depth is submitted; "
            + "build again with all files of the OpenXR plugins";

        public static string StoreFailed(string action, string reason) => $"cannot {action}: {reason}";

        public const string DepthSubmitted = "depth is submitted";
        public const string DepthAgain = "depth is submitted again";
    }
}
