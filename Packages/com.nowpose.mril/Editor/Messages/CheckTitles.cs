namespace Nowpose.Editor.Messages
{
    /// <summary>Titles of the checks in the set-up window, and labels of their buttons.</summary>
    static class CheckTitles
    {
        public static string BuildTarget(string player) => $"Build target is {player}";
        public static string Feature(string feature) => $"OpenXR feature {feature}";
        public static string OpenXrOption(string option, string value) => $"OpenXR {option} is {value}";
        public static string Capability(string capability) => $"Capability {capability}";
        public static string Declare(string capability) => $"Declare {capability}";
        public static string AddPackage(string package) => $"Add {package}";
        public static string SwitchTo(string player) => $"Switch to {player}";

        public const string ApiLevel = "Api Compatibility Level is .NET Standard 2.1";
        public const string CameraBackground = "Main camera clears to black with alpha 0";
        public const string ClearToBlack = "Clear to black with alpha 0";
        public const string FirstScene = "The app starts with the open scene";
        public const string FrameTiming = "Frame Timing Stats are on";
        public const string TurnFrameTimingOn = "Turn Frame Timing Stats on";
        public const string GraphicsApi = "Graphics API is Direct3D 11 only";
        public const string GraphicsJobs = "Graphics Jobs are off";
        public const string TurnGraphicsJobsOff = "Turn Graphics Jobs off";
        public const string InputSystem = "Input System Package (New)";
        public const string InputHandling = "Active Input Handling is Input System Package";
        public const string UseInputSystem = "Use the Input System (then restart Unity)";
        public const string InternetAccess = "Internet Access is set to Require";
        public const string UndoClear = "Clear to transparent black";
        public const string MrtkGeneration = "MRTK is version 3 and XR Interaction Toolkit is version 2, if installed";
        public const string NearClip = "Main camera's near clip plane is at 0.1 m";

        public static string OpenXrLoader(string player) => $"OpenXR starts in the {player} player";

        public const string HandInteraction = "Microsoft Hand Interaction Profile";
        public const string EyeGaze = "Eye Gaze Interaction Profile";
        public const string RenderPipeline = "Render pipeline is the built-in one or URP";
        public const string RunInBackground = "Run In Background is on";
        public const string TurnRunInBackgroundOn = "Turn Run In Background on";
        public const string ScriptingBackend = "Scripting backend is IL2CPP";
        public const string UnityVersion = "Unity version is recommended";
    }
}
