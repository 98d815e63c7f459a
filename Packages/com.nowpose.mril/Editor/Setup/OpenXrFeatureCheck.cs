namespace Nowpose.Editor
{
    /// <summary>A feature of OpenXR that has to be ticked for the player.</summary>
    sealed class OpenXrFeatureCheck : ProjectCheck
    {
        readonly string _id, _name;

        /// <param name="name">As the list of features shows it.</param>
        public OpenXrFeatureCheck(string name, string why, string id)
            : base("OpenXR feature " + name, why, "Tick " + name)
        {
            _id = id;
            _name = name;
        }

        public override CheckResult Look(IProjectSettings project)
        {
            switch (project.IsFeatureOn(_id))
            {
                case true: return Good("ticked");
                case false: return Missing("not ticked");
                default: return Missing("the project has no such feature yet: it comes with OpenXR and Microsoft's plug-in, once OpenXR is ticked");
            }
        }

        public override string Fix(IProjectSettings project)
        {
            if (project.TurnFeatureOn(_id)) return null;
            project.OpenProjectSettings();
            return "Project Settings, XR Plug-in Management, OpenXR: tick " + _name + ".";
        }
    }
}
