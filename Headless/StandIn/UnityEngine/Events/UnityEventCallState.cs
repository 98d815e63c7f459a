namespace UnityEngine.Events;

public enum UnityEventCallState
{
    Off = 0,
    EditorAndRuntime = 1,
    RuntimeOnly = 2,
}
