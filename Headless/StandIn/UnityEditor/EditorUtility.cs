using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

public class EditorUtility
{
    /// <summary>The user's choice in the next dialog; empty to cancel it.</summary>
    internal static string Chosen { get; set; } = "";

    public static string OpenFilePanel(string title, string directory, string extension) => Chosen;

    /// <summary>Whether the object is stored in a file; for an object in a hierarchy, whether it is not in a scene.</summary>
    public static bool IsPersistent(Object target)
    {
        var gameObject = target is Component component ? component.gameObject : target as GameObject;
        return gameObject ? gameObject.Content == null : target is ScriptableObject;
    }
}
