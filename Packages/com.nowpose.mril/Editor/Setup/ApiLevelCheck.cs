namespace Nowpose.Editor.Setup
{
    sealed class ApiLevelCheck : ProjectCheck
    {
        public ApiLevelCheck()
            : base(
                "API level is .NET Standard 2.1", "What the package is built and tested against, and the smaller app.",
                "Use .NET Standard 2.1") { }

        public override CheckResult Look(IProjectSettings project) => project.UsesNetStandard
            ? Good(".NET Standard 2.1")
            : new CheckResult(CheckState.Advice, ".NET Framework");

        public override string Fix(IProjectSettings project)
        {
            project.UsesNetStandard = true;
            return null;
        }
    }
}
