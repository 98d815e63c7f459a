using UnityEditor;

namespace Nowpose.Editor
{
    sealed class BuildTargetCheck : ProjectCheck
    {
        public BuildTargetCheck()
            : base(
                "Build target is the Universal Windows Platform", "A HoloLens runs UWP apps; the settings below are those of that player.",
                "Switch to UWP") { }

        public override CheckResult Look(IProjectSettings project) => project.BuildTarget == BuildTarget.WSAPlayer
            ? Good("Universal Windows Platform")
            : Missing("the project is built for " + project.BuildTarget);

        public override string Fix(IProjectSettings project) => project.SwitchTo(BuildTarget.WSAPlayer)
            ? null
            : "Unity could not switch: add the module 'Universal Windows Platform Build Support' to this editor in Unity Hub.";
    }
}
