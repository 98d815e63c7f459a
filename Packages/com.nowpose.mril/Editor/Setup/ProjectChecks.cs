using System.Collections.Generic;
using UnityEditor;

namespace Nowpose.Editor.Setup
{
    /// <summary>Lists all checks for a platform, in the order in which the user should make the changes.</summary>
    static class ProjectChecks
    {
        static readonly string[] RenderModes = { "Multi-pass", "Single Pass Instanced" };
        static readonly string[] DepthModes = { "None", "Depth 16 Bit", "Depth 24 Bit" };

        public static IReadOnlyList<ProjectCheck> For(HeadsetPlatform platform) =>
            platform == HeadsetPlatform.HoloLens2 ? ForHoloLens() : ForAndroid();

        public static IReadOnlyList<ProjectCheck> ForHoloLens() => new ProjectCheck[]
        {
            new UnityVersionCheck(),
            new BuildTargetCheck(HeadsetPlatform.HoloLens2),
            new ScriptingBackendCheck(HeadsetPlatform.HoloLens2),
            new ArchitectureCheck(),
            new ApiLevelCheck(),
            new GraphicsApiCheck(),
            new GraphicsJobsCheck(),
            new RenderPipelineCheck(),
            new InputHandlingCheck(),
            OpenXr,
            new PackageCheck(
                "Mixed Reality OpenXR", "Features of a HoloLens beyond OpenXR: anchors, markers and display times.",
                ProjectNeeds.MixedRealityOpenXr),
            new PackageCheck(
                "AR Foundation", "Microsoft's plug-in needs it for markers and anchors; without it the robot's base can be placed by hand only.",
                ProjectNeeds.ArFoundation, CheckState.Advice),
            new OpenXrLoaderCheck(HeadsetPlatform.HoloLens2),
            new OpenXrFeatureCheck(
                "Mixed Reality Features", "It provides markers, anchors and the predicted display time.", "com.microsoft.openxr.feature.hololens"),
            new OpenXrFeatureCheck(
                "Hand Tracking", "It provides the joints of the hands for MRTK3's hand menu and for grabbing.", "com.microsoft.openxr.feature.handtracking",
                CheckState.Advice),
            new OpenXrFeatureCheck(
                "Microsoft Hand Interaction Profile", "It provides pinch and ray of a hand for MRTK3.", "com.unity.openxr.feature.input.handtracking",
                CheckState.Advice),
            new OpenXrFeatureCheck(
                "Eye Gaze Interaction Profile", "Needed by MRTK3 to select a button by looking at it and pinching.", "com.unity.openxr.feature.input.eyetracking",
                CheckState.Advice),
            RenderMode,
            new OpenXrOptionCheck(
                "Depth Submission Mode", "The headset stabilises the picture with the depth of the scene; 24 bits cost more than they improve.",
                "m_depthSubmissionMode", DepthModes, 1),
            new CapabilityCheck(
                PlayerSettings.WSACapability.InternetClient, "Needed to connect to a gateway in another network or by its public address."),
            new CapabilityCheck(
                PlayerSettings.WSACapability.PrivateNetworkClientServer, "Needed to connect to a gateway in the same private network, which is the usual case."),
            new CapabilityCheck(PlayerSettings.WSACapability.WebCam, "Needed to find the robot's base by a marker with the headset's camera."),
            new CapabilityCheck(PlayerSettings.WSACapability.SpatialPerception, "Needed to keep the robot's base at its place in the room."),
            new CapabilityCheck(PlayerSettings.WSACapability.GazeInput, "Needed by MRTK3 to select a button by looking at it and pinching.", CheckState.Advice),
            new CapabilityCheck(PlayerSettings.WSACapability.Microphone, "Needed for the voice commands.", CheckState.Advice),
            FrameTiming,
            RunInBackground,
            new CameraBackgroundCheck(),
            new NearClipCheck(),
            new MrtkGenerationCheck(),
            new Mrtk3Check(),
            NativeWebSocket,
        };

        public static IReadOnlyList<ProjectCheck> ForAndroid() => new ProjectCheck[]
        {
            new UnityVersionCheck(),
            new BuildTargetCheck(HeadsetPlatform.AndroidHeadset),
            new ScriptingBackendCheck(HeadsetPlatform.AndroidHeadset),
            new ApiLevelCheck(),
            new RenderPipelineCheck(),
            new InputHandlingCheck(),
            OpenXr,
            new PackageCheck(
                "Input System", "OpenXR provides the poses of head and controllers through it.", ProjectNeeds.InputSystem),
            new OpenXrLoaderCheck(HeadsetPlatform.AndroidHeadset),
            RenderMode,
            new InternetAccessCheck(),
            FrameTiming,
            RunInBackground,
            NativeWebSocket,
        };

        static ProjectCheck OpenXr => new PackageCheck(
            "OpenXR", "Unity's interface to the headset.", ProjectNeeds.OpenXr);

        static ProjectCheck RenderMode => new OpenXrOptionCheck(
            "Render Mode", "The package's shaders support it, and it draws both eyes in one pass.", "m_renderMode", RenderModes, 1);

        static ProjectCheck FrameTiming => new FrameTimingCheck();

        static ProjectCheck RunInBackground => new RunInBackgroundCheck();

        static ProjectCheck NativeWebSocket => new PackageCheck(
            "NativeWebSocket (optional)", "An alternative to the package's own WebSocket client.", ProjectNeeds.NativeWebSocket,
            CheckState.Advice);
    }
}
