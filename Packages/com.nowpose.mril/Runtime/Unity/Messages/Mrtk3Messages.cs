namespace Nowpose.Unity.Messages
{
    /// <summary>Messages about missing references and functions of the components for MRTK3. Each message states a remedy.</summary>
    static class Mrtk3Messages
    {
        public const string VisuByRuntime = "L_visu by the runtime";

        public static string PromptWithoutPairing(string component) =>
            $"consent prompt '{component}' has no cell pairing on its object or a parent; assign one";

        public static string MarkerWithoutMarker(string component) => $"graspable marker '{component}' has no hand placed marker; assign one";

        public static string MarkerWithoutManipulator(string component) => $"graspable marker '{component}' has no object manipulator; assign one";

        public static string PanelWithoutFollow(string component) => $"graspable panel '{component}' has no body follow; assign one";

        public static string PanelWithoutManipulator(string component) => $"graspable panel '{component}' has no object manipulator; assign one";

        public static string MenuWithoutActions(string component) =>
            $"headset menu '{component}' has no cell actions on its object or a parent; assign them";

        public static string VoiceNotRunning(string component) =>
            $"voice commands '{component}': keyword recognition is not running; use the menu instead";

        public static string VoiceNotSupported(string component) =>
            $"voice commands '{component}': keyword recognition is not supported on this platform; use the menu instead";
    }
}
