namespace Nowpose.Editor.Messages
{
    /// <summary>Instructions to the user about settings that the set-up window cannot change.</summary>
    static class CheckFixes
    {
        public static string BuildSupport(string player) =>
            $"Unity could not switch the build target: add the module '{player} Build Support' to this editor in Unity Hub.";

        public const string OpenScene = "Open a scene with a main camera first.";
        public const string BuildTarget = "Switch the build target first.";

        public static string InputHandling(string name) =>
            $"Project Settings, Player, Other Settings: set Active Input Handling to {name}. Unity then restarts.";

        public static string Feature(string feature) => $"Project Settings, XR Plug-in Management, OpenXR: tick {feature}.";

        public static string OpenXrLoader(string player) =>
            $"Project Settings, XR Plug-in Management, tab {player}: tick OpenXR and the feature group of your headset.";

        public static string OpenXrOption(string option, string value) => $"Project Settings, XR Plug-in Management, OpenXR: set {option} to {value}.";
    }
}
