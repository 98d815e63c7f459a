using System.Collections.Generic;
using UnityEditor;

namespace Nowpose.Editor.Setup
{
    /// <summary>All checks, in the recommended order of the changes.</summary>
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
                "Mixed Reality OpenXR", "What a HoloLens has beyond OpenXR: anchors, markers, the time at which a frame is displayed.",
                ProjectNeeds.MixedRealityOpenXr),
            new PackageCheck(
                "AR Foundation", "Markers and anchors of Microsoft's plug-in are made of it; without it the robot's base is placed by hand only.",
                ProjectNeeds.ArFoundation, CheckState.Advice),
            new OpenXrLoaderCheck(HeadsetPlatform.HoloLens2),
            new OpenXrFeatureCheck(
                "Mixed Reality Features", "Markers, anchors and the predicted display time come by it.", "com.microsoft.openxr.feature.hololens"),
            new OpenXrFeatureCheck(
                "Hand Tracking", "The joints of the hands, for MRTK3's hand menu and for grabbing.", "com.microsoft.openxr.feature.handtracking",
                CheckState.Advice),
            new OpenXrFeatureCheck(
                "Microsoft Hand Interaction Profile", "Pinch and ray of a hand, for MRTK3.", "com.unity.openxr.feature.input.handtracking",
                CheckState.Advice),
            new OpenXrFeatureCheck(
                "Eye Gaze Interaction Profile", "To look at a button and pinch, for MRTK3.", "com.unity.openxr.feature.input.eyetracking",
                CheckState.Advice),
            RenderMode,
            new OpenXrOptionCheck(
                "Depth Submission Mode", "The headset steadies the picture by the depth of what it shows; 24 bits cost more than they give.",
                "m_depthSubmissionMode", DepthModes, 1),
            new CapabilityCheck(
                PlayerSettings.WSACapability.InternetClient, "To connect to a gateway in another network, and to any by its public address."),
            new CapabilityCheck(
                PlayerSettings.WSACapability.PrivateNetworkClientServer, "To connect to a gateway in the same private network, the usual case."),
            new CapabilityCheck(PlayerSettings.WSACapability.WebCam, "To find the robot's base by a marker, which the headset's camera sees."),
            new CapabilityCheck(PlayerSettings.WSACapability.SpatialPerception, "To keep the robot's base where it is in the room."),
            new CapabilityCheck(PlayerSettings.WSACapability.GazeInput, "To look at a button and pinch, for MRTK3.", CheckState.Advice),
            new CapabilityCheck(PlayerSettings.WSACapability.Microphone, "To call the hand menu's commands by voice.", CheckState.Advice),
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
                "Input System", "OpenXR gives the poses of head and controllers through it.", ProjectNeeds.InputSystem),
            new OpenXrLoaderCheck(HeadsetPlatform.AndroidHeadset),
            RenderMode,
            new InternetAccessCheck(),
            FrameTiming,
            RunInBackground,
            NativeWebSocket,
        };

        static ProjectCheck OpenXr => new PackageCheck(
            "OpenXR", "Unity's way to the headset.", ProjectNeeds.OpenXr);

        static ProjectCheck RenderMode => new OpenXrOptionCheck(
            "Render Mode", "The package's shaders are written for it, and it draws both eyes in one go.", "m_renderMode", RenderModes, 1);

        static ProjectCheck FrameTiming => new FrameTimingCheck();

        static ProjectCheck RunInBackground => new RunInBackgroundCheck();

        static ProjectCheck NativeWebSocket => new PackageCheck(
            "NativeWebSocket (optional)", "Another WebSocket client; the package has one of its own.", ProjectNeeds.NativeWebSocket,
            CheckState.Advice);
    }
}
