namespace Nowpose.Editor.Setup
{
    /// <summary>Checks whether this editor is a version that the package was tried with.</summary>
    sealed class UnityVersionCheck : ProjectCheck
    {
        public UnityVersionCheck()
            : base(
                "Unity is a version that was tried", "Other versions may lack what the package or Microsoft's plug-in is compiled against.", null) { }

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
