namespace UnityEditor;

public sealed class EditorApplication
{
    public static CallbackFunction delayCall;
    public static CallbackFunction update;

    public static double timeSinceStartup => Now;

    /// <summary>Time since the start of the editor in s. Tests set it.</summary>
    internal static double Now { get; set; }

    /// <summary>Paths of the executed menu items. Items of Unity itself are only recorded.</summary>
    internal static List<string> MenuItems { get; } = new List<string>();

    public static bool ExecuteMenuItem(string menuItemPath)
    {
        MenuItems.Add(menuItemPath);
        var method = MenuItem.All.FirstOrDefault(item => item.Path == menuItemPath).Method;
        method?.Invoke(null, method.GetParameters().Length == 0 ? null : new object[] { new MenuCommand(null) });
        return true;
    }

    /// <summary>Runs the delayed calls. The editor does this after it has updated all windows.</summary>
    internal static void RunDelayed()
    {
        var due = delayCall;
        delayCall = null;
        due?.Invoke();
    }

    public delegate void CallbackFunction();
}
