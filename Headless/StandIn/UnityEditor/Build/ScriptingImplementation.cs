namespace UnityEditor;

public enum ScriptingImplementation
{
    Mono2x = 0,
    IL2CPP = 1,
}
