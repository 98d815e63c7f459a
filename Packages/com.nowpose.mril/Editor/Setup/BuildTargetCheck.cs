using Nowpose.Editor.Messages;

namespace Nowpose.Editor.Setup
{
    sealed class BuildTargetCheck : ProjectCheck
    {
        public BuildTargetCheck(HeadsetPlatform platform)
            : base(
                "Build target is " + platform.Player, CheckReasons.BuildTarget(platform.Headset),
                "Switch to " + platform.ShortPlayer)
        { }

        public override CheckResult Look(IProjectSettings project) => project.OtherTarget == null
            ? Good(project.Platform.Player)
            : Missing(CheckResults.BuildTarget(project.OtherTarget));

        public override string Fix(IProjectSettings project) => project.SwitchToPlatform()
            ? null
            : CheckFixes.BuildSupport(project.Platform.Player);
    }
}
