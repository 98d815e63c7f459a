namespace Nowpose.Editor.Setup
{
    sealed class ScriptingBackendCheck : ProjectCheck
    {
        public ScriptingBackendCheck(HeadsetPlatform platform)
            : base("Scripting backend is IL2CPP", "It is the only backend for the ARM64 processor of " + platform.Headset + ".", "Use IL2CPP") { }

        public override CheckResult Look(IProjectSettings project) => project.UsesIl2Cpp ? Good("IL2CPP") : Missing("another backend is chosen");

        public override string Fix(IProjectSettings project)
        {
            project.UsesIl2Cpp = true;
            return null;
        }
    }
}
