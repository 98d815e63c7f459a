namespace UnityEditor;

public enum BuildTarget
{
    Android = 13,
    StandaloneWindows64 = 19,
    WSAPlayer = 21,
}

public enum BuildTargetGroup
{
    Standalone = 1,
    Android = 7,
    WSA = 14,
}
