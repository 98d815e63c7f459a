using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

public class EditorUtility
{
    /// <summary>Whether it lies in a file: of a hierarchy, whether it is in no scene.</summary>
    public static bool IsPersistent(Object target)
    {
        var gameObject = target is Component component ? component.gameObject : target as GameObject;
        return gameObject ? gameObject.Content == null : target is ScriptableObject;
    }
}
