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
        static readonly string[] LatencyOptimizations = { "Prioritize Rendering", "Prioritize Input Polling" };

        public static IReadOnlyList<ProjectCheck> For(HeadsetPlatform platform) =>
            platform == HeadsetPlatform.HoloLens2 ? ForHoloLens() : ForAndroid();

        public static IReadOnlyList<ProjectCheck> ForHoloLens() => new[]
        {
            PlayerChecks.EditorVersion,
            PlayerChecks.BuildTarget(HeadsetPlatform.HoloLens2),
            PlayerChecks.UwpBackend,
            PlayerChecks.Architecture,
            PlayerChecks.ApiLevel,
            RenderingChecks.GraphicsApi,
            RenderingChecks.GraphicsJobs,
            RenderingChecks.Pipeline,
            PlayerChecks.InputHandling,
            PackageChecks.OpenXr,
            PackageChecks.Of("Mixed Reality OpenXR", CheckReasons.MixedRealityOpenXr, ProjectNeeds.MixedRealityOpenXr),
            PackageChecks.Of("AR Foundation", CheckReasons.ArFoundation, ProjectNeeds.ArFoundation, CheckState.Advice),
            OpenXrChecks.Loader(HeadsetPlatform.HoloLens2),
            OpenXrChecks.Feature("Mixed Reality Features", CheckReasons.MixedRealityFeatures, "com.microsoft.openxr.feature.hololens"),
            OpenXrChecks.Feature("Hand Tracking", CheckReasons.HandTracking, "com.microsoft.openxr.feature.handtracking", CheckState.Advice),
            OpenXrChecks.Feature(
                CheckTitles.HandInteraction, CheckReasons.HandInteraction, "com.unity.openxr.feature.input.handtracking", CheckState.Advice),
            OpenXrChecks.Feature(CheckTitles.EyeGaze, CheckReasons.EyeGaze, "com.unity.openxr.feature.input.eyetracking", CheckState.Advice),
            RenderMode,
            DepthSubmission(CheckState.Missing),
            LatencyOptimization,
            PlayerChecks.Capability(PlayerSettings.WSACapability.InternetClient, CheckReasons.InternetClient),
            PlayerChecks.Capability(PlayerSettings.WSACapability.PrivateNetworkClientServer, CheckReasons.PrivateNetwork),
            PlayerChecks.Capability(PlayerSettings.WSACapability.WebCam, CheckReasons.WebCam),
            PlayerChecks.Capability(PlayerSettings.WSACapability.SpatialPerception, CheckReasons.SpatialPerception),
            PlayerChecks.Capability(PlayerSettings.WSACapability.GazeInput, CheckReasons.EyeGaze, CheckState.Advice),
            PlayerChecks.Capability(PlayerSettings.WSACapability.Microphone, CheckReasons.VoiceCapability, CheckState.Advice),
            PlayerChecks.FrameTiming,
            PlayerChecks.RunInBackground,
            RenderingChecks.CameraBackground,
            RenderingChecks.NearClip,
            PlayerChecks.FirstScene,
            PackageChecks.MrtkGeneration,
            PackageChecks.Mrtk3,
            NativeWebSocket,
        };

        public static IReadOnlyList<ProjectCheck> ForAndroid() => new[]
        {
            PlayerChecks.EditorVersion,
            PlayerChecks.BuildTarget(HeadsetPlatform.AndroidHeadset),
            PlayerChecks.AndroidBackend,
            PlayerChecks.ApiLevel,
            RenderingChecks.Pipeline,
            PlayerChecks.InputHandling,
            PackageChecks.OpenXr,
            PackageChecks.Of("Input System", CheckReasons.InputSystem, ProjectNeeds.InputSystem),
            OpenXrChecks.Loader(HeadsetPlatform.AndroidHeadset),
            RenderMode,
            DepthSubmission(CheckState.Advice),
            LatencyOptimization,
            PlayerChecks.InternetAccess,
            PlayerChecks.FrameTiming,
            PlayerChecks.RunInBackground,
            RenderingChecks.CameraBackground,
            RenderingChecks.NearClip,
            PlayerChecks.FirstScene,
            NativeWebSocket,
        };

        static ProjectCheck RenderMode => OpenXrChecks.Option("Render Mode", CheckReasons.RenderMode, "m_renderMode", RenderModes, wanted: 1);

        static ProjectCheck LatencyOptimization => OpenXrChecks.Option(
            "Latency Optimization", CheckReasons.LatencyOptimization, "m_latencyOptimization", LatencyOptimizations, wanted: 0, CheckState.Advice,
            CheckResult.Good(CheckResults.NoLatencyOptimization));

        static ProjectCheck DepthSubmission(CheckState without) => OpenXrChecks.Option(
            "Depth Submission Mode", CheckReasons.DepthSubmission, "m_depthSubmissionMode", DepthModes, wanted: 1, without);

        static ProjectCheck NativeWebSocket =>
            PackageChecks.Of("NativeWebSocket (optional)", CheckReasons.NativeWebSocket, ProjectNeeds.NativeWebSocket, CheckState.Advice);
    }
}
