namespace Nowpose.Editor.Setup
{
    sealed class FrameTimingCheck : ProjectCheck
    {
        public FrameTimingCheck()
            : base(
                "Frame Timing Stats are on",
                "They provide the GPU time per frame. Without them the render time is measured less accurately, and a limit of the "
                + "constant-latency range that was found with one source is not valid for another.",
                "Turn Frame Timing Stats on")
        { }

        public override CheckResult Look(IProjectSettings project) => project.FrameTimingStats ? Good("on") : Missing("off");

        public override string Fix(IProjectSettings project)
        {
            project.FrameTimingStats = true;
            return null;
        }
    }
}
