namespace UnityEditor;

public class EditorUtility
{
    /// <summary>Path that the simulated user chooses in the next dialog; empty to cancel the dialog.</summary>
    internal static string Chosen { get; set; } = "";

    public static string OpenFilePanel(string title, string directory, string extension) => Chosen;

    /// <summary>Returns whether an object is stored in a file. In the stand-in, a GameObject that is not in a scene counts as stored.</summary>
    public static bool IsPersistent(Object target)
    {
        var gameObject = target is Component component ? component.gameObject : target as GameObject;
        return gameObject ? gameObject.Content == null : target is ScriptableObject;
    }
}
