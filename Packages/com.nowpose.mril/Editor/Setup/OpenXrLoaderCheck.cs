namespace Nowpose.Editor.Setup
{
    sealed class OpenXrLoaderCheck : ProjectCheck
    {
        // The fix only opens the Project Settings, because another package owns the setting, and this assembly does not reference that package.
        public OpenXrLoaderCheck(HeadsetPlatform platform)
            : base(
                "OpenXR starts in the " + platform.ShortPlayer + " player",
                "Without it the app is a flat window in front of the wearer.", "Open Project Settings")
        { }

        public override CheckResult Look(IProjectSettings project)
        {
            switch (project.UsesOpenXr)
            {
                case true: return Good("OpenXR is ticked");
                case false: return Missing("no plug-in or another one is ticked");
                default: return Missing("the project has no settings for XR plug-ins yet");
            }
        }

        public override string Fix(IProjectSettings project)
        {
            project.OpenProjectSettings();
            return "Project Settings, XR Plug-in Management, tab " + project.Platform.Player + ": tick OpenXR and the feature group of your headset.";
        }
    }
}
