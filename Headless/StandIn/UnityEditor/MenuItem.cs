using System.Reflection;

namespace UnityEditor;

[AttributeUsage(AttributeTargets.Method, AllowMultiple = true)]
public sealed class MenuItem(string itemName, bool isValidateFunction, int priority) : Attribute
{
    public string menuItem = itemName;
    public bool validate = isValidateFunction;
    public int priority = priority;

    public MenuItem(string itemName) : this(itemName, false) { }

    public MenuItem(string itemName, bool isValidateFunction) : this(itemName, isValidateFunction, 1000) { }

    /// <summary>The menu items of the project, with their methods.</summary>
    internal static IEnumerable<(string Path, MethodInfo Method)> All =>
        from type in EditorAssemblies.Types
        from method in type.GetMethods(BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic)
        from item in method.GetCustomAttributes<MenuItem>()
        select (item.menuItem, method);
}
