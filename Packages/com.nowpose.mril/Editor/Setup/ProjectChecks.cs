using System.Collections.Generic;
using UnityEditor;

namespace Nowpose.Editor
{
    /// <summary>All that is looked at, in the order in which it is best done.</summary>
    static class ProjectChecks
    {
        public static IReadOnlyList<ProjectCheck> ForHoloLens() => new ProjectCheck[]
        {
            new BuildTargetCheck(),
            new ScriptingBackendCheck(),
            new ArchitectureCheck(),
            new ApiLevelCheck(),
            new PackageCheck(
                "OpenXR", "Unity's way to the headset.", "com.unity.xr.openxr", PackageOrigin.OfUnity("com.unity.xr.openxr")),
            new PackageCheck(
                "Mixed Reality OpenXR", "What a HoloLens has beyond OpenXR: anchors, markers, the time at which a frame is displayed.",
                "com.microsoft.mixedreality.openxr",
                PackageOrigin.Of(ScopedRegistry.Microsoft, "com.microsoft.mixedreality.openxr", "1.11.2")),
            new OpenXrLoaderCheck(),
            new CapabilityCheck(
                PlayerSettings.WSACapability.InternetClient, "To connect to a gateway in another network, and to any by its public address."),
            new CapabilityCheck(
                PlayerSettings.WSACapability.PrivateNetworkClientServer, "To connect to a gateway in the same private network, the usual case."),
            new CapabilityCheck(PlayerSettings.WSACapability.WebCam, "To find the robot's base by a marker, which the headset's camera sees."),
            new CapabilityCheck(PlayerSettings.WSACapability.SpatialPerception, "To keep the robot's base where it is in the room."),
            new FrameTimingCheck(),
            new RunInBackgroundCheck(),
            new PackageCheck(
                "MRTK3 (optional)", "Hand menus and grabbing; the package works without.", "org.mixedrealitytoolkit.core",
                byHand: "get it with Microsoft's Mixed Reality Feature Tool or from github.com/MixedRealityToolkit", without: CheckState.Advice),
            new PackageCheck(
                "NativeWebSocket (optional)", "Another way to speak WebSocket; the package has one of its own.", "com.endel.nativewebsocket",
                PackageOrigin.OfGit("com.endel.nativewebsocket", "https://github.com/endel/NativeWebSocket.git#upm-2"),
                without: CheckState.Advice),
        };
    }
}
