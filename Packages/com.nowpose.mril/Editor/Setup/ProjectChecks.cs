using System.Collections.Generic;
using Nowpose.Editor.Messages;
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
                "Mixed Reality OpenXR", CheckReasons.MixedRealityOpenXr,
                ProjectNeeds.MixedRealityOpenXr),
            new PackageCheck(
                "AR Foundation", CheckReasons.ArFoundation,
                ProjectNeeds.ArFoundation, CheckState.Advice),
            new OpenXrLoaderCheck(HeadsetPlatform.HoloLens2),
            new OpenXrFeatureCheck(
                "Mixed Reality Features", CheckReasons.MixedRealityFeatures, "com.microsoft.openxr.feature.hololens"),
            new OpenXrFeatureCheck(
                "Hand Tracking", CheckReasons.HandTracking, "com.microsoft.openxr.feature.handtracking",
                CheckState.Advice),
            new OpenXrFeatureCheck(CheckTitles.HandInteraction, CheckReasons.HandInteraction, "com.unity.openxr.feature.input.handtracking",
                CheckState.Advice),
            new OpenXrFeatureCheck(CheckTitles.EyeGaze, CheckReasons.EyeGaze, "com.unity.openxr.feature.input.eyetracking",
                CheckState.Advice),
            RenderMode,
            new OpenXrOptionCheck(
                "Depth Submission Mode", CheckReasons.DepthSubmission,
                "m_depthSubmissionMode", DepthModes, 1),
            new CapabilityCheck(
                PlayerSettings.WSACapability.InternetClient, CheckReasons.InternetClient),
            new CapabilityCheck(
                PlayerSettings.WSACapability.PrivateNetworkClientServer, CheckReasons.PrivateNetwork),
            new CapabilityCheck(PlayerSettings.WSACapability.WebCam, CheckReasons.WebCam),
            new CapabilityCheck(PlayerSettings.WSACapability.SpatialPerception, CheckReasons.SpatialPerception),
            new CapabilityCheck(PlayerSettings.WSACapability.GazeInput, CheckReasons.EyeGaze, CheckState.Advice),
            new CapabilityCheck(PlayerSettings.WSACapability.Microphone, CheckReasons.VoiceCapability, CheckState.Advice),
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
                "Input System", CheckReasons.InputSystem, ProjectNeeds.InputSystem),
            new OpenXrLoaderCheck(HeadsetPlatform.AndroidHeadset),
            RenderMode,
            new InternetAccessCheck(),
            FrameTiming,
            RunInBackground,
            NativeWebSocket,
        };

        static ProjectCheck OpenXr => new PackageCheck(
            "OpenXR", CheckReasons.OpenXr, ProjectNeeds.OpenXr);

        static ProjectCheck RenderMode => new OpenXrOptionCheck(
            "Render Mode", CheckReasons.RenderMode, "m_renderMode", RenderModes, 1);

        static ProjectCheck FrameTiming => new FrameTimingCheck();

        static ProjectCheck RunInBackground => new RunInBackgroundCheck();

        static ProjectCheck NativeWebSocket => new PackageCheck(
            "NativeWebSocket (optional)", CheckReasons.NativeWebSocket, ProjectNeeds.NativeWebSocket,
            CheckState.Advice);
    }
}
