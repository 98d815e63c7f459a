using Nowpose.Editor.Messages;

namespace Nowpose.Editor.Setup
{
    sealed class ScriptingBackendCheck : ProjectCheck
    {
        public ScriptingBackendCheck(HeadsetPlatform platform)
            : base(CheckTitles.ScriptingBackend, CheckReasons.ScriptingBackend(platform.Headset), "Use IL2CPP") { }

        public override CheckResult Look(IProjectSettings project) => project.UsesIl2Cpp ? Good("IL2CPP") : Missing(CheckResults.ScriptingBackend);

        public override string Fix(IProjectSettings project)
        {
            project.UsesIl2Cpp = true;
            return null;
        }
    }
}
