namespace UnityEditor;

public enum BuildTarget
{
    StandaloneOSX = 2,
    StandaloneWindows = 5,
    iOS = 9,
    Android = 13,
    StandaloneWindows64 = 19,
    WebGL = 20,
    WSAPlayer = 21,
    StandaloneLinux64 = 24,
    PS4 = 31,
    XboxOne = 33,
    tvOS = 37,
    Switch = 38,
    Stadia = 40,
    LinuxHeadlessSimulation = 41,
    GameCoreXboxSeries = 42,
    GameCoreXboxOne = 43,
    PS5 = 44,
    EmbeddedLinux = 45,
    NoTarget = -2,
}
