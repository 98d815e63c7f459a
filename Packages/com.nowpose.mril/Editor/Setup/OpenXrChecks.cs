using System;
using Nowpose.Editor.Messages;

namespace Nowpose.Editor.Setup
{
    /// <summary>Checks of the XR plug-in and its settings.</summary>
    static class OpenXrChecks
    {
        // The fix only opens the Project Settings, because another package owns the setting, and this assembly does not reference that package.
        public static ProjectCheck Loader(HeadsetPlatform platform) => new ProjectCheck(
            CheckTitles.OpenXrLoader(platform.ShortPlayer), CheckReasons.OpenXrLoader,
            project => project.UsesOpenXr switch
            {
                true => CheckResult.Good("OpenXR is ticked"),
                false => CheckResult.Missing(CheckResults.NoLoader),
                null => CheckResult.Missing(CheckResults.NoXrSettings),
            },
            "Open Project Settings", project => OpenSettings(project, CheckFixes.OpenXrLoader(project.Platform.Player)));

        /// <summary>Checks whether an OpenXR feature is enabled for the player.</summary>
        /// <param name="name">Name of the feature in the settings window.</param>
        /// <param name="why">Purpose of the feature.</param>
        /// <param name="id">Id of the feature in OpenXR's settings.</param>
        /// <param name="without">State of a project in which the feature is not enabled.</param>
        public static ProjectCheck Feature(string name, string why, string id, CheckState without = CheckState.Missing) => new ProjectCheck(
            CheckTitles.Feature(name), why,
            project => project.IsFeatureOn(id) switch
            {
                true => CheckResult.Good("ticked"),
                false => new CheckResult(without, "not ticked"),
                null => new CheckResult(without, CheckResults.NoFeature),
            },
            "Tick " + name, project => project.TurnFeatureOn(id) ? null : OpenSettings(project, CheckFixes.Feature(name)));

        /// <summary>Checks the value of an enumeration setting of OpenXR.</summary>
        /// <param name="title">Title of the setting in the settings window.</param>
        /// <param name="why">Purpose of the requirement.</param>
        /// <param name="field">Serialised name of the setting.</param>
        /// <param name="names">Names of all values, indexed by their number.</param>
        /// <param name="wanted">Number of the required value.</param>
        /// <param name="without">State of a project with another value.</param>
        /// <param name="absent">Result if the OpenXR settings of the project do not have the setting; null for a missing requirement.</param>
        public static ProjectCheck Option(
            string title, string why, string field, string[] names, int wanted, CheckState without = CheckState.Missing,
            CheckResult? absent = null) =>
            new ProjectCheck(CheckTitles.OpenXrOption(title, names[wanted]), why,
                project =>
                {
                    if (!project.HasOpenXrSettings) return new CheckResult(without, CheckResults.NoOpenXrSettings);
                    if (!(project.OpenXrOption(field) is int value)) return absent ?? new CheckResult(without, CheckResults.NoOpenXrSettings);
                    var name = value >= 0 && value < names.Length ? names[value] : FormattableString.Invariant($"unknown value {value}");
                    return value == wanted ? CheckResult.Good(name) : new CheckResult(without, name + " is chosen");
                },
                "Use " + names[wanted],
                project => project.ChooseOpenXrOption(field, wanted)
                    ? null : OpenSettings(project, CheckFixes.OpenXrOption(title, names[wanted])));

        static string OpenSettings(IProjectSettings project, string instruction)
        {
            project.OpenProjectSettings();
            return instruction;
        }
    }
}
