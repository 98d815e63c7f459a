using Nowpose.Editor.Messages;

namespace Nowpose.Editor.Setup
{
    sealed class RunInBackgroundCheck : ProjectCheck
    {
        public RunInBackgroundCheck()
            : base(CheckTitles.RunInBackground,
                CheckReasons.RunInBackground,
                CheckTitles.TurnRunInBackgroundOn)
        { }

        public override CheckResult Look(IProjectSettings project) => project.RunsInBackground
            ? Good("on")
            : new CheckResult(CheckState.Advice, "off");

        public override string Fix(IProjectSettings project)
        {
            project.RunsInBackground = true;
            return null;
        }
    }
}
