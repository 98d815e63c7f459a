using System;

namespace Nowpose.Editor.Setup
{
    /// <summary>Checks whether the Input System is active. The installation of its package does not activate it.</summary>
    sealed class InputHandlingCheck : ProjectCheck
    {
        /// <summary>Names of the values, indexed by their number in the project's settings.</summary>
        static readonly string[] Names = { "Input Manager (Old)", "Input System Package (New)", "Both" };

        const int InputSystem = 1, Both = 2;

        public InputHandlingCheck()
            : base(
                "Active Input Handling is Input System Package",
                "OpenXR provides the poses of head and hands through it, and MRTK3 needs it. Without it the camera does not follow the head.",
                "Use the Input System (then restart Unity)")
        { }

        public override CheckResult Look(IProjectSettings project)
        {
            if (!(project.InputHandling is int value))
                return new CheckResult(CheckState.Unknown, "not found in the project's settings; see Project Settings, Player, Other Settings");
            var name = value >= 0 && value < Names.Length ? Names[value] : FormattableString.Invariant($"unknown value {value}");
            if (value == Both && project.Platform == HeadsetPlatform.AndroidHeadset)
                return new CheckResult(CheckState.Advice, name + ", which Unity does not support on Android");
            return value == InputSystem || value == Both ? Good(name) : Missing(name);
        }

        public override string Fix(IProjectSettings project)
        {
            if (project.ChooseInputHandling(InputSystem)) return null;
            project.OpenProjectSettings();
            return "Project Settings, Player, Other Settings, Active Input Handling: " + Names[InputSystem] + "; Unity restarts for it.";
        }
    }
}
