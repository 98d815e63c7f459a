namespace Nowpose.Editor
{
    sealed class OpenXrLoaderCheck : ProjectCheck
    {
        const string Where = "Project Settings, XR Plug-in Management, tab Universal Windows Platform: tick OpenXR and its feature group "
            + "Microsoft HoloLens.";

        // The settings belong to another package, whose assemblies this one does not know.
        public OpenXrLoaderCheck()
            : base(
                "OpenXR starts in the UWP player", "Without it the app is a flat window in front of the wearer.", "Open Project Settings") { }

        public override CheckResult Look(IProjectSettings project)
        {
            switch (project.UsesOpenXr)
            {
                case true: return Good("OpenXR is ticked");
                case false: return Missing("another plug-in or none is ticked");
                default: return Missing("the project has no settings for XR plug-ins yet");
            }
        }

        public override string Fix(IProjectSettings project)
        {
            project.OpenProjectSettings();
            return Where;
        }
    }
}
