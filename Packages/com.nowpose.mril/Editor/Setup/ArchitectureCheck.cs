namespace Nowpose.Editor.Setup
{
    sealed class ArchitectureCheck : ProjectCheck
    {
        const string Arm64 = "ARM64";

        public ArchitectureCheck()
            : base("Architecture is ARM64", "The processor of a HoloLens 2; an app built for another cannot be installed.", "Use ARM64") { }

        public override CheckResult Look(IProjectSettings project) =>
            project.Architecture == Arm64 ? Good(Arm64) : Missing("the app is built for " + project.Architecture);

        public override string Fix(IProjectSettings project)
        {
            project.Architecture = Arm64;
            return null;
        }
    }
}
