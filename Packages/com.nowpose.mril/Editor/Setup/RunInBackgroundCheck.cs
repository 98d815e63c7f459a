namespace Nowpose.Editor.Setup
{
    sealed class RunInBackgroundCheck : ProjectCheck
    {
        public RunInBackgroundCheck()
            : base(
                "Run In Background is on",
                "Otherwise the session ends whenever the system's menu opens, and must synchronise its clock again.",
                "Turn Run In Background on")
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
