namespace Nowpose.Editor.Setup
{
    /// <summary>Checks whether the package was tested with the version of the running editor.</summary>
    sealed class UnityVersionCheck : ProjectCheck
    {
        public UnityVersionCheck()
            : base(
                "The Unity version has been tested", "Other versions may lack functions that the package or Microsoft's plug-in uses.", null)
        { }

        public override CheckResult Look(IProjectSettings project)
        {
            var version = UnityVersion.TryParse(project.EditorVersion);
            return version == null
                ? new CheckResult(CheckState.Unknown, project.EditorVersion + ": the version cannot be read")
                : UnityBounds.Judge(version.Value, project.Platform == HeadsetPlatform.HoloLens2);
        }

        public override string Fix(IProjectSettings project) => null;
    }
}
