using System;

namespace Nowpose.Editor.Messages
{
    /// <summary>Messages in the set-up window that describe the results of the checks.</summary>
    static class CheckResults
    {
        public static string Architecture(string architecture) => $"the app is built for {architecture}";
        public const string PcHeadset = "; switch to the player of your headset. These checks do not cover headsets on a PC";

        public static string BuildTarget(string target) =>
            $"the project is built for {target}" + (target.StartsWith("Standalone", StringComparison.Ordinal) ? PcHeadset : "");

        public const string FirstScene = "the open scene is the first one of the build";
        public const string OtherSceneFirst = "another scene is before the open one; clear its tick in the build list (File, Build Settings)";
        public const string SceneNotListed =
            "the build list does not contain the open scene; open the scene of the headset, and select Add Open Scenes in the build list";

        public const string NoCamera = "the open scenes have no enabled camera with the tag MainCamera; open the scene of the headset";
        public const string CameraBackground = "the camera clears to a skybox or to another colour";
        public const string NoGraphicsApi = "Unity lists no graphics API for this player, because its module is not installed; add it in Unity Hub";

        public static string AutomaticApi(string api) => $"automatic, which is {api} in this version of Unity";

        public const string OtherBuildTarget = "Unity shows this setting for the active build target only; switch the build target first";
        public const string NoInputHandling = "not found in the project's settings; see Project Settings, Player, Other Settings";

        public static string InputHandlingOnAndroid(string name) => $"{name}, which Unity does not support on Android";

        public static string AfterRestart(string name) => $"{name}, which takes effect when you restart Unity";

        public const string InternetAccess = "the app requests the permission INTERNET";

        public static string NearClip(string found, double millimetres, double metres) =>
            FormattableString.Invariant($"{found}; at a distance of {metres} m, one depth step is {millimetres:0.##} mm");

        public static string FarNearClip(string found) => $"{found}; objects closer to the eyes are not drawn";

        public const string NoFeature = "the project does not have this feature yet: the feature's package adds it when OpenXR is ticked";
        public const string NoLoader = "OpenXR is not ticked";
        public const string NoXrSettings = "the project has no settings for XR plug-ins yet";
        public const string NoLatencyOptimization = "not found; version 1.15 and newer of Unity's OpenXR plug-in have this setting";
        public const string NoOpenXrSettings = "the project has no OpenXR settings yet";

        public static string OrNewer(Version below) => $" or newer, but older than {below}";

        const string ChoosePipeline = "choose URP or none under Project Settings, Graphics and Quality";
        public const string BuiltIn = "built-in render pipeline; the shaders' built-in SubShader is used";

        public static string Urp(string asset) => $"URP ({asset}); the shaders' SubShader for URP is used";
        public static string Hdrp(string asset) => $"HDRP ({asset}): the package has no shaders for it; {ChoosePipeline}";
        public static string OtherPipeline(string asset) => $"{asset}: the package's shaders do not support it; {ChoosePipeline}";

        public const string ScriptingBackend = "a backend other than IL2CPP is selected";

        public static string UnityVersion(string version) => $"{version}: the version cannot be read";

        public static string NotInstalled(string packages, int count) =>
            $"{packages} {Are(count)} not installed; close Unity and run `nowpose unity PROJECT --mrtk3`, or get the tarballs from the releases of "
            + "github.com/MixedRealityToolkit/MixedRealityToolkit-Unity";

        public static string NotSupported(string packages, int count, string supported) =>
            $"{packages} {Are(count)} not supported; close Unity and run `nowpose unity PROJECT --mrtk3 --on-conflict replace`, or write {supported} "
            + "into Packages/manifest.json";

        public static string NotInstalled(string package) => $"{package} is not installed";

        public static string OutsideBounds(string package, string version, bool isTooNew, string bounds) =>
            $"{package} {version} is too {(isTooNew ? "new" : "old")}; allowed: {bounds}";

        static string Are(int count) => count == 1 ? "is" : "are";
    }
}
