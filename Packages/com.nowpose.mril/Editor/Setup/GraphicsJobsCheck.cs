using Nowpose.Editor.Messages;

namespace Nowpose.Editor.Setup
{
    /// <summary>Checks whether Graphics Jobs are off. If they are on, Unity distributes its rendering commands to worker threads.</summary>
    sealed class GraphicsJobsCheck : ProjectCheck
    {
        public GraphicsJobsCheck()
            : base(CheckTitles.GraphicsJobs,
                CheckReasons.GraphicsJobs, CheckTitles.TurnGraphicsJobsOff)
        { }

        public override CheckResult Look(IProjectSettings project)
        {
            switch (project.UsesGraphicsJobs)
            {
                case false: return Good("off");
                case true: return new CheckResult(CheckState.Advice, "on");
                default: return new CheckResult(CheckState.Unknown, CheckResults.OtherBuildTarget);
            }
        }

        public override string Fix(IProjectSettings project)
        {
            if (project.UsesGraphicsJobs == null) return CheckFixes.BuildTarget;
            project.TurnGraphicsJobsOff();
            return null;
        }
    }
}
