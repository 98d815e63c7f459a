namespace UnityEditor;

public enum BuildTargetGroup
{
    Standalone = 1,
    Android = 7,
    WSA = 14,
}
