using Nowpose.Editor.Messages;

namespace Nowpose.Editor.Setup
{
    sealed class ApiLevelCheck : ProjectCheck
    {
        public ApiLevelCheck()
            : base(CheckTitles.ApiLevel, CheckReasons.ApiLevel,
                "Use .NET Standard 2.1")
        { }

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
