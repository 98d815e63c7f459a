namespace UnityEditor;

public enum BuildTargetGroup
{
    Unknown = 0,
    Standalone = 1,
    iOS = 4,
    Android = 7,
    WebGL = 13,
    WSA = 14,
    PS4 = 19,
    XboxOne = 21,
    tvOS = 25,
    Switch = 27,
    Stadia = 29,
    LinuxHeadlessSimulation = 30,
    GameCoreXboxSeries = 31,
    GameCoreXboxOne = 32,
    PS5 = 33,
    EmbeddedLinux = 34,
}
