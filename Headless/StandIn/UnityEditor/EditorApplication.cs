using System.Collections.Generic;

namespace UnityEditor;

public sealed class EditorApplication
{
    public static CallbackFunction delayCall;
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

    /// <summary>As the editor does once, when it has done with all windows.</summary>
    internal static void RunDelayed()
    {
        var due = delayCall;
        delayCall = null;
        due?.Invoke();
    }

    public delegate void CallbackFunction();
}
