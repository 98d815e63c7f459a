namespace Nowpose.Editor.Setup
{
    sealed class FrameTimingCheck : ProjectCheck
    {
        public FrameTimingCheck()
            : base(
                "Frame Timing Stats are on",
                "They give the GPU's time per frame. Without them the render time is measured more coarsely, and a limit of the "
                + "constant-latency range that was found with one source means nothing for another.",
                "Turn Frame Timing Stats on") { }

        public override CheckResult Look(IProjectSettings project) => project.FrameTimingStats ? Good("on") : Missing("off");

        public override string Fix(IProjectSettings project)
        {
            project.FrameTimingStats = true;
            return null;
        }
    }
}
