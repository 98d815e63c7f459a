using Nowpose.Editor.Messages;

namespace Nowpose.Editor.Setup
{
    /// <summary>Checks whether an OpenXR feature is enabled for the player.</summary>
    sealed class OpenXrFeatureCheck : ProjectCheck
    {
        readonly string _id, _name;
        readonly CheckState _without;

        /// <param name="name">Name of the feature in the settings window.</param>
        /// <param name="why">Purpose of the feature.</param>
        /// <param name="id">Id of the feature in OpenXR's settings.</param>
        /// <param name="without">State of a project in which the feature is not enabled.</param>
        public OpenXrFeatureCheck(string name, string why, string id, CheckState without = CheckState.Missing)
            : base("OpenXR feature " + name, why, "Tick " + name)
        {
            _id = id;
            _name = name;
            _without = without;
        }

        public override CheckResult Look(IProjectSettings project)
        {
            switch (project.IsFeatureOn(_id))
            {
                case true: return Good("ticked");
                case false: return new CheckResult(_without, "not ticked");
                default: return new CheckResult(_without, CheckResults.NoFeature);
            }
        }

        public override string Fix(IProjectSettings project)
        {
            if (project.TurnFeatureOn(_id)) return null;
            project.OpenProjectSettings();
            return CheckFixes.Feature(_name);
        }
    }
}
