using System;
using Nowpose.Editor.Messages;

namespace Nowpose.Editor.Setup
{
    /// <summary>Checks whether the Input System is active. Installing its package does not activate it.</summary>
    sealed class InputHandlingCheck : ProjectCheck
    {
        /// <summary>Names of the values, indexed by the numbers in the project's settings.</summary>
        static readonly string[] Names = { "Input Manager (Old)", CheckTitles.InputSystem, "Both" };

        const int InputSystem = 1, Both = 2;

        public InputHandlingCheck()
            : base(CheckTitles.InputHandling,
                CheckReasons.InputHandling,
                CheckTitles.UseInputSystem)
        { }

        public override CheckResult Look(IProjectSettings project)
        {
            if (!(project.InputHandling is int value))
                return new CheckResult(CheckState.Unknown, CheckResults.NoInputHandling);
            var name = value >= 0 && value < Names.Length ? Names[value] : FormattableString.Invariant($"unknown value {value}");
            if (value == Both && project.Platform == HeadsetPlatform.AndroidHeadset)
                return new CheckResult(CheckState.Advice, CheckResults.InputHandlingOnAndroid(name));
            return value == InputSystem || value == Both ? Good(name) : Missing(name);
        }

        public override string Fix(IProjectSettings project)
        {
            if (project.ChooseInputHandling(InputSystem)) return null;
            project.OpenProjectSettings();
            return CheckFixes.InputHandling(Names[InputSystem]);
        }
    }
}
