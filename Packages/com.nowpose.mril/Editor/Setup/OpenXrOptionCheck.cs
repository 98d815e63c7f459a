using System;
using Nowpose.Editor.Messages;

namespace Nowpose.Editor.Setup
{
    /// <summary>Checks whether an enumeration setting of OpenXR has a required value.</summary>
    sealed class OpenXrOptionCheck : ProjectCheck
    {
        readonly string _field, _title;
        readonly string[] _names;
        readonly int _wanted;

        /// <param name="title">Title of the setting in the settings window.</param>
        /// <param name="why">Purpose of the requirement.</param>
        /// <param name="field">Serialised name of the setting.</param>
        /// <param name="names">Names of all values, indexed by their number.</param>
        /// <param name="wanted">Number of the required value.</param>
        public OpenXrOptionCheck(string title, string why, string field, string[] names, int wanted)
            : base("OpenXR " + title + " is " + names[wanted], why, "Use " + names[wanted])
        {
            _title = title;
            _field = field;
            _names = names;
            _wanted = wanted;
        }

        public override CheckResult Look(IProjectSettings project)
        {
            if (!(project.OpenXrOption(_field) is int value)) return Missing(CheckResults.NoOpenXrSettings);
            var name = value >= 0 && value < _names.Length ? _names[value] : FormattableString.Invariant($"unknown value {value}");
            return value == _wanted ? Good(name) : Missing(name + " is chosen");
        }

        public override string Fix(IProjectSettings project)
        {
            if (project.ChooseOpenXrOption(_field, _wanted)) return null;
            project.OpenProjectSettings();
            return CheckFixes.OpenXrOption(_title, _names[_wanted]);
        }
    }
}
