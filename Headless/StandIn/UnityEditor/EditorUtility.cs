using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

public class EditorUtility
{
    /// <summary>What the user chooses in the next dialog; empty for cancelling it.</summary>
    internal static string Chosen { get; set; } = "";

    public static string OpenFilePanel(string title, string directory, string extension) => Chosen;

    /// <summary>Whether it lies in a file: of a hierarchy, whether it is in no scene.</summary>
    public static bool IsPersistent(Object target)
    {
        var gameObject = target is Component component ? component.gameObject : target as GameObject;
        return gameObject ? gameObject.Content == null : target is ScriptableObject;
    }
}
