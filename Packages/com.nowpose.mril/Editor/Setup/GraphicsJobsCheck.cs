namespace Nowpose.Editor.Setup
{
    /// <summary>Checks whether Graphics Jobs are off. If they are on, Unity distributes its rendering commands to worker threads.</summary>
    sealed class GraphicsJobsCheck : ProjectCheck
    {
        public GraphicsJobsCheck()
            : base(
                "Graphics Jobs are off",
                "They change when a frame reaches the display, so a calibration of the visualisation latency is valid for one setting only. "
                + "Calibrate again after every change.", "Turn Graphics Jobs off")
        { }

        public override CheckResult Look(IProjectSettings project)
        {
            switch (project.UsesGraphicsJobs)
            {
                case false: return Good("off");
                case true: return new CheckResult(CheckState.Advice, "on");
                default: return new CheckResult(CheckState.Unknown, "Unity shows this setting for the active build target only; switch the build target first");
            }
        }

        public override string Fix(IProjectSettings project)
        {
            if (project.UsesGraphicsJobs == null) return "Switch the build target first.";
            project.TurnGraphicsJobsOff();
            return null;
        }
    }
}
