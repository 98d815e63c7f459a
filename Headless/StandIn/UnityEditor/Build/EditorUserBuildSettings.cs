using UnityEditor.Build;

namespace UnityEditor;

public class EditorUserBuildSettings : Object
{
    EditorUserBuildSettings() { }

    public static BuildTarget activeBuildTarget { get; private set; } = BuildTarget.StandaloneWindows64;
    public static string wsaArchitecture { get; set; } = "x64";

    /// <summary>Whether the UWP module of the editor is installed.</summary>
    internal static bool HasUwp { get; set; } = true;

    public static bool SwitchActiveBuildTarget(NamedBuildTarget namedBuildTarget, BuildTarget target)
    {
        if (target == BuildTarget.WSAPlayer && !HasUwp) return false;
        activeBuildTarget = target;
        return true;
    }

    /// <summary>Resets all settings to the values in a new project.</summary>
    internal static void Reset()
    {
        activeBuildTarget = BuildTarget.StandaloneWindows64;
        wsaArchitecture = "x64";
        HasUwp = true;
    }
}
