using System.Reflection;

namespace UnityEditor;

/// <summary>Finds the custom inspector that is declared for a component.</summary>
static class EditorTypes
{
    /// <summary>
    /// Returns the type of the inspector. This is the default inspector if none is declared, or if several objects are inspected and the declared
    /// inspector does not support several objects.
    /// </summary>
    internal static Type For(Type inspected, bool several)
    {
        var type = EditorAssemblies.Types
            .FirstOrDefault(t => t.GetCustomAttribute<CustomEditor>()?.InspectedType == inspected);
        return type == null || several && type.GetCustomAttribute<CanEditMultipleObjects>() == null ? typeof(Editor) : type;
    }
}
