using Nowpose.Editor.Messages;

namespace Nowpose.Editor.Setup
{
    sealed class ArchitectureCheck : ProjectCheck
    {
        const string Arm64 = "ARM64";

        public ArchitectureCheck()
            : base("Architecture is ARM64", CheckReasons.Architecture, "Use ARM64") { }

        public override CheckResult Look(IProjectSettings project) =>
            project.Architecture == Arm64 ? Good(Arm64) : Missing(CheckResults.Architecture(project.Architecture));

        public override string Fix(IProjectSettings project)
        {
            project.Architecture = Arm64;
            return null;
        }
    }
}
