using Nowpose.Editor.Messages;

namespace Nowpose.Editor.Setup
{
    sealed class OpenXrLoaderCheck : ProjectCheck
    {
        // The fix only opens the Project Settings, because another package owns the setting, and this assembly does not reference that package.
        public OpenXrLoaderCheck(HeadsetPlatform platform)
            : base(CheckTitles.OpenXrLoader(platform.ShortPlayer),
                CheckReasons.OpenXrLoader, "Open Project Settings")
        { }

        public override CheckResult Look(IProjectSettings project)
        {
            switch (project.UsesOpenXr)
            {
                case true: return Good("OpenXR is ticked");
                case false: return Missing(CheckResults.NoLoader);
                default: return Missing(CheckResults.NoXrSettings);
            }
        }

        public override string Fix(IProjectSettings project)
        {
            project.OpenProjectSettings();
            return CheckFixes.OpenXrLoader(project.Platform.Player);
        }
    }
}
