using System.Collections.Generic;

namespace UnityEditor;

public sealed class EditorApplication
{
    public static CallbackFunction update;

    public static double timeSinceStartup => Now;

    /// <summary>Set by tests: no clock runs here.</summary>
    internal static double Now { get; set; }

    internal static List<string> MenuItems { get; } = new List<string>();

    public static bool ExecuteMenuItem(string menuItemPath)
    {
        MenuItems.Add(menuItemPath);
        return true;
    }

    public delegate void CallbackFunction();
}
