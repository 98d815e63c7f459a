namespace Nowpose.Editor
{
    sealed class ScriptingBackendCheck : ProjectCheck
    {
        public ScriptingBackendCheck()
            : base("Scripting backend is IL2CPP", "The UWP player has no other that runs on a HoloLens.", "Use IL2CPP") { }

        public override CheckResult Look(IProjectSettings project) => project.UsesIl2Cpp ? Good("IL2CPP") : Missing("another backend is chosen");

        public override string Fix(IProjectSettings project)
        {
            project.UsesIl2Cpp = true;
            return null;
        }
    }
}
