using Nowpose.Editor.Messages;

namespace Nowpose.Editor.Setup
{
    /// <summary>Checks whether the version of the running editor is recommended.</summary>
    sealed class UnityVersionCheck : ProjectCheck
    {
        public UnityVersionCheck()
            : base(CheckTitles.UnityVersion, CheckReasons.UnityVersion, null)
        { }

        public override CheckResult Look(IProjectSettings project)
        {
            var version = UnityVersion.TryParse(project.EditorVersion);
            return version == null
                ? new CheckResult(CheckState.Unknown, CheckResults.UnityVersion(project.EditorVersion))
                : UnityBounds.Judge(version.Value, project.Platform == HeadsetPlatform.HoloLens2);
        }

        public override string Fix(IProjectSettings project) => null;
    }
}
