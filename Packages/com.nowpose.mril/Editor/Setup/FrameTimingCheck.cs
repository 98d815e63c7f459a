using Nowpose.Editor.Messages;

namespace Nowpose.Editor.Setup
{
    sealed class FrameTimingCheck : ProjectCheck
    {
        public FrameTimingCheck()
            : base(CheckTitles.FrameTiming,
                CheckReasons.FrameTiming,
                CheckTitles.TurnFrameTimingOn)
        { }

        public override CheckResult Look(IProjectSettings project) => project.FrameTimingStats ? Good("on") : Missing("off");

        public override string Fix(IProjectSettings project)
        {
            project.FrameTimingStats = true;
            return null;
        }
    }
}
