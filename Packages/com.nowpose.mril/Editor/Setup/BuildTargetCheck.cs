namespace Nowpose.Editor.Setup
{
    sealed class BuildTargetCheck : ProjectCheck
    {
        public BuildTargetCheck(HeadsetPlatform platform)
            : base(
                "Build target is " + platform.Player, "Player of " + platform.Headset + "; the settings below belong to this player.",
                "Switch to " + platform.ShortPlayer)
        { }

        public override CheckResult Look(IProjectSettings project) => project.OtherTarget == null
            ? Good(project.Platform.Player)
            : Missing("the project is built for " + project.OtherTarget);

        public override string Fix(IProjectSettings project) => project.SwitchToPlatform()
            ? null
            : "Unity could not switch: add the module '" + project.Platform.Player + " Build Support' to this editor in Unity Hub.";
    }
}
