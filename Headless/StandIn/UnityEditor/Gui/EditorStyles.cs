namespace UnityEditor;

public sealed class EditorStyles
{
    public static GUIStyle boldLabel { get; } = new GUIStyle();
    public static GUIStyle helpBox { get; } = new GUIStyle();
    public static GUIStyle miniLabel { get; } = new GUIStyle();
    public static GUIStyle wordWrappedLabel { get; } = new GUIStyle();
    public static GUIStyle wordWrappedMiniLabel { get; } = new GUIStyle();
}
