namespace Nowpose.Editor.Setup
{
    sealed class ScriptingBackendCheck : ProjectCheck
    {
        public ScriptingBackendCheck(HeadsetPlatform platform)
            : base("Scripting backend is IL2CPP", "Nothing else runs on " + platform.Headset + ", whose processor is an ARM64.", "Use IL2CPP") { }

        public override CheckResult Look(IProjectSettings project) => project.UsesIl2Cpp ? Good("IL2CPP") : Missing("another backend is chosen");

        public override string Fix(IProjectSettings project)
        {
            project.UsesIl2Cpp = true;
            return null;
        }
    }
}
