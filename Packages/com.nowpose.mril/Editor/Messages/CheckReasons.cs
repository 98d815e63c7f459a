namespace Nowpose.Editor.Messages
{
    /// <summary>Messages in the set-up window that state the purpose of each check.</summary>
    static class CheckReasons
    {
        public const string ApiLevel = "The package is built and tested with this setting, which also makes the app smaller.";
        public const string Architecture = "A HoloLens 2 has an ARM64 processor; an app for another processor cannot be installed.";

        public static string BuildTarget(string headset) => $"This is the player for {headset}; the settings below belong to this player.";

        public const string CameraBackground =
            "Black is transparent on a see-through display, and alpha 0 shows the video of a passthrough headset. A skybox or a colour covers the real "
            + "robot, and pictures that the headset takes need the alpha channel.";

        public const string FirstScene =
            "The app starts with the first scene of the build list that has a tick. In a project from a template, this is an empty SampleScene.";

        public const string FrameTiming =
            "Frame Timing Stats provide the GPU time per frame. Without them, the render time is measured less accurately, and a limit of "
            + "the constant-latency range that was found with one source is not valid for another.";

        public const string GraphicsApi =
            "The visualisation latency depends on the graphics API, so a calibration is valid for one API only. Unity 6 selects Direct3D 12 "
            + "automatically, which is slower on a HoloLens 2 according to Unity's measurements.";

        public const string GraphicsJobs =
            "Graphics Jobs affect the time at which a frame reaches the display, so a calibration of the visualisation latency is valid for one setting "
            + "only. Calibrate again after every change.";

        public const string InputHandling =
            "OpenXR provides the poses of head and hands through the Input System, and MRTK3 needs it. Without it, the camera "
            + "does not follow the head.";

        public const string InternetAccess =
            "Android refuses network connections of an app without the permission INTERNET. A development build always has the permission; in a "
            + "release build with Auto, Unity decides from the classes and services that the app uses.";

        public const string Mrtk3 = "The sample HoloLens 2 (MRTK3) uses it for the hand menu, voice commands and grabbing; the package works without it.";

        public const string MrtkGeneration =
            "MRTK 4 and XR Interaction Toolkit 3 moved the types that the hand menu, voice and grabbing use. With these versions, the "
            + "components are not compiled, and the sample HoloLens 2 (MRTK3) shows missing scripts.";

        public const string NearClip =
            "With Depth 16 Bit, the depth buffer has 16 bits. A closer near clip plane makes the depth steps larger, so that touching parts flicker: "
            + "at a distance of 1.5 m, a step is 0.34 mm with the plane at 0.1 m, and 1.7 mm with the plane at 0.02 m. MRTK3's rig sets the plane at "
            + "run time, from its Camera Settings Manager.";

        public const string OpenXrLoader = "Without OpenXR, the app is a flat window in front of the wearer.";
        public const string MixedRealityOpenXr = "It provides the features of a HoloLens that OpenXR itself lacks: anchors, markers and display times.";

        public const string ArFoundation =
            "Microsoft's plug-in needs AR Foundation for markers and anchors; without it, the robot's base can be placed by hand only.";

        public const string MixedRealityFeatures = "This feature provides markers, anchors and the predicted display time.";
        public const string HandTracking = "This feature provides the joints of the hands for MRTK3's hand menu and for grabbing.";
        public const string HandInteraction = "This feature provides the pinch and the pointing ray of each hand for MRTK3.";
        public const string EyeGaze = "Needed by MRTK3 to select a button by looking at it and pinching.";
        public const string DepthSubmission =
            "A HoloLens 2 and a Magic Leap 2 stabilise the image with the depth of the scene. A 24-bit depth buffer is slower and hardly improves "
            + "the image.";
        public const string LatencyOptimization =
            "Unity then waits for the display right before rendering, and L_visu does not depend on the processor time of your scripts. Calibrate "
            + "again after a change.";
        public const string InternetClient = "Needed to connect to a gateway on another network or by its public address.";
        public const string PrivateNetwork = "Needed to connect to a gateway on the same private network, which is the usual case.";
        public const string WebCam = "Needed to find the robot's base by a marker with the headset's camera.";
        public const string SpatialPerception = "Needed to keep the robot's base in its place in the room.";
        public const string VoiceCapability = "Needed for the voice commands.";
        public const string InputSystem = "OpenXR provides the poses of head and controllers through the Input System.";
        public const string OpenXr =
            "Unity's interface to the headset. Version 1.17 and newer support neither Universal Windows Platform nor Android with x86-64 "
            + "(Magic Leap 2).";
        public const string RenderMode = "The package's shaders support this mode, which draws both eyes in one pass.";
        public const string NativeWebSocket = "An alternative to the package's own WebSocket client.";

        public const string RenderPipeline =
            "The package's shaders support both. The visualisation latency depends on the pipeline: calibrate again after a change.";

        public const string RunInBackground = "Otherwise the session ends whenever the system's menu opens, and must synchronise its clock again.";

        public const string UwpBackend = "The UWP player supports no other backend.";
        public const string AndroidBackend = "IL2CPP is needed for 64-bit ARM and recommended for x86-64.";

        public const string UnityVersion = "Other versions may lack functions that the package or Microsoft's plug-in uses.";
    }
}
