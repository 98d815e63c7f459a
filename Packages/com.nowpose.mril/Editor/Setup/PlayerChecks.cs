using System;
using Nowpose.Editor.Messages;
using UnityEditor;

namespace Nowpose.Editor.Setup
{
    /// <summary>Checks of the editor's version and the player settings.</summary>
    static class PlayerChecks
    {
        const string Arm64 = "ARM64";

        /// <summary>Names of the values of Active Input Handling, indexed by the numbers in the project's settings.</summary>
        static readonly string[] InputNames = { "Input Manager (Old)", CheckTitles.InputSystem, "Both" };

        const int InputSystem = 1, BothInputs = 2;

        public static ProjectCheck EditorVersion { get; } = new ProjectCheck(CheckTitles.UnityVersion, CheckReasons.UnityVersion, project =>
            UnityVersion.TryParse(project.EditorVersion) is UnityVersion version
                ? UnityVersionRatings.Judge(version, project.Platform == HeadsetPlatform.HoloLens2)
                : CheckResult.Unknown(CheckResults.UnityVersion(project.EditorVersion)));

        public static ProjectCheck Architecture { get; } = new ProjectCheck(
            "Architecture is ARM64", CheckReasons.Architecture,
            project => project.Architecture == Arm64
                ? CheckResult.Good(Arm64) : CheckResult.Missing(CheckResults.Architecture(project.Architecture)),
            "Use ARM64", ProjectCheck.Always(project => project.Architecture = Arm64));

        public static ProjectCheck ApiLevel { get; } = new ProjectCheck(
            CheckTitles.ApiLevel, CheckReasons.ApiLevel,
            project => project.UsesNetStandard ? CheckResult.Good(".NET Standard 2.1") : CheckResult.Advice(".NET Framework"),
            "Use .NET Standard 2.1", ProjectCheck.Always(project => project.UsesNetStandard = true));

        public static ProjectCheck InternetAccess { get; } = new ProjectCheck(
            CheckTitles.InternetAccess, CheckReasons.InternetAccess,
            project => project.AsksForInternet ? CheckResult.Good(CheckResults.InternetAccess) : CheckResult.Missing("left to Unity"),
            "Require internet access", ProjectCheck.Always(project => project.AsksForInternet = true));

        public static ProjectCheck FrameTiming { get; } = new ProjectCheck(
            CheckTitles.FrameTiming, CheckReasons.FrameTiming,
            project => project.FrameTimingStats ? CheckResult.Good("on") : CheckResult.Missing("off"),
            CheckTitles.TurnFrameTimingOn, ProjectCheck.Always(project => project.FrameTimingStats = true));

        public static ProjectCheck RunInBackground { get; } = new ProjectCheck(
            CheckTitles.RunInBackground, CheckReasons.RunInBackground,
            project => project.RunsInBackground ? CheckResult.Good("on") : CheckResult.Advice("off"),
            CheckTitles.TurnRunInBackgroundOn, ProjectCheck.Always(project => project.RunsInBackground = true));

        /// <summary>Checks whether the app starts with the open scene and not, for example, with the empty scene of a template.</summary>
        public static ProjectCheck FirstScene { get; } = new ProjectCheck(
            CheckTitles.FirstScene, CheckReasons.FirstScene,
            project => project.StartsWithOpenScene switch
            {
                true => CheckResult.Good(CheckResults.FirstScene),
                false => CheckResult.Advice(CheckResults.OtherSceneFirst),
                null => CheckResult.Advice(CheckResults.SceneNotListed),
            });

        /// <summary>Checks whether the Input System is active. Installing its package does not activate it.</summary>
        public static ProjectCheck InputHandling { get; } = new ProjectCheck(
            CheckTitles.InputHandling, CheckReasons.InputHandling, LookAtInput, CheckTitles.UseInputSystem, project =>
            {
                if (project.ChooseInputHandling(InputSystem)) return null;
                project.OpenProjectSettings();
                return CheckFixes.InputHandling(InputNames[InputSystem]);
            });

        public static ProjectCheck UwpBackend { get; } = ScriptingBackend(CheckReasons.UwpBackend, _ => CheckState.Missing);

        public static ProjectCheck AndroidBackend { get; } = ScriptingBackend(
            CheckReasons.AndroidBackend, project => project.TargetsArm64 ? CheckState.Missing : CheckState.Advice);

        public static ProjectCheck BuildTarget(HeadsetPlatform platform) => new ProjectCheck(
            CheckTitles.BuildTarget(platform.Player), CheckReasons.BuildTarget(platform.Headset),
            project => project.OtherTarget == null
                ? CheckResult.Good(project.Platform.Player) : CheckResult.Missing(CheckResults.BuildTarget(project.OtherTarget)),
            CheckTitles.SwitchTo(platform.ShortPlayer),
            project => project.SwitchToPlatform() ? null : CheckFixes.BuildSupport(project.Platform.Player));

        /// <summary>Checks whether the app declares a capability. Without it, Windows refuses access; only the network reports an error.</summary>
        /// <param name="why">Purpose of the capability.</param>
        /// <param name="without">State of a project that does not declare the capability.</param>
        public static ProjectCheck Capability(PlayerSettings.WSACapability capability, string why, CheckState without = CheckState.Missing) =>
            new ProjectCheck(
                CheckTitles.Capability(capability.ToString()), why,
                project => project.IsAllowed(capability) ? CheckResult.Good("declared") : new CheckResult(without, "not declared"),
                CheckTitles.Declare(capability.ToString()), ProjectCheck.Always(project => project.Allow(capability)));

        /// <param name="without">State of a project with another backend.</param>
        static ProjectCheck ScriptingBackend(string why, Func<IProjectSettings, CheckState> without) => new ProjectCheck(
            CheckTitles.ScriptingBackend, why,
            project => project.UsesIl2Cpp ? CheckResult.Good("IL2CPP") : new CheckResult(without(project), CheckResults.ScriptingBackend),
            "Use IL2CPP", ProjectCheck.Always(project => project.UsesIl2Cpp = true));

        static CheckResult LookAtInput(IProjectSettings project)
        {
            if (!(project.InputHandling is int value)) return CheckResult.Unknown(CheckResults.NoInputHandling);
            var name = value >= 0 && value < InputNames.Length ? InputNames[value] : FormattableString.Invariant($"unknown value {value}");
            if (value == BothInputs && project.Platform == HeadsetPlatform.AndroidHeadset)
                return CheckResult.Advice(CheckResults.InputHandlingOnAndroid(name));
            if (value != InputSystem && value != BothInputs) return CheckResult.Missing(name);
            return project.IsInputHandlingPending ? CheckResult.Missing(CheckResults.AfterRestart(name)) : CheckResult.Good(name);
        }
    }
}
