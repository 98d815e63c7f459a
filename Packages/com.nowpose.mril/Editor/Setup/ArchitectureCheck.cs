namespace Nowpose.Editor.Setup
{
    sealed class ArchitectureCheck : ProjectCheck
    {
        const string Arm64 = "ARM64";

        public ArchitectureCheck()
            : base("Architecture is ARM64", "A HoloLens 2 has an ARM64 processor; an app for another one cannot be installed.", "Use ARM64") { }

        public override CheckResult Look(IProjectSettings project) =>
            project.Architecture == Arm64 ? Good(Arm64) : Missing("the app is built for " + project.Architecture);

        public override string Fix(IProjectSettings project)
        {
            project.Architecture = Arm64;
            return null;
        }
    }
}
