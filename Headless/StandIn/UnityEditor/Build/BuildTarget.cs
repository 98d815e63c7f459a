namespace UnityEditor;

public enum BuildTarget
{
    Android = 13,
    StandaloneWindows64 = 19,
    WSAPlayer = 21,
}
